// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Numbers that carry their derivatives, so that one formula gives a pose and its rates.
///
/// A scalar T is one of three. A leaf is a double or a Pair. A Jet is a leaf with its derivatives
/// by elevation and plane. A Dual is a scalar with one more derivative, along a line that the user
/// chooses. Formulas are written once, as templates over T. Derivatives follow from the rules of
/// calculus, so they are exact. For example, with x = Jet(theta) whose derivative by elevation is
/// 1, SineAndCosineOf(x).sine contains sin(theta) and its derivative cos(theta).
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "kinematics/pair.h"

namespace girdle {

/// Index of each derivative in a Jet.
enum JetPart : std::size_t {
  kValue,
  kByElevation,
  kByPlane,
  kByElevationTwice,
  kByElevationAndPlane,
  kByPlaneTwice,
};

/// A leaf and its derivatives by elevation and plane up to `Order`, 1 or 2.
template <typename L, int Order>
struct Jet {
  static_assert(Order == 1 || Order == 2);
  static constexpr std::size_t kParts = Order == 1 ? 3 : 6;

  std::array<L, kParts> part;

  Jet() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): a constant is a jet without derivatives
  Jet(L constant) noexcept : part{} {
    part.fill(L(0.0));
    part[kValue] = constant;
  }
  template <typename Number>
  requires(std::is_arithmetic_v<Number> && !std::is_same_v<Number, L>)
      // NOLINTNEXTLINE(google-explicit-constructor): a constant is a jet without derivatives
      Jet(Number constant)
  noexcept : Jet(L(static_cast<double>(constant))) {}

  friend Jet operator+(const Jet& a, const Jet& b) noexcept {
    Jet sum;
    for (std::size_t i = 0; i < kParts; ++i) {
      sum.part[i] = a.part[i] + b.part[i];
    }
    return sum;
  }
  friend Jet operator-(const Jet& a, const Jet& b) noexcept {
    Jet difference;
    for (std::size_t i = 0; i < kParts; ++i) {
      difference.part[i] = a.part[i] - b.part[i];
    }
    return difference;
  }
  friend Jet operator-(const Jet& a) noexcept {
    Jet negative;
    for (std::size_t i = 0; i < kParts; ++i) {
      negative.part[i] = -a.part[i];
    }
    return negative;
  }
  friend Jet operator*(const Jet& a, const Jet& b) noexcept {
    const auto& p = a.part;
    const auto& q = b.part;
    Jet product;
    product.part[kValue] = p[kValue] * q[kValue];
    for (const JetPart i : {kByElevation, kByPlane}) {
      product.part[i] = p[kValue] * q[i] + p[i] * q[kValue];
    }
    if constexpr (Order == 2) {
      const auto twice = [&](JetPart once, JetPart both) {
        return p[kValue] * q[both] + 2.0 * (p[once] * q[once]) + p[both] * q[kValue];
      };
      product.part[kByElevationTwice] = twice(kByElevation, kByElevationTwice);
      product.part[kByPlaneTwice] = twice(kByPlane, kByPlaneTwice);
      product.part[kByElevationAndPlane] =
          p[kValue] * q[kByElevationAndPlane] + p[kByElevation] * q[kByPlane] +
          p[kByPlane] * q[kByElevation] + p[kByElevationAndPlane] * q[kValue];
    }
    return product;
  }
  /// Scaling by a constant.
  friend Jet operator*(const Jet& a, L b) noexcept {
    Jet product;
    for (std::size_t i = 0; i < kParts; ++i) {
      product.part[i] = a.part[i] * b;
    }
    return product;
  }
  template <typename Number>
  requires std::is_convertible_v<Number, L>
  friend Jet operator*(Number a, const Jet& b) noexcept { return b * L(a); }
};

/// A scalar and its derivative along a line.
template <typename T>
struct Dual {
  T value;
  T slope;

  Dual() = default;
  Dual(T value_in, T slope_in) noexcept : value(value_in), slope(slope_in) {}
  template <typename Constant>
  requires std::is_convertible_v<Constant, T>
  // NOLINTNEXTLINE(google-explicit-constructor): a constant has no slope
  Dual(Constant constant)
  noexcept : value(constant), slope(0.0) {}

