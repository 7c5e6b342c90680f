// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Four numbers that pass through the same arithmetic together, one of each of four poses.
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

/// Four numbers. Arithmetic is element by element, and each element has the bits that it has alone.
///
/// It is fast in functions for AVX2 into which everything is inlined, and correct everywhere. Its
/// own copy constructor makes compilers pass it in memory. Functions for different processors pass
/// a vector of four in different ways.
class Four {
 public:
  static constexpr std::size_t kSize = 4;

  Four() = default;
  // NOLINTNEXTLINE(modernize-use-equals-default): its own, so that fours are passed in memory
  GIRDLE_INLINE constexpr Four(const Four& other) noexcept : elements_(other.elements_) {}
  Four& operator=(const Four& other) noexcept = default;
  ~Four() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): a number stands for four of it, as in 2 * four
  GIRDLE_INLINE constexpr Four(double all) noexcept : elements_{all, all, all, all} {}
  GIRDLE_INLINE Four(double a, double b, double c, double d) noexcept : elements_{a, b, c, d} {}

  /// Returns four successive numbers. Precondition: they are aligned like a Four.
  [[nodiscard]] GIRDLE_INLINE static Four From(const double* numbers) noexcept {
    Four four;
    four.elements_ = *reinterpret_cast<const MemoryVector*>(numbers);
    return four;
  }

  /// Precondition: i < 4.
  [[nodiscard]] GIRDLE_INLINE double operator[](std::size_t i) const noexcept {
    return elements_[i];
  }

  GIRDLE_INLINE friend Four operator+(const Four& a, const Four& b) noexcept {
    Four sum;
    sum.elements_ = a.elements_ + b.elements_;
    return sum;
  }
  GIRDLE_INLINE friend Four operator-(const Four& a, const Four& b) noexcept {
    Four difference;
    difference.elements_ = a.elements_ - b.elements_;
    return difference;
  }
  GIRDLE_INLINE friend Four operator*(const Four& a, const Four& b) noexcept {
    Four product;
    product.elements_ = a.elements_ * b.elements_;
    return product;
  }
  GIRDLE_INLINE friend Four operator/(const Four& a, const Four& b) noexcept {
    Four quotient;
    quotient.elements_ = a.elements_ / b.elements_;
    return quotient;
  }
  GIRDLE_INLINE friend Four operator-(const Four& a) noexcept {
    Four negative;
    negative.elements_ = -a.elements_;
    return negative;
  }

  /// Rounded, WhereLess, TurnByQuarters and PowersOfTwo: see Pair.
  [[nodiscard]] GIRDLE_INLINE static Four Rounded(const Four& a) noexcept {
    constexpr Four kShift(kRoundingShift);
    return (a + kShift) - kShift;
  }
  [[nodiscard]] GIRDLE_INLINE static Four WhereLess(const Four& a, const Four& b, const Four& yes,
                                                    const Four& no) noexcept {
    Four result;
    result.elements_ = a.elements_ < b.elements_ ? yes.elements_ : no.elements_;
    return result;
  }
  GIRDLE_INLINE static void TurnByQuarters(const Four& n, Four& sine, Four& cosine) noexcept {
    constexpr Four kShift(kRoundingShift);
    const Four shifted = n + kShift;
    const Bits quadrant = reinterpret_cast<Bits>(shifted.elements_);  // its last two bits
    const Bits odd = -(quadrant & 1);
    const Bits a = reinterpret_cast<Bits>(sine.elements_);
    const Bits b = reinterpret_cast<Bits>(cosine.elements_);
    sine.elements_ =
        reinterpret_cast<Vector>(((odd & b) | (~odd & a)) ^ ((quadrant & 2) << kToSign));
    cosine.elements_ =
        reinterpret_cast<Vector>(((odd & a) | (~odd & b)) ^ (((quadrant + 1) & 2) << kToSign));
  }
  [[nodiscard]] GIRDLE_INLINE static Four PowersOfTwo(const Four& n) noexcept {
    constexpr Four kShift(kRoundingShift);
    Four powers = n + kShift;
    powers.elements_ = reinterpret_cast<Vector>(
        (reinterpret_cast<Bits>(powers.elements_) + kExponentOfOne) << kToExponent);
    return powers;
  }
  [[nodiscard]] GIRDLE_INLINE static Four SquareRoot(const Four& a) noexcept {
    return {std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
  }
  /// Returns the largest element.
  [[nodiscard]] GIRDLE_INLINE double Largest() const noexcept {
    Vector other = __builtin_shufflevector(elements_, elements_, 2, 3, 0, 1);
    const Vector larger = elements_ < other ? other : elements_;
    other = __builtin_shufflevector(larger, larger, 1, 0, 3, 2);
    const Vector largest = larger < other ? other : larger;
    return largest[0];
  }

  /// Transposes four fours: element j of a, b, c, d becomes element 0, 1, 2, 3 of the jth of them.
  GIRDLE_INLINE static void Transpose(Four& a, Four& b, Four& c, Four& d) noexcept {
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
  // The alignment is explicit, so all functions agree. Without AVX, compilers align vectors to 16
  // bytes.
  static constexpr std::size_t kBytes = 4 * sizeof(double);
  using Vector = double __attribute__((vector_size(kBytes)));
  using MemoryVector = double __attribute__((vector_size(kBytes), aligned(kBytes), may_alias));
  using Bits = long long __attribute__((vector_size(kBytes)));

  alignas(kBytes) Vector elements_;
};
static_assert(alignof(Four) == sizeof(Four));

/// Returns a Four for each number, with all elements equal.
template <std::size_t N>
[[nodiscard]] constexpr std::array<Four, N> Fours(const std::array<double, N>& numbers) noexcept {
  return [&numbers]<std::size_t... I>(std::index_sequence<I...>) {
    return std::array<Four, N>{Four(numbers[I])...};
  }
  (std::make_index_sequence<N>());
}

/// Two numbers of each of four poses: one of SC and one of AC.
class FourPairs {
 public:
  FourPairs() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): a number stands for eight of it
  GIRDLE_INLINE FourPairs(double all) noexcept : elements_{Four(all), Four(all)} {}
  // NOLINTNEXTLINE(google-explicit-constructor): a pair is equal in all four poses
  GIRDLE_INLINE FourPairs(Pair each) noexcept : elements_{Four(each[0]), Four(each[1])} {}
  // NOLINTNEXTLINE(google-explicit-constructor): both numbers of a pose are equal
  GIRDLE_INLINE FourPairs(const Four& both) noexcept : elements_{both, both} {}
  GIRDLE_INLINE FourPairs(const Four& first, const Four& second) noexcept
      : elements_{first, second} {}

  /// Precondition: i < 2.
  [[nodiscard]] GIRDLE_INLINE const Four& operator[](std::size_t i) const noexcept {
    return elements_[i];
  }

  GIRDLE_INLINE friend FourPairs operator+(const FourPairs& a, const FourPairs& b) noexcept {
    return {a[0] + b[0], a[1] + b[1]};
  }
  GIRDLE_INLINE friend FourPairs operator-(const FourPairs& a, const FourPairs& b) noexcept {
    return {a[0] - b[0], a[1] - b[1]};
  }
  GIRDLE_INLINE friend FourPairs operator*(const FourPairs& a, const FourPairs& b) noexcept {
    return {a[0] * b[0], a[1] * b[1]};
  }
  GIRDLE_INLINE friend FourPairs operator/(const FourPairs& a, const FourPairs& b) noexcept {
    return {a[0] / b[0], a[1] / b[1]};
  }
  GIRDLE_INLINE friend FourPairs operator-(const FourPairs& a) noexcept { return {-a[0], -a[1]}; }

  /// See Pair::WhereLess.
  [[nodiscard]] GIRDLE_INLINE static FourPairs WhereLess(const FourPairs& a, const FourPairs& b,
                                                         const FourPairs& yes,
                                                         const FourPairs& no) noexcept {
    return {Four::WhereLess(a[0], b[0], yes[0], no[0]), Four::WhereLess(a[1], b[1], yes[1], no[1])};
  }

 private:
  std::array<Four, 2> elements_;
};

