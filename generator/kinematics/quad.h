// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Four numbers that go through the same arithmetic at the same time: one of each of four poses.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "kinematics/jet.h"
#include "kinematics/lane_functions.h"
#include "kinematics/rotation_algebra.h"

namespace girdle {

/// Arithmetic is element by element and gives each element the bits it would have alone.
///
/// Quick in functions for AVX2 into which everything is inlined, and right everywhere. It has a
/// copy constructor of its own so that it is handed over in memory: functions for different
/// processors disagree on how to hand over a vector of four.
class Quad {
 public:
  static constexpr std::size_t kSize = 4;

  Quad() = default;
  // NOLINTNEXTLINE(modernize-use-equals-default): see above
  GIRDLE_INLINE constexpr Quad(const Quad& other) noexcept : elements_(other.elements_) {}
  Quad& operator=(const Quad& other) noexcept = default;
  ~Quad() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): a number stands for four of it, as in 2 * quad
  GIRDLE_INLINE constexpr Quad(double all) noexcept : elements_{all, all, all, all} {}
  GIRDLE_INLINE Quad(double a, double b, double c, double d) noexcept : elements_{a, b, c, d} {}

  /// Four successive numbers; they are aligned as a quad.
  [[nodiscard]] GIRDLE_INLINE static Quad From(const double* numbers) noexcept {
    Quad quad;
    quad.elements_ = *reinterpret_cast<const MemoryVector*>(numbers);
    return quad;
  }

  /// Precondition: i < 4.
  [[nodiscard]] GIRDLE_INLINE double operator[](std::size_t i) const noexcept {
    return elements_[i];
  }

  GIRDLE_INLINE friend Quad operator+(const Quad& a, const Quad& b) noexcept {
    Quad sum;
    sum.elements_ = a.elements_ + b.elements_;
    return sum;
  }
  GIRDLE_INLINE friend Quad operator-(const Quad& a, const Quad& b) noexcept {
    Quad difference;
    difference.elements_ = a.elements_ - b.elements_;
    return difference;
  }
  GIRDLE_INLINE friend Quad operator*(const Quad& a, const Quad& b) noexcept {
    Quad product;
    product.elements_ = a.elements_ * b.elements_;
    return product;
  }
  GIRDLE_INLINE friend Quad operator/(const Quad& a, const Quad& b) noexcept {
    Quad quotient;
    quotient.elements_ = a.elements_ / b.elements_;
    return quotient;
  }
  GIRDLE_INLINE friend Quad operator-(const Quad& a) noexcept {
    Quad negative;
    negative.elements_ = -a.elements_;
    return negative;
  }

