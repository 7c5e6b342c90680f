// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Directions of the arm in the thorax: which ones an arm can reach, and how far one is from those
/// that were measured.
#pragma once

#include "kinematics/rotation_algebra.h"

namespace girdle {

/// A rectangle of elevations and planes [rad].
struct ArmRectangle {
  double lowest_elevation_rad;
  double highest_elevation_rad;
  double first_plane_rad;
  double last_plane_rad;

  /// Its edges belong to it; a NaN does not.
  [[nodiscard]] bool Holds(double elevation_rad, double plane_rad) const noexcept {
    return elevation_rad >= lowest_elevation_rad && elevation_rad <= highest_elevation_rad &&
           plane_rad >= first_plane_rad && plane_rad <= last_plane_rad;
  }
};

/// The lowest plane [rad] that an arm reaches at an elevation, and how it changes with it.
///
/// Behind the frontal plane the glenohumeral flexion runs away: -57 deg at (elevation 90, plane
/// -30), -87 at (90, -60), where no shoulder goes and X-Z'-Y'' hinges lock. So: -60 up to elevation
/// 60, a straight line to -30 at 85, -30 above.
struct LowestPlane {
  double plane_rad;
  double slope;  ///< by elevation [rad/rad]
};
[[nodiscard]] LowestPlane LowestPlaneAt(double elevation_rad) noexcept;

/// The last plane [rad] that an arm reaches: across the chest.
inline constexpr double kHighestPlane_rad = 135 * kRadiansPerDegree;

/// Returns the angle [rad] between the direction (elevation, plane) and the nearest direction of a
/// rectangle; 0 inside. The rectangle has elevations in [0, pi] and planes less than a turn apart;
/// the elevation is taken into [0, pi].
[[nodiscard]] double AngleFromRectangle(const ArmRectangle& rectangle, double elevation_rad,
                                        double plane_rad) noexcept;

/// Humerus in thorax with the direction (theta, psi), turned by tau about its long axis:
///
///     q_TH = S(theta, psi) Ry(tau),  S the smallest rotation that takes the hanging arm (-y) there
///
/// In ISB angles it is Y(psi) X(-theta) Y(tau - psi). T is a scalar of jet.h.
template <typename T>
[[nodiscard]] QuaternionOf<T> HumerusRotation(const T& theta_rad, const T& psi_rad,
                                              const T& tau_rad) noexcept {
  const T half_tau = 0.5 * tau_rad;
  const SineAndCosine<T> theta = SineAndCosineOf(T(0.5 * theta_rad));
  const SineAndCosine<T> tau = SineAndCosineOf(half_tau);
  const SineAndCosine<T> across = SineAndCosineOf(T(psi_rad - half_tau));
  return {theta.cosine * tau.cosine, -(theta.sine * across.cosine), theta.cosine * tau.sine,
          theta.sine * across.sine};
}

/// The same for numbers, in less time. Precondition: the angles are finite and of some turns at
/// most.
[[nodiscard]] QuaternionOf<double> HumerusRotation(double theta_rad, double psi_rad,
                                                   double tau_rad) noexcept;

}  // namespace girdle
