// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Angles between directions of the arm, over the scalars of jet.h.
#pragma once

#include <cmath>

#include "kinematics/arm_directions.h"
#include "kinematics/jet.h"

namespace girdle {

/// Returns the angle between two directions [rad], in [0, pi]. The haversine formula is precise
/// also for small angles:
///
///     h = sin^2((e_a - e_b) / 2) + sin e_a sin e_b sin^2((psi_a - psi_b) / 2),
///     angle = 2 arctan(sqrt h / sqrt(1 - h))
template <typename T>
[[nodiscard]] T AngleBetween(const ArmDirectionOf<T>& a, const ArmDirectionOf<T>& b) noexcept {
  const T half_elevation = SineAndCosineOf(T(0.5 * (a.elevation_rad - b.elevation_rad))).sine;
  const T half_plane = SineAndCosineOf(T(0.5 * (a.plane_rad - b.plane_rad))).sine;
  const T h = half_elevation * half_elevation + SineAndCosineOf(a.elevation_rad).sine *
                                                    SineAndCosineOf(b.elevation_rad).sine *
                                                    half_plane * half_plane;
  // Rounding may make h of opposite directions larger than 1.
  return ValueOf(h) < 1 ? T(2.0 * Atan2(Sqrt(h), Sqrt(T(1.0) - h))) : T(kPi);
}

/// Returns the direction of a plane that is nearest to another direction. Its elevation is in
/// [lowest, highest] [rad].
template <typename T>
[[nodiscard]] ArmDirectionOf<T> NearestOnPlane(const ArmDirectionOf<T>& direction, double plane_rad,
                                               double lowest_rad, double highest_rad) noexcept {
  // Along the plane the cosine of the angle is cos(theta) cos(e) + sin(theta) sin(e) cos(beside),
  // largest at this elevation e.
  const auto [sine, cosine] = SineAndCosineOf(direction.elevation_rad);
  const T beside = SineAndCosineOf(T(direction.plane_rad - T(plane_rad))).cosine;
  const T along = Atan2(T(sine * beside), cosine);
  const double e = ValueOf(along);
  if (e >= lowest_rad && e <= highest_rad) {
    return {along, T(plane_rad)};
  }
  const bool is_lowest_nearer = std::cos(e - lowest_rad) > std::cos(e - highest_rad);
  return {T(is_lowest_nearer ? lowest_rad : highest_rad), T(plane_rad)};
}

}  // namespace girdle
