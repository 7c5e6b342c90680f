// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The directions that an arm reaches, and which of them answers a direction that it does not.
#pragma once

#include "kinematics/arm_directions.h"
#include "kinematics/rotation.h"

namespace girdle {

/// The reach on the sphere of directions, from hanging (elevation 0) to straight up (180).
/// Directions are (elevation, plane) [deg] in this comment. A direction is reached if its plane is
///
/// - in front and across the chest: at most 135;
/// - behind the body, up to elevation 62.5: at least -95;
/// - above that: outside a circle of 45 deg about (107.5, -77.9), a direction that no arm takes.
///   The circle limits the reach from its lowest direction, (62.5, -77.9), to (115, -30), where it
///   touches plane -30;
/// - above elevation 115: at least -30.
///
/// The limits keep glenohumeral flexion small: behind the frontal plane it is -57 deg at (90, -30)
/// and -87 deg at (90, -60), where no shoulder goes and X-Z'-Y'' hinges lock.
///
/// theta is the elevation [deg] of the commanded direction, plane its plane [deg], and distance the
/// angle [deg] between it and n, the nearest reached direction. The answer to a direction that is
/// not reached is usually n. It is n if n is at most 20 deg away and no second direction competes.
/// Two directions compete in the wedge that ends at hanging, between planes 135 and -95. In the
/// middle of the wedge and farther from the reach the answer passes over to h, a direction in the
/// middle of the reach:
///
///   answer = n + V (h - n),   in (elevation, plane), with V from 0 to 1
///   1 - V  = (1 - Bump(|s| / 0.25) Bump((theta - 55) / 60)) Bump((distance - 20) / 24)
///   h      = (theta (1 - (1 - cos(65 deg)) Bump((theta - 90) / 90)), 20)
///
/// Bump(x) = 1 - 10 x^3 + 15 x^4 - 6 x^5 falls from 1 (below x = 0) to 0 (above x = 1). s is -1 at
/// plane 135, 0 in the middle of the wedge and 1 at plane -95. Straight up every plane is the same
/// direction, but the humerus turns with the plane. Where n is straight up, between planes 225 and
/// 240, its plane is therefore
///
///   -30 + 165 Bump((plane - 225) / 15)
///
/// The answer is continuous everywhere, because n jumps only where V is 1. It changes by less than
/// 11 deg per degree.
///
/// If a table begins behind plane -30, its own first plane replaces -30. Then two directions
/// compete straight up as well, and 1 - V has one more factor. t goes from -1 at plane 135 to 1 at
/// the table's first plane, as s does in the wedge:
///
///   1 - Bump(|t| / 0.25) (1 - Bump((theta - 55) / 60))
///
/// Such an answer changes by less than 17 deg per degree.
class ArmReach {
 public:
  /// `first_plane_rad` is the first plane of the table. Planes from there on are reached at every
  /// elevation.
  explicit ArmReach(double first_plane_rad = kFreePlane_rad) noexcept;

  static constexpr double kFirstPlane_rad = -95 * kRadiansPerDegree;  ///< behind the body
  static constexpr double kFreePlane_rad = -30 * kRadiansPerDegree;   ///< at every elevation
  static constexpr double kLastPlane_rad = 135 * kRadiansPerDegree;   ///< across the chest

  /// Returns the lowest plane [rad] that is reached at an elevation in [0, pi]. A NaN counts as 0.
  /// The result never falls with elevation, and it jumps where the circle begins.
  [[nodiscard]] double LowestPlaneAt(double elevation_rad) const noexcept;

  /// Returns the direction that answers one that is not reached. Precondition: elevation in [0,
  /// pi], plane within half a turn of 20 deg, the middle of the reach. T is double or a Jet; a
  /// Jet's derivatives are kept.
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
  /// The plane opposite to the middle between the last plane and the free plane.
  [[nodiscard]] double OppositeAbove_rad() const noexcept {
    return (kLastPlane_rad + free_plane_rad_) / 2 + kPi;
  }

  double free_plane_rad_;
  double centre_plane_rad_;      ///< of the circle
  double corner_elevation_rad_;  ///< where the circle meets the first plane
  double touch_elevation_rad_;   ///< where the circle touches the free plane
};

}  // namespace girdle