  /// As of Pair.
  [[nodiscard]] GIRDLE_INLINE static Quad Rounded(const Quad& a) noexcept {
    constexpr Quad kShift(kRoundingShift);
    return (a + kShift) - kShift;
  }
  [[nodiscard]] GIRDLE_INLINE static Quad WhereLess(const Quad& a, const Quad& b, const Quad& yes,
                                                    const Quad& no) noexcept {
    Quad result;
    result.elements_ = a.elements_ < b.elements_ ? yes.elements_ : no.elements_;
    return result;
  }
  GIRDLE_INLINE static void TurnByQuarters(const Quad& n, Quad& sine, Quad& cosine) noexcept {
    constexpr Quad kShift(kRoundingShift);
    const Quad shifted = n + kShift;
    const Bits quadrant = reinterpret_cast<Bits>(shifted.elements_);  // its last two bits
    const Bits odd = -(quadrant & 1);
    const Bits a = reinterpret_cast<Bits>(sine.elements_);
    const Bits b = reinterpret_cast<Bits>(cosine.elements_);
    sine.elements_ =
        reinterpret_cast<Vector>(((odd & b) | (~odd & a)) ^ ((quadrant & 2) << kToSign));
    cosine.elements_ =
        reinterpret_cast<Vector>(((odd & a) | (~odd & b)) ^ (((quadrant + 1) & 2) << kToSign));
  }
  [[nodiscard]] GIRDLE_INLINE static Quad PowersOfTwo(const Quad& n) noexcept {
    constexpr Quad kShift(kRoundingShift);
    Quad powers = n + kShift;
    powers.elements_ = reinterpret_cast<Vector>(
        (reinterpret_cast<Bits>(powers.elements_) + kExponentOfOne) << kToExponent);
    return powers;
  }
  [[nodiscard]] GIRDLE_INLINE static Quad SquareRoot(const Quad& a) noexcept {
    return {std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
  }
  /// The largest element.
  [[nodiscard]] GIRDLE_INLINE double Largest() const noexcept {
    Vector other = __builtin_shufflevector(elements_, elements_, 2, 3, 0, 1);
    const Vector larger = elements_ < other ? other : elements_;
    other = __builtin_shufflevector(larger, larger, 1, 0, 3, 2);
    const Vector largest = larger < other ? other : larger;
    return largest[0];
  }

  /// Element j of a, b, c, d becomes element 0, 1, 2, 3 of the jth of them.
  GIRDLE_INLINE static void Transpose(Quad& a, Quad& b, Quad& c, Quad& d) noexcept {
    const Vector low_ab = __builtin_shufflevector(a.elements_, b.elements_, 0, 4, 2, 6);
    const Vector high_ab = __builtin_shufflevector(a.elements_, b.elements_, 1, 5, 3, 7);
    const Vector low_cd = __builtin_shufflevector(c.elements_, d.elements_, 0, 4, 2, 6);
    const Vector high_cd = __builtin_shufflevector(c.elements_, d.elements_, 1, 5, 3, 7);
    a.elements_ = __builtin_shufflevector(low_ab, low_cd, 0, 1, 4, 5);
    b.elements_ = __builtin_shufflevector(high_ab, high_cd, 0, 1, 4, 5);
    c.elements_ = __builtin_shufflevector(low_ab, low_cd, 2, 3, 6, 7);
    d.elements_ = __builtin_shufflevector(high_ab, high_cd, 2, 3, 6, 7);
  }

 private:
  // Aligned in every function alike: where there is no AVX compilers align vectors to 16 bytes.
  static constexpr std::size_t kBytes = 4 * sizeof(double);
  using Vector = double __attribute__((vector_size(kBytes)));
  using MemoryVector = double __attribute__((vector_size(kBytes), aligned(kBytes), may_alias));
  using Bits = long long __attribute__((vector_size(kBytes)));

  alignas(kBytes) Vector elements_;
};
static_assert(alignof(Quad) == sizeof(Quad));

/// Each number as a quad.
template <std::size_t N>
[[nodiscard]] constexpr std::array<Quad, N> Quads(const std::array<double, N>& numbers) noexcept {
  return [&numbers]<std::size_t... I>(std::index_sequence<I...>) {
    return std::array<Quad, N>{Quad(numbers[I])...};
  }
  (std::make_index_sequence<N>());
}

/// Two numbers of each of four poses: those of SC, and of AC.
class QuadPair {
 public:
  QuadPair() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): a number stands for eight of it
  GIRDLE_INLINE QuadPair(double all) noexcept : elements_{Quad(all), Quad(all)} {}
  // NOLINTNEXTLINE(google-explicit-constructor): a pair is the same in all four poses
  GIRDLE_INLINE QuadPair(Pair each) noexcept : elements_{Quad(each[0]), Quad(each[1])} {}
  // NOLINTNEXTLINE(google-explicit-constructor): of each pose both are the same
  GIRDLE_INLINE QuadPair(const Quad& both) noexcept : elements_{both, both} {}
  GIRDLE_INLINE QuadPair(const Quad& first, const Quad& second) noexcept
      : elements_{first, second} {}

  /// Precondition: i < 2.
  [[nodiscard]] GIRDLE_INLINE const Quad& operator[](std::size_t i) const noexcept {
    return elements_[i];
  }

  GIRDLE_INLINE friend QuadPair operator+(const QuadPair& a, const QuadPair& b) noexcept {
    return {a[0] + b[0], a[1] + b[1]};
  }
  GIRDLE_INLINE friend QuadPair operator-(const QuadPair& a, const QuadPair& b) noexcept {
    return {a[0] - b[0], a[1] - b[1]};
  }
  GIRDLE_INLINE friend QuadPair operator*(const QuadPair& a, const QuadPair& b) noexcept {
    return {a[0] * b[0], a[1] * b[1]};
  }
  GIRDLE_INLINE friend QuadPair operator/(const QuadPair& a, const QuadPair& b) noexcept {
    return {a[0] / b[0], a[1] / b[1]};
  }
  GIRDLE_INLINE friend QuadPair operator-(const QuadPair& a) noexcept { return {-a[0], -a[1]}; }

  /// As of Pair.
  [[nodiscard]] GIRDLE_INLINE static QuadPair WhereLess(const QuadPair& a, const QuadPair& b,
                                                        const QuadPair& yes,
                                                        const QuadPair& no) noexcept {
    return {Quad::WhereLess(a[0], b[0], yes[0], no[0]), Quad::WhereLess(a[1], b[1], yes[1], no[1])};
  }

 private:
  std::array<Quad, 2> elements_;
};

template <>
struct WithPairs<Quad> {
  using Type = QuadPair;
};

[[nodiscard]] GIRDLE_INLINE QuadPair Both(const Quad& x) noexcept { return {x, x}; }
[[nodiscard]] GIRDLE_INLINE Quad Element(const QuadPair& x, std::size_t i) noexcept { return x[i]; }
[[nodiscard]] GIRDLE_INLINE QuadPair LeafOf(const QuadPair& x) noexcept { return x; }
/// Of the first pose: whoever asks has put poses together that answer alike.
[[nodiscard]] GIRDLE_INLINE double ValueOf(const Quad& x) noexcept { return x[0]; }
[[nodiscard]] GIRDLE_INLINE QuadPair SignOf(const QuadPair& x) noexcept {
  return QuadPair::WhereLess(x, 0.0, -1.0, 1.0);
}
template <std::size_t N>
[[nodiscard]] GIRDLE_INLINE QuadPair Polynomial(const std::array<double, N>& c,
                                                const QuadPair& x) noexcept {
  return PolynomialValue(c, x);
}

