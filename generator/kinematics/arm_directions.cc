// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/arm_directions.h"

#include <algorithm>
#include <cmath>

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
  // The plane from the middle of the rectangle's, in [-pi, pi].
  const double middle = (rectangle.first_plane_rad + rectangle.last_plane_rad) / 2;
  const double half_width = (rectangle.last_plane_rad - rectangle.first_plane_rad) / 2;
  const double beyond = std::abs(std::remainder(plane_rad - middle, 2 * kPi)) - half_width;
  if (!(beyond > 0)) {
    return std::max({lowest - theta, theta - highest, 0.0});
  }
  // The nearest direction lies on the edge plane, `beyond` away. Along it the cosine of the angle
  // is cos(theta) cos(e) + sin(theta) sin(e) cos(beyond), largest at this elevation e.
  const double along = std::atan2(std::sin(theta) * std::cos(beyond), std::cos(theta));
  const double end = std::cos(along - lowest) < std::cos(along - highest) ? highest : lowest;
  const double e = along > lowest && along < highest ? along : end;
  const double sine_half_e = std::sin((theta - e) / 2);
  const double sine_half_b = std::sin(beyond / 2);
  // Haversine formula: precise for small angles.
  const double h =
      sine_half_e * sine_half_e + std::sin(theta) * std::sin(e) * sine_half_b * sine_half_b;
  return 2 * std::asin(std::min(std::sqrt(h), 1.0));
}

}  // namespace girdle
