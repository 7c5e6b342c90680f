// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Two numbers that go through the same arithmetic at the same time: SC and AC, or two angles.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

/// Into every caller: what a shoulder needs thousands of times a millisecond is too long for the
/// compilers' own judgement, and a call costs more than the arithmetic.
#define GIRDLE_INLINE [[gnu::always_inline]] inline

namespace girdle {

/// Arithmetic is element by element and gives each element the bits it would have alone.
class Pair {
 public:
  Pair() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): a number stands for a pair of it, as in 2 * pair
  Pair(double both) noexcept : lanes_{both, both} {}
  Pair(double first, double second) noexcept : lanes_{first, second} {}

  /// Precondition: i < 2.
  [[nodiscard]] double operator[](std::size_t i) const noexcept { return lanes_[i]; }

  friend Pair operator+(Pair a, Pair b) noexcept { return Pair(a.lanes_ + b.lanes_); }
  friend Pair operator-(Pair a, Pair b) noexcept { return Pair(a.lanes_ - b.lanes_); }
  friend Pair operator*(Pair a, Pair b) noexcept { return Pair(a.lanes_ * b.lanes_); }
  friend Pair operator/(Pair a, Pair b) noexcept { return Pair(a.lanes_ / b.lanes_); }
  friend Pair operator-(Pair a) noexcept { return Pair(-a.lanes_); }

  /// Returns `yes` where a < b and `no` elsewhere, also where one of them is a NaN.
  [[nodiscard]] static Pair WhereLess(Pair a, Pair b, Pair yes, Pair no) noexcept {
    return Pair(a.lanes_ < b.lanes_ ? yes.lanes_ : no.lanes_);
  }

 private:
  using Lanes = double __attribute__((vector_size(2 * sizeof(double))));
  explicit Pair(Lanes lanes) noexcept : lanes_(lanes) {}

  Lanes lanes_;
};

[[nodiscard]] inline Pair Sin(Pair x) noexcept { return {std::sin(x[0]), std::sin(x[1])}; }
[[nodiscard]] inline Pair Cos(Pair x) noexcept { return {std::cos(x[0]), std::cos(x[1])}; }
[[nodiscard]] inline Pair Sqrt(Pair x) noexcept { return {std::sqrt(x[0]), std::sqrt(x[1])}; }
[[nodiscard]] inline double Sin(double x) noexcept { return std::sin(x); }
[[nodiscard]] inline double Cos(double x) noexcept { return std::cos(x); }
[[nodiscard]] inline double Sqrt(double x) noexcept { return std::sqrt(x); }
[[nodiscard]] inline double Atan2(double y, double x) noexcept { return std::atan2(y, x); }

/// Value of c_0 + c_1 x + c_2 x^2 + ..., with short chains of dependent operations (Estrin). The
/// coefficients may be numbers, the same for all elements of x, or pairs.
template <std::size_t N, typename C, typename L>
[[nodiscard]] GIRDLE_INLINE L PolynomialValue(const std::array<C, N>& c, L x) noexcept {
  if constexpr (N == 0) {
    return L(0.0);
  } else if constexpr (N == 1) {
    return L(c[0]);
  } else {
    std::array<L, (N + 1) / 2> pairs;
    for (std::size_t i = 0; i + 1 < N; i += 2) {
      pairs[i / 2] = c[i] + c[i + 1] * x;
    }
    if constexpr (N % 2 == 1) {
      pairs.back() = L(c[N - 1]);
    }
    L power = x * x;
    for (std::size_t left = pairs.size(); left > 1; left = (left + 1) / 2) {
      for (std::size_t i = 0; i + 1 < left; i += 2) {
        pairs[i / 2] = pairs[i] + pairs[i + 1] * power;
      }
      if (left % 2 == 1) {
        pairs[left / 2] = pairs[left - 1];
      }
      power = power * power;
    }
    return pairs[0];
  }
}

/// Angle of the point (x, y) as std::atan2, to 4 units in the last place; a signed zero counts as
/// plus, and the point (0, 0) has the angle 0.
[[nodiscard]] Pair Atan2(Pair y, Pair x) noexcept;

namespace pair_detail {

// atan(t z) = 2 sum (-1)^k p^(2k+1) / (2k+1) T_(2k+1)(z), t = tan(2a), p = tan(a), for -1 <= z <= 1
// and T the Chebyshev polynomials (generating function of the arc tangent). With 2a = pi/8 the
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

}  // namespace pair_detail

inline Pair Atan2(Pair y, Pair x) noexcept {
  constexpr double kQuarter = std::numbers::pi / 4;
  const auto absolute = [](Pair a) { return Pair::WhereLess(a, 0.0, -a, a); };
  const Pair width = absolute(x);
  const Pair height = absolute(y);
  const Pair smaller = Pair::WhereLess(height, width, height, width);
  const Pair larger = Pair::WhereLess(height, width, width, height);
  // Between tan(pi/8) and 1: atan(a) = pi/4 + atan((a - 1) / (a + 1)).
  const Pair limit = pair_detail::kTangentOfEighth * larger;
  const Pair top = Pair::WhereLess(limit, smaller, smaller - larger, smaller);
  const Pair bottom = Pair::WhereLess(limit, smaller, smaller + larger, larger);
  const Pair offset = Pair::WhereLess(limit, smaller, kQuarter, 0.0);
  const Pair ratio = top / Pair::WhereLess(0.0, bottom, bottom, 1.0);
  const Pair octant = offset + ratio * PolynomialValue(pair_detail::kArcTangent, ratio * ratio);
  const Pair quadrant = Pair::WhereLess(width, height, 2 * kQuarter - octant, octant);
  const Pair half = Pair::WhereLess(x, 0.0, 4 * kQuarter - quadrant, quadrant);
  return Pair::WhereLess(y, 0.0, -half, half);
}

}  // namespace girdle