template <>
struct WithPairs<Four> {
  using Type = FourPairs;
};

[[nodiscard]] GIRDLE_INLINE FourPairs Both(const Four& x) noexcept { return {x, x}; }
[[nodiscard]] GIRDLE_INLINE Four Element(const FourPairs& x, std::size_t i) noexcept {
  return x[i];
}
[[nodiscard]] GIRDLE_INLINE FourPairs LeafOf(const FourPairs& x) noexcept { return x; }
/// Returns the number of the first pose. The caller has grouped poses that take the same branch.
[[nodiscard]] GIRDLE_INLINE double ValueOf(const Four& x) noexcept { return x[0]; }
[[nodiscard]] GIRDLE_INLINE FourPairs SignOf(const FourPairs& x) noexcept {
  return FourPairs::WhereLess(x, 0.0, -1.0, 1.0);
}
template <std::size_t N>
[[nodiscard]] GIRDLE_INLINE FourPairs Polynomial(const std::array<double, N>& c,
                                                 const FourPairs& x) noexcept {
  return PolynomialValue(c, x);
}

[[nodiscard]] GIRDLE_INLINE Four Sqrt(const Four& x) noexcept { return Four::SquareRoot(x); }
[[nodiscard]] GIRDLE_INLINE FourPairs Sqrt(const FourPairs& x) noexcept {
  return {Sqrt(x[0]), Sqrt(x[1])};
}
[[nodiscard]] GIRDLE_INLINE FourPairs Atan2(const FourPairs& y, const FourPairs& x) noexcept {
  return {Atan2OfLanes(y[0], x[0]), Atan2OfLanes(y[1], x[1])};
}
/// Returns the angle in (-pi, pi]. The two overloads have the bits of those for a number and for a
/// Pair, which differ by rounding at pi.
[[nodiscard]] GIRDLE_INLINE Four WithinHalfTurn(const Four& angle_rad) noexcept {
  const Four raised = Four::WhereLess(-kPi, angle_rad, angle_rad, angle_rad + 2 * kPi);
  return Four::WhereLess(kPi, angle_rad, angle_rad - 2 * kPi, raised);
}
[[nodiscard]] GIRDLE_INLINE FourPairs WithinHalfTurn(const FourPairs& angle_rad) noexcept {
  const FourPairs lowered = FourPairs::WhereLess(kPi, angle_rad, angle_rad - 2 * kPi, angle_rad);
  return FourPairs::WhereLess(-kPi, lowered, lowered, lowered + 2 * kPi);
}

