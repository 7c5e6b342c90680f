// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Euler angles about three different axes over the scalars of jet.h.
#pragma once

#include "kinematics/rotation_algebra.h"

namespace girdle {

/// Returns the equal angle in (-pi, pi]. Precondition: `angle_rad` is within two turns.
[[nodiscard]] inline double WithinHalfTurn(double angle_rad) noexcept {
  if (angle_rad > kPi) {
    return angle_rad - 2 * kPi;
  }
  return angle_rad <= -kPi ? angle_rad + 2 * kPi : angle_rad;
}
[[nodiscard]] inline Pair WithinHalfTurn(Pair angle_rad) noexcept {
  const Pair lowered = Pair::WhereLess(kPi, angle_rad, angle_rad - 2 * kPi, angle_rad);
  return Pair::WhereLess(-kPi, lowered, lowered, lowered + 2 * kPi);
}
template <int Order>
[[nodiscard]] Jet<double, Order> WithinHalfTurn(Jet<double, Order> angle_rad) noexcept {
  angle_rad.part[kValue] = WithinHalfTurn(angle_rad.part[kValue]);
  return angle_rad;
}

/// Returns the three angles [rad] of a unit quaternion. They are in turning order, about the axes
/// 1, 2, 3 that q_1, q_2, q_3 belong to. Precondition: w is not negative, and the axes are cyclic
/// in the order 3, 2, 1.
///
/// Source: Bernardes and Viollet, Quaternion to Euler angles conversion, PLoS ONE 2022;17:e0276302.
/// Let (a, b, c) be the angles in turning order. The half sum and the half difference of a and c
/// are separate:
///
///     w - q_2 : q_3 + q_1 = cos : sin of (a+c)/2,    q_2 + w : q_1 - q_3 = cos : sin of (a-c)/2
///
/// The lengths s and d of these two vectors give the second angle: sin b = (d^2 - s^2) / 2, cos b =
/// s d. If s or d is zero (gimbal lock), the other one still gives the rotation.
template <typename T>
[[nodiscard]] VectorOf<T> EulerAngles(const T& w, const T& q_1, const T& q_2,
                                      const T& q_3) noexcept {
  const T sum_cosine = w - q_2;
  const T sum_sine = q_3 + q_1;
  const T difference_cosine = q_2 + w;
  const T difference_sine = q_1 - q_3;
  const T half_sum = Atan2(sum_sine, sum_cosine);
  const T half_difference = Atan2(difference_sine, difference_cosine);
  const T s_squared = sum_sine * sum_sine + sum_cosine * sum_cosine;
  const T d_squared = difference_sine * difference_sine + difference_cosine * difference_cosine;
  return {WithinHalfTurn(half_sum + half_difference),
          Atan2(0.5 * (d_squared - s_squared), Sqrt(s_squared * d_squared)),
          WithinHalfTurn(half_sum - half_difference)};
}

}  // namespace girdle