  friend Dual operator+(const Dual& a, const Dual& b) noexcept {
    return {a.value + b.value, a.slope + b.slope};
  }
  friend Dual operator-(const Dual& a, const Dual& b) noexcept {
    return {a.value - b.value, a.slope - b.slope};
  }
  friend Dual operator-(const Dual& a) noexcept { return {-a.value, -a.slope}; }
  friend Dual operator*(const Dual& a, const Dual& b) noexcept {
    return {a.value * b.value, a.value * b.slope + a.slope * b.value};
  }
  /// Scaling by a constant.
  template <typename Constant>
  requires(std::is_convertible_v<Constant, T> && !std::is_same_v<Constant, Dual>) friend Dual
  operator*(const Constant& a, const Dual& b) noexcept {
    return {a * b.value, a * b.slope};
  }
  template <typename Constant>
  requires(std::is_convertible_v<Constant, T> && !std::is_same_v<Constant, Dual>) friend Dual
  operator*(const Dual& a, const Constant& b) noexcept {
    return {a.value * b, a.slope * b};
  }
};

/// The scalar type that has pairs as leaves instead of numbers.
template <typename T>
struct WithPairs;
template <>
struct WithPairs<double> {
  using Type = Pair;
};
template <int Order>
struct WithPairs<Jet<double, Order>> {
  using Type = Jet<Pair, Order>;
};
template <typename T>
struct WithPairs<Dual<T>> {
  using Type = Dual<typename WithPairs<T>::Type>;
};
template <typename T>
using PairOf = typename WithPairs<T>::Type;

/// Returns a scalar of pairs. Both elements are `x`.
[[nodiscard]] inline Pair Both(double x) noexcept { return {x, x}; }
template <int Order>
[[nodiscard]] Jet<Pair, Order> Both(const Jet<double, Order>& x) noexcept {
  Jet<Pair, Order> both;
  for (std::size_t i = 0; i < x.part.size(); ++i) {
    both.part[i] = Both(x.part[i]);
  }
  return both;
}
template <typename T>
[[nodiscard]] Dual<PairOf<T>> Both(const Dual<T>& x) noexcept {
  return {Both(x.value), Both(x.slope)};
}

/// Returns element `i` of a scalar of pairs.
[[nodiscard]] inline double Element(Pair x, std::size_t i) noexcept { return x[i]; }
template <int Order>
[[nodiscard]] Jet<double, Order> Element(const Jet<Pair, Order>& x, std::size_t i) noexcept {
  Jet<double, Order> element;
  for (std::size_t part = 0; part < x.part.size(); ++part) {
    element.part[part] = x.part[part][i];
  }
  return element;
}
template <typename T>
[[nodiscard]] auto Element(const Dual<T>& x, std::size_t i) noexcept
    -> Dual<decltype(Element(x.value, i))> {
  return {Element(x.value, i), Element(x.slope, i)};
}

/// Returns the number without its derivatives.
[[nodiscard]] inline double ValueOf(double x) noexcept { return x; }
template <int Order>
[[nodiscard]] double ValueOf(const Jet<double, Order>& x) noexcept {
  return x.part[kValue];
}
template <typename T>
[[nodiscard]] double ValueOf(const Dual<T>& x) noexcept {
  return ValueOf(x.value);
}

/// Returns the leaf without its derivatives.
[[nodiscard]] inline double LeafOf(double x) noexcept { return x; }
[[nodiscard]] inline Pair LeafOf(Pair x) noexcept { return x; }
template <typename L, int Order>
[[nodiscard]] L LeafOf(const Jet<L, Order>& x) noexcept {
  return x.part[kValue];
}
template <typename T>
[[nodiscard]] auto LeafOf(const Dual<T>& x) noexcept {
  return LeafOf(x.value);
}

/// Returns the largest number of a scalar, without derivatives.
[[nodiscard]] inline double LargestLeaf(double x) noexcept { return x; }
[[nodiscard]] inline double LargestLeaf(Pair x) noexcept { return x[0] < x[1] ? x[1] : x[0]; }
template <typename L, int Order>
[[nodiscard]] double LargestLeaf(const Jet<L, Order>& x) noexcept {
  return LargestLeaf(x.part[kValue]);
}
template <typename T>
[[nodiscard]] double LargestLeaf(const Dual<T>& x) noexcept {
  return LargestLeaf(x.value);
}

/// Returns f(x) from f, f' and f'' at the leaf of x. Order 1 does not use f''.
template <typename L, int Order>
[[nodiscard]] GIRDLE_INLINE Jet<L, Order> Composed(const Jet<L, Order>& x, L f, L slope,
                                                   L curvature) noexcept {
  Jet<L, Order> result;
  result.part[kValue] = f;
  for (std::size_t i = kByElevation; i < x.part.size(); ++i) {
    result.part[i] = slope * x.part[i];
  }
  if constexpr (Order == 2) {
    const L e = x.part[kByElevation];
    const L p = x.part[kByPlane];
    result.part[kByElevationTwice] = result.part[kByElevationTwice] + curvature * e * e;
    result.part[kByElevationAndPlane] = result.part[kByElevationAndPlane] + curvature * e * p;
    result.part[kByPlaneTwice] = result.part[kByPlaneTwice] + curvature * p * p;
  }
  return result;
}

