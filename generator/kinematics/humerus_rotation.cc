// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/humerus_rotation.h"

namespace girdle {

// Sine and cosine of half of theta and half of tau are computed side by side.
QuaternionOf<double> HumerusRotation(double theta_rad, double psi_rad, double tau_rad) noexcept {
  const SineAndCosine<Pair> half = SineAndCosineOf(Pair(0.5 * theta_rad, 0.5 * tau_rad));
  const SineAndCosine<double> across = SineAndCosineOf(psi_rad - 0.5 * tau_rad);
  return {half.cosine[0] * half.cosine[1], -(half.sine[0] * across.cosine),
          half.cosine[0] * half.sine[1], half.sine[0] * across.sine};
}

}  // namespace girdle
