// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/arm_directions.h"

#include <algorithm>
#include <cmath>

#include "kinematics/direction_algebra.h"

namespace girdle {

double AngleFromRectangle(const ArmRectangle& rectangle, double elevation_rad,
                          double plane_rad) noexcept {
  // An elevation below 0 or above pi is a direction in the opposite plane.
  const double signed_rad = std::remainder(elevation_rad, 2 * kPi);
  const double theta = std::abs(signed_rad);
  if (signed_rad < 0) {
    plane_rad += kPi;
  }
  const double lowest = rectangle.lowest_elevation_rad;
  const double highest = rectangle.highest_elevation_rad;
  // The plane relative to the middle of the rectangle's planes, in [-pi, pi].
  const double middle = (rectangle.first_plane_rad + rectangle.last_plane_rad) / 2;
  const double half_width = (rectangle.last_plane_rad - rectangle.first_plane_rad) / 2;
  const double beyond = std::abs(std::remainder(plane_rad - middle, 2 * kPi)) - half_width;
  if (!(beyond > 0)) {
    return std::max({lowest - theta, theta - highest, 0.0});
  }
  // The nearest direction lies on the edge plane, `beyond` away.
  const ArmDirectionOf<double> direction = {theta, rectangle.last_plane_rad + beyond};
  return AngleBetween(direction,
                      NearestOnPlane(direction, rectangle.last_plane_rad, lowest, highest));
}

}  // namespace girdle
