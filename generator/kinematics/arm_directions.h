// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Directions of the arm in the thorax, and their distance from the measured ones.
#pragma once

#include "kinematics/rotation.h"

namespace girdle {

/// A direction of the arm. T is a number or a jet.
template <typename T>
struct ArmDirectionOf {
  T elevation_rad;
  T plane_rad;
};

/// A rectangle of elevations and planes [rad].
struct ArmRectangle {
  double lowest_elevation_rad;
  double highest_elevation_rad;
  double first_plane_rad;
  double last_plane_rad;

  /// Returns whether a direction is in the rectangle. The edges belong to it. A NaN is outside.
  [[nodiscard]] bool Holds(double elevation_rad, double plane_rad) const noexcept {
    return elevation_rad >= lowest_elevation_rad && elevation_rad <= highest_elevation_rad &&
           plane_rad >= first_plane_rad && plane_rad <= last_plane_rad;
  }
};

/// Returns the angle [rad] between the direction (elevation, plane) and the nearest direction of a
/// rectangle; 0 inside. Precondition: the rectangle has elevations in [0, pi] and planes less than
/// a turn apart. The direction may have any finite angles: (-e, p) is (e, p + pi).
[[nodiscard]] double AngleFromRectangle(const ArmRectangle& rectangle, double elevation_rad,
                                        double plane_rad) noexcept;

}  // namespace girdle
