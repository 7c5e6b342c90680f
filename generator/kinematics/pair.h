// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Two numbers that pass through the same arithmetic together: SC and AC, or two angles.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

/// Inlines a function into every caller. These functions run thousands of times a millisecond: a
/// call costs more than their arithmetic, and compilers do not inline functions of this length by
/// themselves.
#define GIRDLE_INLINE [[gnu::always_inline]] inline

namespace girdle {

/// 1.5 * 2^52. A number of this size has no digits behind the point, so adding it rounds. The last
/// bits of the sum are those of the whole number.
inline constexpr double kRoundingShift = 6755399441055744.0;
/// Distance from the second last bit of a number to its sign.
inline constexpr int kToSign = 62;
/// Distance from the last bit of a number to the last bit of its exponent; the exponent of 1.
inline constexpr int kToExponent = 52;
inline constexpr long long kExponentOfOne = 1023;

/// Two numbers. Arithmetic is element by element, and each element has the bits that it has alone.
class Pair {
 public:
  Pair() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): a number stands for a pair of it, as in 2 * pair
  constexpr Pair(double both) noexcept : lanes_{both, both} {}
  Pair(double first, double second) noexcept : lanes_{first, second} {}

  /// Precondition: i < 2.
  [[nodiscard]] double operator[](std::size_t i) const noexcept { return lanes_[i]; }

  friend Pair operator+(Pair a, Pair b) noexcept { return Pair(a.lanes_ + b.lanes_); }
  friend Pair operator-(Pair a, Pair b) noexcept { return Pair(a.lanes_ - b.lanes_); }
  friend Pair operator*(Pair a, Pair b) noexcept { return Pair(a.lanes_ * b.lanes_); }
  friend Pair operator/(Pair a, Pair b) noexcept { return Pair(a.lanes_ / b.lanes_); }
  friend Pair operator-(Pair a) noexcept { return Pair(-a.lanes_); }

  /// Returns the nearest whole numbers. Precondition: the numbers are below 2^51.
  [[nodiscard]] static Pair Rounded(Pair a) noexcept {
    return (a + kRoundingShift) - kRoundingShift;
  }

  /// Returns `yes` where a < b, otherwise `no`. If a or b is a NaN, it returns `no`.
  [[nodiscard]] static Pair WhereLess(Pair a, Pair b, Pair yes, Pair no) noexcept {
    return Pair(a.lanes_ < b.lanes_ ? yes.lanes_ : no.lanes_);
  }

  /// Replaces the sine and cosine of angles by those of the angles plus n quarter turns.
  /// Precondition: n are whole numbers.
  static void TurnByQuarters(Pair n, Pair& sine, Pair& cosine) noexcept {
    const Bits quadrant = reinterpret_cast<Bits>((n + kRoundingShift).lanes_);  // its last two bits
    const Bits odd = -(quadrant & 1);
    const Bits a = reinterpret_cast<Bits>(sine.lanes_);
    const Bits b = reinterpret_cast<Bits>(cosine.lanes_);
    sine.lanes_ = reinterpret_cast<Lanes>(((odd & b) | (~odd & a)) ^ ((quadrant & 2) << kToSign));
    cosine.lanes_ =
        reinterpret_cast<Lanes>(((odd & a) | (~odd & b)) ^ (((quadrant + 1) & 2) << kToSign));
  }

  /// Returns 2^n. Precondition: n are whole numbers from -1022 to 1023.
  [[nodiscard]] static Pair PowersOfTwo(Pair n) noexcept {
    const Bits shifted = reinterpret_cast<Bits>((n + kRoundingShift).lanes_);
    return Pair(reinterpret_cast<Lanes>((shifted + kExponentOfOne) << kToExponent));
  }

 private:
  using Lanes = double __attribute__((vector_size(2 * sizeof(double))));
  using Bits = long long __attribute__((vector_size(2 * sizeof(double))));
  explicit Pair(Lanes lanes) noexcept : lanes_(lanes) {}

  Lanes lanes_;
};

[[nodiscard]] inline Pair Sqrt(Pair x) noexcept { return {std::sqrt(x[0]), std::sqrt(x[1])}; }
[[nodiscard]] inline double Sqrt(double x) noexcept { return std::sqrt(x); }
[[nodiscard]] inline double Atan2(double y, double x) noexcept { return std::atan2(y, x); }

/// Returns c_0 + c_1 x + c_2 x^2 + ..., with short chains of dependent operations (Estrin). The
/// coefficients are numbers, equal for all elements of x, or pairs.
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

/// Returns the angle of the point (x, y) like std::atan2, to 4 units in the last place. A signed
/// zero counts as plus. The point (0, 0) has the angle 0. The result is NaN if both are infinite.
/// Not inline: a pose calls it seven times, and in a simulation its code has to come from beyond
/// the first cache.
[[nodiscard]] Pair Atan2(Pair y, Pair x) noexcept;

template <typename T>
struct SineAndCosine {
  T sine;
  T cosine;
};

/// Returns sine and cosine to 2 units in the last place of 1. Precondition: the angle is not larger
/// than a few turns, as all angles of an arm. It is faster than std::sin and std::cos, and gives
/// the same result on every machine. Not inline, for the same reason as Atan2.
[[nodiscard]] SineAndCosine<Pair> SineAndCosineOf(Pair x) noexcept;
[[nodiscard]] inline SineAndCosine<double> SineAndCosineOf(double x) noexcept {
  const SineAndCosine<Pair> both = SineAndCosineOf(Pair(x));
  return {both.sine[0], both.cosine[0]};
}

/// Returns exp(-x) to 2 units in the last place. Precondition: x > -700. The result is 0 from x =
/// 700 on, where exp(-x) is below 1e-304. It is the same on every machine.
[[nodiscard]] double Decay(double x) noexcept;

}  // namespace girdle