template <typename L, int Order>
[[nodiscard]] SineAndCosine<Jet<L, Order>> SineAndCosineOf(const Jet<L, Order>& x) noexcept {
  const auto [sine, cosine] = SineAndCosineOf(x.part[kValue]);
  return {Composed(x, sine, cosine, -sine), Composed(x, cosine, -sine, -cosine)};
}
template <typename T>
[[nodiscard]] SineAndCosine<Dual<T>> SineAndCosineOf(const Dual<T>& x) noexcept {
  const auto [sine, cosine] = SineAndCosineOf(x.value);
  return {{sine, cosine * x.slope}, {cosine, -(sine * x.slope)}};
}

template <int Order>
[[nodiscard]] Jet<double, Order> Decay(const Jet<double, Order>& x) noexcept {
  const double value = Decay(x.part[kValue]);
  return Composed(x, value, -value, value);
}

template <typename T>
[[nodiscard]] Dual<T> Decay(const Dual<T>& x) noexcept {
  const T value = Decay(x.value);
  return {value, -(value * x.slope)};
}

/// Returns the angle of the point (x, y). Precondition: the point is not the origin.
template <int Order>
[[nodiscard]] Jet<double, Order> Atan2(const Jet<double, Order>& y,
                                       const Jet<double, Order>& x) noexcept {
  // a_i = (x y_i - y x_i) / r^2,  a_ij = ((x y_i - y x_i)_j - a_i (r^2)_j) / r^2
  const double Y = y.part[kValue];
  const double X = x.part[kValue];
  const double r_squared = X * X + Y * Y;
  Jet<double, Order> angle;
  angle.part[kValue] = std::atan2(Y, X);
  for (std::size_t i = kByElevation; i < angle.part.size(); ++i) {
    angle.part[i] = (X * y.part[i] - Y * x.part[i]) / r_squared;
  }
  if constexpr (Order == 2) {
    const auto correct = [&](JetPart ij, JetPart i, JetPart j) {
      const double turning = x.part[j] * y.part[i] - y.part[j] * x.part[i];
      const double growing = 2 * (X * x.part[j] + Y * y.part[j]);
      angle.part[ij] += (turning - angle.part[i] * growing) / r_squared;
    };
    correct(kByElevationTwice, kByElevation, kByElevation);
    correct(kByElevationAndPlane, kByElevation, kByPlane);
    correct(kByPlaneTwice, kByPlane, kByPlane);
  }
  return angle;
}

/// Returns the square root. Precondition: the number is positive.
template <int Order>
[[nodiscard]] Jet<double, Order> Sqrt(const Jet<double, Order>& x) noexcept {
  const double root = std::sqrt(x.part[kValue]);
  return Composed(x, root, 0.5 / root, -0.25 / (root * x.part[kValue]));
}

/// Returns the coefficients of the derivative of c_0 + c_1 x + c_2 x^2 + ...
template <std::size_t N>
[[nodiscard]] constexpr std::array<double, (N > 0 ? N - 1 : 0)> DerivativeOf(
    const std::array<double, N>& c) noexcept {
  std::array<double, (N > 0 ? N - 1 : 0)> derivative{};
  for (std::size_t i = 1; i < N; ++i) {
    derivative[i - 1] = static_cast<double>(i) * c[i];
  }
  return derivative;
}

/// Returns c_0 + c_1 x + c_2 x^2 + ...
template <std::size_t N>
[[nodiscard]] GIRDLE_INLINE double Polynomial(const std::array<double, N>& c, double x) noexcept {
  return PolynomialValue(c, x);
}
template <std::size_t N>
[[nodiscard]] GIRDLE_INLINE Pair Polynomial(const std::array<double, N>& c, Pair x) noexcept {
  return PolynomialValue(c, x);
}
template <std::size_t N, typename L, int Order>
[[nodiscard]] GIRDLE_INLINE Jet<L, Order> Polynomial(const std::array<double, N>& c,
                                                     const Jet<L, Order>& x) noexcept {
  const std::array slope = DerivativeOf(c);
  const L leaf = x.part[kValue];
  if constexpr (Order == 1) {
    return Composed(x, PolynomialValue(c, leaf), PolynomialValue(slope, leaf), L(0.0));
  } else {
    return Composed(x, PolynomialValue(c, leaf), PolynomialValue(slope, leaf),
                    PolynomialValue(DerivativeOf(slope), leaf));
  }
}
template <std::size_t N, typename T>
[[nodiscard]] Dual<T> Polynomial(const std::array<double, N>& c, const Dual<T>& x) noexcept {
  return {Polynomial(c, x.value), Polynomial(DerivativeOf(c), x.value) * x.slope};
}

}  // namespace girdle
