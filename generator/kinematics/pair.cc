// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/pair.h"

#include <numbers>

namespace girdle {
namespace {

// atan(t z) = 2 sum (-1)^k p^(2k+1) / (2k+1) T_(2k+1)(z), t = tan(2a), p = tan(a), for -1 <= z <= 1
// and T the Chebyshev polynomials (generating function of the arc tangent). With 2a = pi/8 the
// first term left out is below 1e-17.
constexpr std::size_t kArcTangentTerms = 12;
constexpr double kTangentOfEighth = 0.41421356237309504880;     // tan(pi/8) = sqrt(2) - 1
constexpr double kTangentOfSixteenth = 0.19891236737965800691;  // tan(pi/16)

/// Coefficients of atan(x) / x in powers of x^2, for |x| <= tan(pi/8).
constexpr std::array<double, kArcTangentTerms> ArcTangentCoefficients() {
  constexpr std::size_t kOrder = 2 * kArcTangentTerms;
  using Powers = std::array<long double, kOrder>;  // of z
  Powers before{1};                                // T_0
  Powers chebyshev{0, 1};                          // T_1
  Powers sum{};
  long double weight = 2 * static_cast<long double>(kTangentOfSixteenth);
  for (std::size_t n = 1; n < kOrder; n += 2) {
    for (std::size_t i = 0; i < kOrder; ++i) {
      sum[i] += weight / static_cast<long double>(n) * chebyshev[i];
    }
    weight *= -static_cast<long double>(kTangentOfSixteenth) *
              static_cast<long double>(kTangentOfSixteenth);
    for (int step = 0; step < 2; ++step) {  // T_(n+1) = 2 z T_n - T_(n-1)
      Powers next{};
      for (std::size_t i = 0; i < kOrder; ++i) {
        next[i] = (i > 0 ? 2 * chebyshev[i - 1] : 0) - before[i];
      }
      before = chebyshev;
      chebyshev = next;
    }
  }
  std::array<double, kArcTangentTerms> coefficients{};
  long double scale = static_cast<long double>(kTangentOfEighth);
  for (std::size_t k = 0; k < kArcTangentTerms; ++k) {
    coefficients[k] = static_cast<double>(sum[2 * k + 1] / scale);
    scale *=
        static_cast<long double>(kTangentOfEighth) * static_cast<long double>(kTangentOfEighth);
  }
  return coefficients;
}

constexpr auto kArcTangent = ArcTangentCoefficients();

}  // namespace

Pair Atan2(Pair y, Pair x) noexcept {
  constexpr double kQuarter = std::numbers::pi / 4;
  const auto absolute = [](Pair a) { return Pair::WhereLess(a, 0.0, -a, a); };
  const Pair width = absolute(x);
  const Pair height = absolute(y);
  const Pair smaller = Pair::WhereLess(height, width, height, width);
  const Pair larger = Pair::WhereLess(height, width, width, height);
  // Between tan(pi/8) and 1: atan(a) = pi/4 + atan((a - 1) / (a + 1)).
  const Pair limit = kTangentOfEighth * larger;
  const Pair top = Pair::WhereLess(limit, smaller, smaller - larger, smaller);
  const Pair bottom = Pair::WhereLess(limit, smaller, smaller + larger, larger);
  const Pair offset = Pair::WhereLess(limit, smaller, kQuarter, 0.0);
  const Pair ratio = top / Pair::WhereLess(0.0, bottom, bottom, 1.0);
  const Pair octant = offset + ratio * PolynomialValue(kArcTangent, ratio * ratio);
  const Pair quadrant = Pair::WhereLess(width, height, 2 * kQuarter - octant, octant);
  const Pair half = Pair::WhereLess(x, 0.0, 4 * kQuarter - quadrant, quadrant);
  return Pair::WhereLess(y, 0.0, -half, half);
}

}  // namespace girdle