template <>
struct LaneConstants<Four> {
  static constexpr auto kSine = Fours(lane_functions_detail::kSine);
  static constexpr auto kCosine = Fours(lane_functions_detail::kCosine);
};
[[nodiscard]] GIRDLE_INLINE SineAndCosine<Four> SineAndCosineOf(const Four& x) noexcept {
  return SineAndCosineOfLanes(x);
}
[[nodiscard]] GIRDLE_INLINE SineAndCosine<FourPairs> SineAndCosineOf(const FourPairs& x) noexcept {
  const SineAndCosine<Four> first = SineAndCosineOfLanes(x[0]);
  const SineAndCosine<Four> second = SineAndCosineOfLanes(x[1]);
  return {{first.sine, second.sine}, {first.cosine, second.cosine}};
}
[[nodiscard]] GIRDLE_INLINE Four Decay(const Four& x) noexcept { return DecayOfLanes(x); }

/// Each pose takes the series that it takes alone, chosen by the larger of its two numbers.
template <typename L>
[[nodiscard]] GIRDLE_INLINE CosineAndSine<L> CosineAndSineOfFour(const L& x,
                                                                 const Four& largest) noexcept {
  using namespace rotation_algebra_detail;  // NOLINT(google-build-using-namespace): its constants
  const auto choose = [&](double limit, const L& below, const L& from) {
    if constexpr (std::is_same_v<L, Four>) {
      return Four::WhereLess(largest, limit, below, from);
    } else {
      return FourPairs::WhereLess(Both(largest), limit, below, from);
    }
  };
  // A Four made at compile time is the fastest.
  static constexpr auto kShorterCosines = Fours(kShorterCosine);
  static constexpr auto kShorterSines = Fours(kShorterSine);
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
[[nodiscard]] GIRDLE_INLINE CosineAndSine<Four> CosineAndSineOfRoot(const Four& x) noexcept {
  return CosineAndSineOfFour(x, x);
}
[[nodiscard]] GIRDLE_INLINE CosineAndSine<FourPairs> CosineAndSineOfRoot(
    const FourPairs& x) noexcept {
  return CosineAndSineOfFour(x, Four::WhereLess(x[0], x[1], x[1], x[0]));
}

/// ExpOf with constants that are fours.
[[nodiscard]] GIRDLE_INLINE QuaternionOf<FourPairs> ExpOf(const VectorOf<FourPairs>& u) noexcept {
  constexpr Four kHalf(0.5);
  constexpr Four kQuarter(0.25);
  const FourPairs square = u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
  const CosineAndSine<FourPairs> half = CosineAndSineOfRoot(Both(kQuarter) * square);
  const FourPairs scale = Both(kHalf) * half.sine_over_root;
  return {half.cosine, scale * u[0], scale * u[1], scale * u[2]};
}

}  // namespace girdle