[[nodiscard]] GIRDLE_INLINE Quad Sqrt(const Quad& x) noexcept { return Quad::SquareRoot(x); }
[[nodiscard]] GIRDLE_INLINE QuadPair Sqrt(const QuadPair& x) noexcept {
  return {Sqrt(x[0]), Sqrt(x[1])};
}
[[nodiscard]] GIRDLE_INLINE QuadPair Atan2(const QuadPair& y, const QuadPair& x) noexcept {
  return {Atan2OfLanes(y[0], x[0]), Atan2OfLanes(y[1], x[1])};
}
/// As of a number and of a Pair, which differ where an angle is pi but for rounding.
[[nodiscard]] GIRDLE_INLINE Quad WithinHalfTurn(const Quad& angle_rad) noexcept {
  const Quad raised = Quad::WhereLess(-kPi, angle_rad, angle_rad, angle_rad + 2 * kPi);
  return Quad::WhereLess(kPi, angle_rad, angle_rad - 2 * kPi, raised);
}
[[nodiscard]] GIRDLE_INLINE QuadPair WithinHalfTurn(const QuadPair& angle_rad) noexcept {
  const QuadPair lowered = QuadPair::WhereLess(kPi, angle_rad, angle_rad - 2 * kPi, angle_rad);
  return QuadPair::WhereLess(-kPi, lowered, lowered, lowered + 2 * kPi);
}

template <>
struct LaneConstants<Quad> {
  static constexpr auto kSine = Quads(lane_functions_detail::kSine);
  static constexpr auto kCosine = Quads(lane_functions_detail::kCosine);
};
[[nodiscard]] GIRDLE_INLINE SineAndCosine<Quad> SineAndCosineOf(const Quad& x) noexcept {
  return SineAndCosineOfLanes(x);
}
[[nodiscard]] GIRDLE_INLINE SineAndCosine<QuadPair> SineAndCosineOf(const QuadPair& x) noexcept {
  const SineAndCosine<Quad> first = SineAndCosineOfLanes(x[0]);
  const SineAndCosine<Quad> second = SineAndCosineOfLanes(x[1]);
  return {{first.sine, second.sine}, {first.cosine, second.cosine}};
}
[[nodiscard]] GIRDLE_INLINE Quad Decay(const Quad& x) noexcept { return DecayOfLanes(x); }

/// Each pose takes the series that it would take alone: by the larger of its two numbers.
template <typename L>
[[nodiscard]] GIRDLE_INLINE CosineAndSine<L> CosineAndSineOfQuads(const L& x,
                                                                  const Quad& largest) noexcept {
  using namespace rotation_algebra_detail;  // NOLINT(google-build-using-namespace): its constants
  const auto choose = [&](double limit, const L& below, const L& from) {
    if constexpr (std::is_same_v<L, Quad>) {
      return Quad::WhereLess(largest, limit, below, from);
    } else {
      return QuadPair::WhereLess(Both(largest), limit, below, from);
    }
  };
  // A number becomes a quad most quickly where it is one before the program starts.
  static constexpr auto kShorterCosines = Quads(kShorterCosine);
  static constexpr auto kShorterSines = Quads(kShorterSine);
  CosineAndSine<L> result{PolynomialValue(kShorterCosines, x), PolynomialValue(kShorterSines, x)};
  const double largest_of_all = largest.Largest();
  if (largest_of_all < kShorterSeriesLimit) {
    return result;
  }
  result = {choose(kShorterSeriesLimit, result.cosine, PolynomialValue(kShortCosine, x)),
            choose(kShorterSeriesLimit, result.sine_over_root, PolynomialValue(kShortSine, x))};
  if (largest_of_all < kShortSeriesLimit) {
    return result;
  }
  return {choose(kShortSeriesLimit, result.cosine, PolynomialValue(kCosine, x)),
          choose(kShortSeriesLimit, result.sine_over_root, PolynomialValue(kSine, x))};
}
[[nodiscard]] GIRDLE_INLINE CosineAndSine<Quad> CosineAndSineOfRoot(const Quad& x) noexcept {
  return CosineAndSineOfQuads(x, x);
}
[[nodiscard]] GIRDLE_INLINE CosineAndSine<QuadPair> CosineAndSineOfRoot(
    const QuadPair& x) noexcept {
  return CosineAndSineOfQuads(x, Quad::WhereLess(x[0], x[1], x[1], x[0]));
}

/// As ExpOf of other scalars, with constants that are quads.
[[nodiscard]] GIRDLE_INLINE QuaternionOf<QuadPair> ExpOf(const VectorOf<QuadPair>& u) noexcept {
  constexpr Quad kHalf(0.5);
  constexpr Quad kQuarter(0.25);
  const QuadPair square = u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
  const CosineAndSine<QuadPair> half = CosineAndSineOfRoot(Both(kQuarter) * square);
  const QuadPair scale = Both(kHalf) * half.sine_over_root;
  return {half.cosine, scale * u[0], scale * u[1], scale * u[2]};
}

}  // namespace girdle
