// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/humerus_rotation.h"

#include <array>
#include <cstddef>

namespace girdle {
namespace {

// For angles up to an eighth of a turn.
constexpr auto kCosine = rotation_algebra_detail::AlternatingSeries<9>(0);
constexpr auto kSine = rotation_algebra_detail::AlternatingSeries<8>(1);
// pi/2 in two parts, the first with a short significand, so that small multiples of it are exact.
constexpr double kQuarterTurnHigh = 1.5707963109016418;
constexpr double kQuarterTurnLow = 1.5893254773528196e-08;

// Of two angles.
struct SinesAndCosines {
  Pair sine;
  Pair cosine;
};

// With x = n pi/2 + r, |r| <= pi/4, the series of r, changed places and signs by the quadrant n.
[[gnu::noinline]] SinesAndCosines SineAndCosine(Pair x) noexcept {
  const Pair n = Pair::Rounded((2 / kPi) * x);
  const Pair r = (x - kQuarterTurnHigh * n) - kQuarterTurnLow * n;
  const Pair square = r * r;
  const Pair sine = r * PolynomialValue(kSine, square);
  const Pair cosine = PolynomialValue(kCosine, square);
  const auto one = [&](std::size_t i) -> std::array<double, 2> {
    const auto quadrant = static_cast<long long>(n[i]) & 3;
    const double along = (quadrant & 1) != 0 ? cosine[i] : sine[i];
    const double across = (quadrant & 1) != 0 ? sine[i] : cosine[i];
    return {(quadrant & 2) != 0 ? -along : along,
            quadrant == 1 || quadrant == 2 ? -across : across};
  };
  const auto first = one(0);
  const auto second = one(1);
  return {{first[0], second[0]}, {first[1], second[1]}};
}

}  // namespace

// Both to 2 units in the last place of 1 for angles of some turns, which is all that an arm has.
QuaternionOf<double> HumerusRotation(double theta_rad, double psi_rad, double tau_rad) noexcept {
  const SinesAndCosines half = SineAndCosine(Pair(0.5 * theta_rad, 0.5 * tau_rad));
  const SinesAndCosines across = SineAndCosine(Pair(psi_rad - 0.5 * tau_rad));
  return {half.cosine[0] * half.cosine[1], -(half.sine[0] * across.cosine[0]),
          half.cosine[0] * half.sine[1], half.sine[0] * across.sine[0]};
}

}  // namespace girdle
