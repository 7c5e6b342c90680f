// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Unit quaternions and rotation vectors over the scalars of jet.h.
///
/// Frames are in the names, as in rotation.h: `q_AB` turns vectors of frame B into frame A. A
/// rotation vector is axis times angle [rad].
#pragma once

#include <array>
#include <cstddef>

#include "kinematics/jet.h"
#include "kinematics/lane_functions.h"
#include "kinematics/rotation.h"

namespace girdle {

template <typename T>
using VectorOf = std::array<T, 3>;

template <typename T>
[[nodiscard]] VectorOf<T> operator+(const VectorOf<T>& a, const VectorOf<T>& b) noexcept {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
template <typename T>
[[nodiscard]] VectorOf<T> operator-(const VectorOf<T>& a, const VectorOf<T>& b) noexcept {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <typename T>
[[nodiscard]] VectorOf<T> Scaled(const T& factor, const VectorOf<T>& v) noexcept {
  return {factor * v[0], factor * v[1], factor * v[2]};
}

/// Unit quaternion over a scalar.
template <typename T>
struct QuaternionOf {
  T w;
  T x;
  T y;
  T z;

  [[nodiscard]] VectorOf<T> vector() const noexcept { return {x, y, z}; }
};

/// Returns a product. The second factor may be over leaves, if that rotation is constant.
template <typename T, typename U>
[[nodiscard]] GIRDLE_INLINE QuaternionOf<T> operator*(const QuaternionOf<T>& a,
                                                      const QuaternionOf<U>& b) noexcept {
  return {
      a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
      a.w * b.y + a.y * b.w + a.z * b.x - a.x * b.z, a.w * b.z + a.z * b.w + a.x * b.y - a.y * b.x};
}

template <typename T>
[[nodiscard]] QuaternionOf<T> Inverse(const QuaternionOf<T>& q) noexcept {
  return {q.w, -q.x, -q.y, -q.z};
}

/// Returns element `i` of a rotation over pairs.
template <typename P>
[[nodiscard]] auto Element(const QuaternionOf<P>& q, std::size_t i) noexcept
    -> QuaternionOf<decltype(Element(q.w, i))> {
  return {Element(q.w, i), Element(q.x, i), Element(q.y, i), Element(q.z, i)};
}

namespace rotation_algebra_detail {

using lane_functions_detail::AlternatingSeries;

// arccos(1 - y) / sqrt(1 - (1 - y)^2) = sum n! / (2n + 1)!! y^n, for 0 <= y < 2.
template <std::size_t N>
constexpr std::array<double, N> ArcCosineSeries() {
  std::array<double, N> coefficients{};
  long double term = 1;
  for (std::size_t n = 0; n < N; ++n) {
    coefficients[n] = static_cast<double>(term);
    term *= static_cast<long double>(n + 1) / static_cast<long double>(2 * n + 3);
  }
  return coefficients;
}

// For angles up to half a turn (x <= (pi/2)^2) the first term left out is below 1e-16. Shorter
// series are as precise for angles up to 72 deg (nearly all of GH) and up to 25 deg (nearly all of
// SC and AC).
inline constexpr std::size_t kExpTerms = 13;
inline constexpr auto kCosine = AlternatingSeries<kExpTerms>(0);
inline constexpr auto kSine = AlternatingSeries<kExpTerms>(1);
inline constexpr double kShortSeriesLimit = 0.4;
inline constexpr std::size_t kShortExpTerms = 8;
inline constexpr auto kShortCosine = AlternatingSeries<kShortExpTerms>(0);
inline constexpr auto kShortSine = AlternatingSeries<kShortExpTerms>(1);
inline constexpr double kShorterSeriesLimit = 0.05;
inline constexpr std::size_t kShorterExpTerms = 6;
inline constexpr auto kShorterCosine = AlternatingSeries<kShorterExpTerms>(0);
inline constexpr auto kShorterSine = AlternatingSeries<kShorterExpTerms>(1);

// 6 (W - sin W)/W^3 in powers of W^2, for the angles of kSine and kShortSine.
inline constexpr auto kThird = AlternatingSeries<kExpTerms>(3);
inline constexpr auto kShortThird = AlternatingSeries<kShortExpTerms + 1>(3);

// For angles up to 90 deg (y <= 0.293) the first term left out is below 1e-17. At 150 deg it is
// 1e-10.
inline constexpr std::size_t kLogTerms = 24;
inline constexpr auto kArcCosineOverSine = ArcCosineSeries<kLogTerms>();

}  // namespace rotation_algebra_detail

/// cos(sqrt x) and sin(sqrt x) / sqrt x, for 0 <= x <= (pi/2)^2.
template <typename T>
struct CosineAndSine {
  T cosine;
  T sine_over_root;
};

/// Evaluates the series at a leaf.
template <typename L>
[[nodiscard]] GIRDLE_INLINE CosineAndSine<L> CosineAndSineOfRoot(L x) noexcept {
  using namespace rotation_algebra_detail;  // NOLINT(google-build-using-namespace): its constants
  const double largest = LargestLeaf(x);
  if (largest < kShorterSeriesLimit) {
    return {PolynomialValue(kShorterCosine, x), PolynomialValue(kShorterSine, x)};
  }
  if (largest < kShortSeriesLimit) {
    return {PolynomialValue(kShortCosine, x), PolynomialValue(kShortSine, x)};
  }
  return {PolynomialValue(kCosine, x), PolynomialValue(kSine, x)};
}
/// Evaluates the series at a jet. The derivative of the cosine is -1/2 times the other function.
template <typename L, int Order>
[[nodiscard]] GIRDLE_INLINE CosineAndSine<Jet<L, Order>> CosineAndSineOfRoot(
    const Jet<L, Order>& x) noexcept {
  using namespace rotation_algebra_detail;  // NOLINT(google-build-using-namespace): its constants
  const L leaf = x.part[kValue];
  const CosineAndSine<L> value = CosineAndSineOfRoot(leaf);
  const bool is_short = LargestLeaf(leaf) < kShortSeriesLimit;
  const L slope = is_short ? PolynomialValue(DerivativeOf(kShortSine), leaf)
                           : PolynomialValue(DerivativeOf(kSine), leaf);
  const L curvature =
      Order == 2 ? PolynomialValue(DerivativeOf(DerivativeOf(kSine)), leaf) : L(0.0);
  return {Composed(x, value.cosine, -0.5 * value.sine_over_root, -0.5 * slope),
          Composed(x, value.sine_over_root, slope, curvature)};
}
template <typename T>
[[nodiscard]] CosineAndSine<Dual<T>> CosineAndSineOfRoot(const Dual<T>& x) noexcept {
  const CosineAndSine<T> value = CosineAndSineOfRoot(x.value);
  const T slope = Polynomial(DerivativeOf(rotation_algebra_detail::kSine), x.value);
  return {{value.cosine, -0.5 * (value.sine_over_root * x.slope)},
          {value.sine_over_root, slope * x.slope}};
}

/// Returns the unit quaternion of a rotation vector. Precondition: at most half a turn. For longer
/// vectors its norm departs from 1.
///
///     exp(u) = (cos |u|/2, sin(|u|/2) u/|u|)
template <typename T>
[[nodiscard]] GIRDLE_INLINE QuaternionOf<T> ExpOf(const VectorOf<T>& u) noexcept {
  const CosineAndSine<T> half =
      CosineAndSineOfRoot(0.25 * (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]));
  const T scale = 0.5 * half.sine_over_root;
  return {half.cosine, scale * u[0], scale * u[1], scale * u[2]};
}

/// A rotation exp(u) m with constant m, and its angular velocities in the parent's axes: w_1 when u
/// changes by u_1, w_2 when it changes by u_2. L is a leaf.
template <typename L>
struct MovingRotation {
  QuaternionOf<L> q;
  VectorOf<L> w_1;
  VectorOf<L> w_2;
};

template <typename T>
[[nodiscard]] T Dot(const VectorOf<T>& a, const VectorOf<T>& b) noexcept {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <typename L>
[[nodiscard]] GIRDLE_INLINE VectorOf<L> Cross(const VectorOf<L>& a, const VectorOf<L>& b) noexcept {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Returns exp(u) m with its angular velocities for the changes u_1 and u_2 of u. With W = |u|:
///
///     w_i = u_i + (1 - cos W)/W^2 u x u_i + (W - sin W)/W^3 u x (u x u_i)
///
/// This is the left Jacobian of the rotation group, with (1 - cos W)/W^2 = (sin(W/2)/(W/2))^2 / 2.
template <typename L>
[[nodiscard]] GIRDLE_INLINE MovingRotation<L> MovingExp(const VectorOf<L>& u,
                                                        const VectorOf<L>& u_1,
                                                        const VectorOf<L>& u_2,
                                                        const QuaternionOf<L>& m) noexcept {
  using namespace rotation_algebra_detail;  // NOLINT(google-build-using-namespace): its constants
  const L square = u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
  const L x = 0.25 * square;
  const CosineAndSine<L> half = CosineAndSineOfRoot(x);
  const L scale = 0.5 * half.sine_over_root;
  const L second = scale * half.sine_over_root;
  const L third =
      (1.0 / 6) * (LargestLeaf(x) < kShortSeriesLimit ? PolynomialValue(kShortThird, square)
                                                      : PolynomialValue(kThird, square));
  const auto velocity = [&](const VectorOf<L>& rate) {
    const VectorOf<L> once = Cross(u, rate);
    return rate + Scaled(second, once) + Scaled(third, Cross(u, once));
  };
  const QuaternionOf<L> exp{half.cosine, scale * u[0], scale * u[1], scale * u[2]};
  return {exp * m, velocity(u_1), velocity(u_2)};
}

/// A rotation and its angular velocity in the parent's axes.
template <typename P>
struct TurningRotation {
  QuaternionOf<P> q;
  VectorOf<P> w;
};

/// Returns exp(u) m with its angular velocity when u changes by u_1. The formula is that of
/// MovingExp, over any scalar.
template <typename P, typename M>
[[nodiscard]] TurningRotation<P> TurningExp(const VectorOf<P>& u, const VectorOf<P>& u_1,
                                            const QuaternionOf<M>& m) noexcept {
  const P square = u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
  const CosineAndSine<P> half = CosineAndSineOfRoot(P(0.25 * square));
  const P scale = 0.5 * half.sine_over_root;
  const P second = scale * half.sine_over_root;
  const P third = (1.0 / 6) * Polynomial(rotation_algebra_detail::kThird, square);
  const VectorOf<P> once = Cross(u, u_1);
  const QuaternionOf<P> exp{half.cosine, scale * u[0], scale * u[1], scale * u[2]};
  return {exp * m, u_1 + Scaled(second, once) + Scaled(third, Cross(u, once))};
}

/// Returns -1 for negative numbers, otherwise 1.
[[nodiscard]] inline double SignOf(double x) noexcept { return x < 0 ? -1 : 1; }
[[nodiscard]] inline Pair SignOf(Pair x) noexcept { return Pair::WhereLess(x, 0.0, -1.0, 1.0); }

/// Returns the rotation vector of a unit quaternion. The series is exact to rounding for angles up
/// to 90 deg.
///
///     log(w, v) = 2 arccos(w)/sqrt(1 - w^2) v, with the sign of q chosen so that w >= 0
template <typename T>
[[nodiscard]] VectorOf<T> LogOf(const QuaternionOf<T>& q) noexcept {
  const auto sign = SignOf(LeafOf(q.w));
  const T factor =
      2.0 * Polynomial(rotation_algebra_detail::kArcCosineOverSine, T(1.0) - sign * q.w);
  return Scaled(sign * factor, q.vector());
}

/// Returns the rotation by an angle about y.
template <typename T>
[[nodiscard]] QuaternionOf<T> AboutYOf(const T& angle_rad) noexcept {
  const SineAndCosine<T> half = SineAndCosineOf(T(0.5 * angle_rad));
  return {half.cosine, T(0.0), half.sine, T(0.0)};
}

/// Returns the angular velocity of the child in the parent along the dual's line, in the axes of
/// the parent: w = 2 dq q^-1.
template <typename T>
[[nodiscard]] VectorOf<T> ParentVelocity(const QuaternionOf<Dual<T>>& q) noexcept {
  const QuaternionOf<T> value{q.w.value, q.x.value, q.y.value, q.z.value};
  const QuaternionOf<T> slope{q.w.slope, q.x.slope, q.y.slope, q.z.slope};
  return Scaled(T(2.0), (slope * Inverse(value)).vector());
}

/// Returns the rotation without its slope.
template <typename T>
[[nodiscard]] QuaternionOf<T> ValueOf(const QuaternionOf<Dual<T>>& q) noexcept {
  return {q.w.value, q.x.value, q.y.value, q.z.value};
}

}  // namespace girdle
