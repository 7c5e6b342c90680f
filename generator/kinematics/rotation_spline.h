// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Interpolation of unit quaternions as Kim et al. use it: slerp and squad.
///
/// Quaternions are taken with the sign they have: the curve from `a` to `b` takes the long way
/// round when a . b < 0. Align signs first (AlignedWith). Parameters t are in [0, 1]. W is the
/// length of an arc [rad], half the angle of the turn, and cos(W) = a . b.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "kinematics/pair.h"
#include "kinematics/rotation.h"
#include "kinematics/rotation_algebra.h"

namespace girdle {

/// Returns the point at t on the great arc from a to b, equation (1). At t = 0 and t = 1 it is a
/// and b exactly. Opposite quaternions (a = -b) have no unique arc; the result is then a finite
/// unit quaternion.
[[nodiscard]] Quaternion Slerp(const Quaternion& a, const Quaternion& b, double t) noexcept;

/// Returns the inner control point s_i of knot q_i between its neighbours, equation (5).
[[nodiscard]] Quaternion SquadControl(const Quaternion& q_previous, const Quaternion& q_i,
                                      const Quaternion& q_next) noexcept;

/// Returns the point at t on the spherical quadrangle curve from q_i to q_next, equation (4), with
/// the inner control points s_i and s_next.
[[nodiscard]] Quaternion Squad(const Quaternion& q_i, const Quaternion& q_next,
                               const Quaternion& s_i, const Quaternion& s_next, double t) noexcept;

/// A unit quaternion as a point of the unit sphere in four dimensions. Slerp and squad need no
/// product of quaternions: they are sums of points with weights.
struct SpherePoint {
  Pair xy;
  Pair zw;

  SpherePoint() = default;
  SpherePoint(Pair xy_in, Pair zw_in) noexcept : xy(xy_in), zw(zw_in) {}
  explicit SpherePoint(const Quaternion& q) noexcept : xy(q.x, q.y), zw(q.z, q.w) {}

  [[nodiscard]] Quaternion quaternion() const noexcept { return {zw[1], xy[0], xy[1], zw[0]}; }

  friend SpherePoint operator+(const SpherePoint& a, const SpherePoint& b) noexcept {
    return {a.xy + b.xy, a.zw + b.zw};
  }
  friend SpherePoint operator*(double factor, const SpherePoint& a) noexcept {
    return {factor * a.xy, factor * a.zw};
  }
  [[nodiscard]] friend double Dot(const SpherePoint& a, const SpherePoint& b) noexcept {
    const Pair sum = a.xy * b.xy + a.zw * b.zw;
    return sum[0] + sum[1];
  }
};

/// N rotations that are interpolated with the same t. Evaluated together they take little longer
/// than one: each alone would wait for the last term of its own series.
template <std::size_t N>
using SpherePoints = std::array<SpherePoint, N>;

/// How long the arcs between N pairs of points are.
template <std::size_t N>
struct ArcLengths {
  std::array<double, N> cosine_less_one;  ///< cos(W) - 1, in [-2, 0] but for rounding
  double least;                           ///< of these: the longest arc's

  ArcLengths() = default;
  ArcLengths(const SpherePoints<N>& a, const SpherePoints<N>& b) noexcept
      : cosine_less_one{}, least(0) {
    for (std::size_t k = 0; k < N; ++k) {
      cosine_less_one[k] = Dot(a[k], b[k]) - 1;
      least = std::min(least, cosine_less_one[k]);
    }
  }
};

/// Great arcs from each of N points to each of N others, with what does not depend on t: along a
/// series of knots that stays the same it can be kept. Refers to the points.
template <std::size_t N>
struct Arcs {
  const SpherePoints<N>& from;
  const SpherePoints<N>& to;
  const ArcLengths<N>& lengths;

