// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The rotation of the humerus in the thorax, from its direction and its turn.
#pragma once

#include "kinematics/rotation_algebra.h"

namespace girdle {

/// Returns the humerus in the thorax that points in the direction (theta, psi) and is turned by tau
/// about its long axis:
///
///     q_TH = S(theta, psi) Ry(tau)
///
/// S is the smallest rotation that takes the hanging arm (-y) to the direction. In ISB angles q_TH
/// is Y(psi) X(-theta) Y(tau - psi). T is a scalar of jet.h.
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

/// HumerusRotation for numbers, in less time. Precondition: the angles are finite and not larger
/// than a few turns.
[[nodiscard]] QuaternionOf<double> HumerusRotation(double theta_rad, double psi_rad,
                                                   double tau_rad) noexcept;

}  // namespace girdle
