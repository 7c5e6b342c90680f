// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Two numbers that go through the same arithmetic at the same time: SC and AC, or two angles.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

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

  /// Returns the nearest whole numbers, for numbers below 2^51.
  [[nodiscard]] static Pair Rounded(Pair a) noexcept {
    // Adding 1.5 * 2^52 leaves no room for what is behind the point.
    constexpr double kShift = 6755399441055744.0;
    return (a + kShift) - kShift;
  }

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
/// plus, and the point (0, 0) has the angle 0; both infinite is a NaN. Not inline: a pose needs it
/// seven times, and in a simulation its code has to come from beyond the first cache.
[[nodiscard]] Pair Atan2(Pair y, Pair x) noexcept;

}  // namespace girdle