  /// As Slerp, for each.
  [[nodiscard]] SpherePoints<N> At(double t) const noexcept;
};

/// As for quaternions, for each. Precondition: `before` ends where `after` starts.
template <std::size_t N>
[[nodiscard]] SpherePoints<N> SquadControl(const Arcs<N>& before, const Arcs<N>& after) noexcept;

/// As for quaternions, for each.
template <std::size_t N>
[[nodiscard]] SpherePoints<N> Squad(const Arcs<N>& knots, const Arcs<N>& controls,
                                    double t) noexcept;

namespace rotation_spline_detail {

// sin(t W) / sin(W) as a power series in y = cos(W) - 1, which needs neither W nor a sine:
//   sin(t W) / sin(W) = t (1 + c_1 y (1 + c_2 y (1 + ...))),   c_i = t^2 / (i (2i+1)) - i / (2i+1)
// (D. Eberly, A Fast and Accurate Algorithm for Computing SLERP, J. Graphics Tools 2011;15:161).
// Returns `scale` times the coefficients of y^0, y^1, ...; exactly 1 and zeros at t = 1. For t = 0
// and a scale of 1 they are those of the limit W / sin(W).
template <std::size_t Terms, typename Scalar>
GIRDLE_INLINE constexpr std::array<Scalar, Terms> SeriesCoefficients(Scalar scale,
                                                                     Scalar t_squared) noexcept {
  std::array<Scalar, Terms> coefficients{};
  coefficients[0] = scale;
  for (std::size_t i = 1; i < Terms; ++i) {
    const double n = static_cast<double>(i);
    coefficients[i] =
        coefficients[i - 1] * ((1 / (n * (2 * n + 1))) * t_squared - n / (2 * n + 1));
  }
  return coefficients;
}

template <std::size_t Terms>
struct Series {
  static constexpr std::size_t kTerms = Terms;
};

// Calls `near` with the series for arcs with cos(W) - 1 down to `least`, or `far` where there is
// none. In each case the first term left out, at most n! / (2n+1)!! |y|^n, is below 1e-16, half a
// unit in the last place. Squad's inner arcs are very short, neighbours along elevation short.
template <typename Near, typename Far>
GIRDLE_INLINE auto WithSeries(double least, Near near, Far far) noexcept {
  if (least > -1e-5) {
    return near(Series<3>());
  }
  if (least > -5e-3) {
    return near(Series<6>());
  }
  if (least > -0.035) {
    return near(Series<9>());
  }
  if (least > -0.12) {
    return near(Series<13>());
  }
  if (least > -0.3) {
    return near(Series<19>());
  }
  return far();
}

[[nodiscard]] SpherePoint TrigonometricSlerp(const SpherePoint& a, const SpherePoint& b,
                                             double t) noexcept;

/// W / sin(W), and for W beyond a right angle W - pi in place of W: the logarithm's choice of sign.
[[nodiscard]] double TrigonometricArcOverSine(double cosine) noexcept;

}  // namespace rotation_spline_detail

// slerp(a, b, t) = sin((1-t)W)/sin(W) a + sin(tW)/sin(W) b                                      (1)
template <std::size_t N>
GIRDLE_INLINE SpherePoints<N> Arcs<N>::At(double t) const noexcept {
  using namespace rotation_spline_detail;  // NOLINT(google-build-using-namespace): the series
  const auto by_series = [&](auto series) noexcept {
    const Pair u_and_t{1 - t, t};
    const auto coefficients = SeriesCoefficients<series.kTerms>(u_and_t, u_and_t * u_and_t);
    SpherePoints<N> points;
    for (std::size_t k = 0; k < N; ++k) {
      const Pair weights = PolynomialValue(coefficients, Pair(lengths.cosine_less_one[k]));
      points[k] = weights[0] * from[k] + weights[1] * to[k];
    }
    return points;
  };
  // One far pair among near ones: each goes its own way.
  const auto one_by_one = [&]() noexcept {
    SpherePoints<N> points;
    for (std::size_t k = 0; k < N; ++k) {
      if constexpr (N == 1) {
        points[k] = TrigonometricSlerp(from[k], to[k], t);
      } else {
        const SpherePoints<1> a{from[k]};
        const SpherePoints<1> b{to[k]};
        points[k] = Arcs<1>{a, b, ArcLengths<1>(a, b)}.At(t)[0];
      }
    }
    return points;
  };
  return WithSeries(lengths.least, by_series, one_by_one);
}

// s_i = q_i exp(-(log(q_i^-1 q_i+1) + log(q_i^-1 q_i-1)) / 4)                                   (5)
//
// A product with q_i turns the sphere and takes 1 to q_i, and the vectors at 1 to those at q_i:
//   q_i log(q_i^-1 q) = 2 W/sin(W) (q - cos(W) q_i),   q_i exp(2 v) = cos|v| q_i + sin|v|/|v| q_i v
template <std::size_t N>
GIRDLE_INLINE SpherePoints<N> SquadControl(const Arcs<N>& before, const Arcs<N>& after) noexcept {
  using namespace rotation_spline_detail;  // NOLINT(google-build-using-namespace): the series
  const auto cosines_less_one = [&](std::size_t k) noexcept {
    return Pair(before.lengths.cosine_less_one[k], after.lengths.cosine_less_one[k]);
  };
  const auto by_series = [&](auto series) noexcept {
    constexpr auto kCoefficients = SeriesCoefficients<series.kTerms>(1.0, 0.0);
    std::array<Pair, N> arc_over_sine;
    for (std::size_t k = 0; k < N; ++k) {
      arc_over_sine[k] = PolynomialValue(kCoefficients, cosines_less_one(k));
    }
    return arc_over_sine;
  };
  const auto one_by_one = [&]() noexcept {
    std::array<Pair, N> arc_over_sine;
    for (std::size_t k = 0; k < N; ++k) {
      const Pair cosines = 1 + cosines_less_one(k);
      arc_over_sine[k] = {TrigonometricArcOverSine(cosines[0]),
                          TrigonometricArcOverSine(cosines[1])};
    }
    return arc_over_sine;
  };
  const std::array<Pair, N> arc_over_sine = WithSeries(
      std::min(before.lengths.least, after.lengths.least), by_series, one_by_one);
  SpherePoints<N> controls;
  for (std::size_t k = 0; k < N; ++k) {
    const SpherePoint& q_i = after.from[k];
    const Pair weights = -0.25 * arc_over_sine[k];
    const Pair of_q_i = weights * (1 + cosines_less_one(k));
    const SpherePoint v = weights[0] * before.from[k] + weights[1] * after.to[k] +
                          -(of_q_i[0] + of_q_i[1]) * q_i;
    const CosineAndSine<double> exp = CosineAndSineOfRoot(Dot(v, v));
    controls[k] = exp.cosine * q_i + exp.sine_over_root * v;
  }
  return controls;
}

// squad(q_i, q_i+1, t) = slerp(slerp(q_i, q_i+1, t), slerp(s_i, s_i+1, t), 2t(1-t))             (4)
template <std::size_t N>
GIRDLE_INLINE SpherePoints<N> Squad(const Arcs<N>& knots, const Arcs<N>& controls,
                                    double t) noexcept {
  const SpherePoints<N> outer = knots.At(t);
  const SpherePoints<N> inner = controls.At(t);
  return Arcs<N>{outer, inner, ArcLengths<N>(outer, inner)}.At(2 * t * (1 - t));
}

}  // namespace girdle
