// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Sine, cosine, arc tangent and exponential decay of several numbers at the same time.
///
/// They consist of sums, products, quotients and choices only, which every machine rounds alike. A
/// number therefore has the same result in a Pair, in a Four and on any processor. L is Pair or
/// Four. Both have arithmetic, Rounded, WhereLess, TurnByQuarters and PowersOfTwo.
#pragma once

#include <array>
#include <cstddef>
#include <numbers>

#include "kinematics/pair.h"

namespace girdle {

namespace lane_functions_detail {

// shift! sum (-x)^n / (2n + shift)!. It is cos(sqrt x) for shift 0 and sin(sqrt x)/sqrt x for shift
// 1.
template <std::size_t N>
constexpr std::array<double, N> AlternatingSeries(int shift) {
  std::array<double, N> coefficients{};
  long double term = 1;
  for (std::size_t n = 0; n < N; ++n) {
    coefficients[n] = static_cast<double>(term);
    const long double factor = 2 * static_cast<long double>(n) + shift + 1;
    term /= -factor * (factor + 1);
  }
  return coefficients;
}

// For angles up to an eighth of a turn.
inline constexpr auto kCosine = AlternatingSeries<9>(0);
inline constexpr auto kSine = AlternatingSeries<8>(1);
// pi/2 in two parts. The first has a short significand, so small multiples of it are exact.
inline constexpr double kQuarterTurnHigh = 1.5707963109016418;
inline constexpr double kQuarterTurnLow = 1.5893254773528196e-08;

// ln 2 in two parts. The first is ln 2 rounded to 32 binary places, so small multiples of it are
// exact. The second is written out, because in libc++ std::numbers::ln2_v<long double> is no more
// precise than a double.
inline constexpr double kLogarithmOfTwoHigh = 2977044472.0 / 4294967296.0;
inline constexpr double kLogarithmOfTwoLow = -4.2009150726810847e-11;

// 1/n!. For |x| <= ln(2)/2 the first term left out of exp(x) is below 1e-17.
inline constexpr std::size_t kExponentialTerms = 14;
constexpr std::array<double, kExponentialTerms> ExponentialSeries() {
  std::array<double, kExponentialTerms> coefficients{};
  long double term = 1;
  for (std::size_t n = 0; n < kExponentialTerms; ++n) {
    coefficients[n] = static_cast<double>(term);
    term /= static_cast<long double>(n + 1);
  }
  return coefficients;
}
inline constexpr auto kExponential = ExponentialSeries();

// atan(t z) = 2 sum (-1)^k p^(2k+1) / (2k+1) T_(2k+1)(z), t = tan(2a), p = tan(a), for |z| <= 1.
// T are the Chebyshev polynomials (generating function of the arc tangent). With 2a = pi/8 the
// first term left out is below 1e-17.
inline constexpr std::size_t kArcTangentTerms = 12;
inline constexpr double kTangentOfEighth = 0.41421356237309504880;     // tan(pi/8) = sqrt(2) - 1
inline constexpr double kTangentOfSixteenth = 0.19891236737965800691;  // tan(pi/16)

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
inline constexpr auto kArcTangent = ArcTangentCoefficients();

}  // namespace lane_functions_detail

/// Coefficients in the form that is fastest for L.
template <typename L>
struct LaneConstants {
  static constexpr auto kSine = lane_functions_detail::kSine;
  static constexpr auto kCosine = lane_functions_detail::kCosine;
};

/// Returns sine and cosine, with the bits of SineAndCosineOf a Pair.
///
/// With x = n pi/2 + r and |r| <= pi/4, it evaluates the series at r. The quadrant n exchanges the
/// two results and sets their signs.
template <typename L>
[[nodiscard]] GIRDLE_INLINE SineAndCosine<L> SineAndCosineOfLanes(const L& x) noexcept {
  constexpr L kQuartersPerRadian(2 / std::numbers::pi);
  constexpr L kHigh(lane_functions_detail::kQuarterTurnHigh);
  constexpr L kLow(lane_functions_detail::kQuarterTurnLow);
  const L n = L::Rounded(kQuartersPerRadian * x);
  const L r = (x - kHigh * n) - kLow * n;
  const L square = r * r;
  SineAndCosine<L> result{r * PolynomialValue(LaneConstants<L>::kSine, square),
                          PolynomialValue(LaneConstants<L>::kCosine, square)};
  L::TurnByQuarters(n, result.sine, result.cosine);
  return result;
}

/// Returns exp(-x), with the bits of Decay of a number.
///
/// With -x = n ln 2 + r and |r| <= ln(2)/2, it is the series at r times 2^n.
template <typename L>
[[nodiscard]] GIRDLE_INLINE L DecayOfLanes(const L& x) noexcept {
  using namespace lane_functions_detail;  // NOLINT(google-build-using-namespace): its constants
  constexpr double kLongest = 700;
  const L exponent = L::WhereLess(x, L(kLongest), -x, L(0.0));
  const L n = L::Rounded((1 / std::numbers::ln2) * exponent);
  const L r = (exponent - kLogarithmOfTwoHigh * n) - kLogarithmOfTwoLow * n;
  const L value = PolynomialValue(kExponential, r) * L::PowersOfTwo(n);
  return L::WhereLess(x, L(kLongest), value, L(0.0));
}

/// Returns the angle of the point (x, y), with the bits of Atan2 of a Pair.
template <typename L>
[[nodiscard]] GIRDLE_INLINE L Atan2OfLanes(const L& y, const L& x) noexcept {
  using namespace lane_functions_detail;  // NOLINT(google-build-using-namespace): its constants
  constexpr double kQuarter = std::numbers::pi / 4;
  const L zero(0.0);
  const L width = L::WhereLess(x, zero, -x, x);
  const L height = L::WhereLess(y, zero, -y, y);
  const L smaller = L::WhereLess(height, width, height, width);
  const L larger = L::WhereLess(height, width, width, height);
  // Between tan(pi/8) and 1: atan(a) = pi/4 + atan((a - 1) / (a + 1)).
  const L limit = kTangentOfEighth * larger;
  const L top = L::WhereLess(limit, smaller, smaller - larger, smaller);
  const L bottom = L::WhereLess(limit, smaller, smaller + larger, larger);
  const L offset = L::WhereLess(limit, smaller, L(kQuarter), zero);
  const L ratio = top / L::WhereLess(zero, bottom, bottom, L(1.0));
  const L octant = offset + ratio * PolynomialValue(kArcTangent, ratio * ratio);
  const L quadrant = L::WhereLess(width, height, 2 * kQuarter - octant, octant);
  const L half = L::WhereLess(x, zero, 4 * kQuarter - quadrant, quadrant);
  return L::WhereLess(y, zero, -half, half);
}

}  // namespace girdle
