// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The directions that an arm reaches, and which of them answers a direction that it does not.
#pragma once

#include "kinematics/arm_directions.h"
#include "kinematics/rotation.h"

namespace girdle {

/// The reach on the sphere of directions, from hanging (elevation 0) to straight up (180):
///
/// - in front and across the chest to plane 135;
/// - behind the body to plane -95, up to elevation 62.5;
/// - above that, to a circle of 45 deg about a direction that no arm takes, (107.5, -77.9), from
///   its lowest direction, (62.5, -77.9), to where it touches plane -30, at elevation 115;
/// - above that, to plane -30.
///
/// Behind the frontal plane above it the glenohumeral flexion runs away: -57 deg at (90, -30), -87
/// at (90, -60), where no shoulder goes and X-Z'-Y'' hinges lock.
///
/// What is not reached is answered by the nearest direction that is, as far as 20 deg from the
/// reach and wherever a single one is clearly nearest: n below. Where two compete, in the wedge
/// that ends at hanging between planes 135 and -95, and farther away, the answer passes over to a
/// direction in the middle of the reach, h:
///
///   answer = n + V (h - n),   in (elevation, plane)
///   1 - V  = (1 - Bump(|s| / 0.25) Bump((theta - 55) / 60)) Bump((distance - 20) / 24)
///   h      = (theta (1 - (1 - cos 65) Bump((theta - 90) / 90)), 20)
///
/// with Bump(x) = 1 - 10 x^3 + 15 x^4 - 6 x^5, 1 below 0 and 0 above 1, and s from -1 at plane 135
/// over 0 in the middle of the wedge to 1 at plane -95. Straight up every plane is the same
/// direction, but the humerus turns with the plane: where n is straight up, between planes 225 and
/// 240, its plane is
///
///   -30 + 165 Bump((plane - 225) / 15)
///
/// The answer is continuous everywhere: n jumps only where V is 1. It changes by less than 11 deg
/// per degree.
///
/// A table that begins behind plane -30 has its own first plane in place of that. Then the limits
/// compete straight up as well, and 1 - V has one more factor, with t from -1 to 1 between plane
/// 135 and the table's first as s above:
///
///   1 - Bump(|t| / 0.25) (1 - Bump((theta - 55) / 60))
///
/// Such an answer changes by less than 17 deg per degree.
class ArmReach {
 public:
  /// Of a table whose first plane is `first_plane_rad`: planes from there on are reached at every
  /// elevation.
  explicit ArmReach(double first_plane_rad = kFreePlane_rad) noexcept;

  static constexpr double kFirstPlane_rad = -95 * kRadiansPerDegree;  ///< behind the body
  static constexpr double kFreePlane_rad = -30 * kRadiansPerDegree;   ///< at every elevation
  static constexpr double kLastPlane_rad = 135 * kRadiansPerDegree;   ///< across the chest

  /// The lowest plane that is reached at an elevation in [0, pi] [rad]; at a NaN, at 0. It never
  /// falls with elevation, and jumps where the circle begins.
  [[nodiscard]] double LowestPlaneAt(double elevation_rad) const noexcept;

  /// The direction that answers one that is not reached. Elevation in [0, pi], the plane within
  /// half a turn of the middle of the reach, 20 deg; T is double or a Jet, whose derivatives go
  /// through.
  template <typename T>
  [[nodiscard]] ArmDirectionOf<T> AnswerTo(const ArmDirectionOf<T>& direction) const noexcept;

 private:
  enum class Piece { kInFront, kBehind, kBelow, kCircle, kAbove };
  [[nodiscard]] Piece NearestPieceTo(const ArmDirectionOf<double>& direction) const noexcept;
  template <typename T>
  [[nodiscard]] ArmDirectionOf<T> FootOn(Piece piece,
                                         const ArmDirectionOf<T>& direction) const noexcept;
  template <typename T>
  [[nodiscard]] ArmDirectionOf<T> OnCircle(const ArmDirectionOf<T>& direction) const noexcept;
  template <typename T>
  [[nodiscard]] T PlaneStraightUp(const T& plane_rad) const noexcept;
  /// The plane midway between the last one and the free one, on the far side.
  [[nodiscard]] double OppositeAbove_rad() const noexcept {
    return (kLastPlane_rad + free_plane_rad_) / 2 + kPi;
  }

  double free_plane_rad_;
  double centre_plane_rad_;      ///< of the circle
  double corner_elevation_rad_;  ///< where the first plane ends
  double touch_elevation_rad_;   ///< where it touches the free one
};

}  // namespace girdle
