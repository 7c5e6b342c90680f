// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Interpolation of unit quaternions as Kim et al. use it: slerp and squad.
///
/// A quaternion keeps its sign: the curve from `a` to `b` takes the long way round when a . b < 0.
/// Align signs first (AlignedWith). Parameters t are in [0, 1]. W is the length of an arc [rad],
/// which is half the angle of the turn: cos(W) = a . b.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "kinematics/pair.h"
#include "kinematics/rotation.h"
#include "kinematics/rotation_algebra.h"

namespace girdle {

/// Returns the point at t on the great arc from a to b, equation (1). It is exactly a at t = 0 and
/// exactly b at t = 1. Opposite quaternions (a = -b) have no unique arc; the result is then a
/// finite unit quaternion.
[[nodiscard]] Quaternion Slerp(const Quaternion& a, const Quaternion& b, double t) noexcept;

/// Returns the inner control point s_i of knot q_i with its two neighbours, equation (5).
[[nodiscard]] Quaternion SquadControl(const Quaternion& q_previous, const Quaternion& q_i,
                                      const Quaternion& q_next) noexcept;

/// Returns the point at t on the spherical quadrangle curve from q_i to q_next, equation (4). Its
/// inner control points are s_i and s_next.
[[nodiscard]] Quaternion Squad(const Quaternion& q_i, const Quaternion& q_next,
                               const Quaternion& s_i, const Quaternion& s_next, double t) noexcept;

/// A unit quaternion as a point of the unit sphere in four dimensions. Slerp and squad are weighted
/// sums of such points and need no product of quaternions.
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

/// Several great arcs, each from one point to another. Only refers to points and lengths, which are
/// stored elsewhere.
///
/// Arcs that are divided at the same t are evaluated together. One arc alone would compute the
/// series for t again and would wait for its last term. The lengths do not depend on t, so they can
/// be stored with the points.
struct Arcs {
  std::span<const SpherePoint> from;
  std::span<const SpherePoint> to;
  std::span<const double> cosine_less_one;  ///< cos(W) - 1 of each arc, in [-2, 0] up to rounding
  double least;                             ///< lower bound of `cosine_less_one`

  [[nodiscard]] Arcs Part(std::size_t first, std::size_t count) const noexcept {
    return {from.subspan(first, count), to.subspan(first, count),
            cosine_less_one.subspan(first, count), least};
  }

  /// Computes Slerp of each arc at t. Precondition: as many `points` as arcs.
  void At(double t, std::span<SpherePoint> points) const noexcept;
};

/// Returns the arcs between two sets of points and writes their lengths into `cosine_less_one`.
/// Precondition: the three spans have the same size.
[[nodiscard]] Arcs MeasuredArcs(std::span<const SpherePoint> from, std::span<const SpherePoint> to,
                                std::span<double> cosine_less_one) noexcept;

/// Computes SquadControl of each knot. The arc `before` ends at the knot and the arc `after` starts
/// at it. Precondition: as many arcs of each kind as controls.
void SquadControl(const Arcs& before, const Arcs& after, std::span<SpherePoint> controls) noexcept;

/// Computes Squad of each arc at t. Precondition: as many knots, controls and points, at most
/// MostArcs.
template <std::size_t MostArcs>
void Squad(const Arcs& knots, const Arcs& controls, double t,
           std::span<SpherePoint> points) noexcept;

namespace rotation_spline_detail {

// sin(t W) / sin(W) as a power series in y = cos(W) - 1, which needs neither W nor a sine:
//   sin(t W) / sin(W) = t (1 + c_1 y (1 + c_2 y (1 + ...))),   c_i = t^2 / (i (2i+1)) - i / (2i+1)
// (D. Eberly, A Fast and Accurate Algorithm for Computing SLERP, J. Graphics Tools 2011;15:161).
// Returns the coefficients of y^0, y^1, ... times `scale` / t. At t = 1 they are exactly 1, 0, 0,
// ... At t = 0, with a scale of 1, they are those of the limit W / sin(W).
template <std::size_t Terms, typename Scalar>
GIRDLE_INLINE constexpr std::array<Scalar, Terms> SeriesCoefficients(Scalar scale,
                                                                     Scalar t_squared) noexcept {
  std::array<Scalar, Terms> coefficients{};
  coefficients[0] = scale;
  for (std::size_t n = 1; n < Terms; ++n) {
    const double i = static_cast<double>(n);
    const Scalar c_i = 1 / (i * (2 * i + 1)) * t_squared - i / (2 * i + 1);
    coefficients[n] = coefficients[n - 1] * c_i;
  }
  return coefficients;
}

// The series of slerp's two weights.
template <std::size_t Terms>
GIRDLE_INLINE std::array<Pair, Terms> SlerpCoefficients(double t) noexcept {
  const Pair u_and_t{1 - t, t};
  return SeriesCoefficients<Terms>(u_and_t, u_and_t * u_and_t);
}

template <std::size_t Terms>
struct Series {
  static constexpr std::size_t kTerms = Terms;
};

// Calls `near` with the series for arcs whose cos(W) - 1 is at least `least`. Calls `far` if that
// series would be long. The first term left out is at most n! / (2n+1)!! |least|^n, in each case
// below 1e-16, half a unit in the last place. In the measured table neighbours along elevation are
// within the second limit, neighbours along plane within the third, and squad's inner arcs within
// the first. The choice is therefore the same for all cells of the table, and a processor can
// predict it.
template <typename Near, typename Far>
GIRDLE_INLINE void WithSeries(double least, Near near, Far far) noexcept {
  if (least > -2e-4) {
    near(Series<4>());
  } else if (least > -5e-3) {
    near(Series<6>());
  } else if (least > -0.035) {
    near(Series<9>());
  } else if (least > -0.12) {
    near(Series<13>());
  } else if (least > -0.3) {
    near(Series<19>());
  } else {
    far();
  }
}

/// Slerp of arcs, computed one by one. Used for sets with a far arc.
void SlerpOneByOne(const Arcs& arcs, double t, std::span<SpherePoint> points) noexcept;

/// W / sin(W). If W is more than a right angle, W - pi replaces W: the logarithm's choice of sign.
[[nodiscard]] double TrigonometricArcOverSine(double cosine) noexcept;

// Slerp of near arcs.
template <std::size_t Terms>
GIRDLE_INLINE void SlerpBySeries(const Arcs& arcs, const std::array<Pair, Terms>& coefficients,
                                 std::span<SpherePoint> points) noexcept {
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Pair weights = PolynomialValue(coefficients, Pair(arcs.cosine_less_one[k]));
    points[k] = weights[0] * arcs.from[k] + weights[1] * arcs.to[k];
  }
}

}  // namespace rotation_spline_detail

GIRDLE_INLINE Arcs MeasuredArcs(std::span<const SpherePoint> from, std::span<const SpherePoint> to,
                                std::span<double> cosine_less_one) noexcept {
  double least = 0;
  for (std::size_t k = 0; k < from.size(); ++k) {
    const double value = Dot(from[k], to[k]) - 1;
    cosine_less_one[k] = value;
    least = std::min(least, value);
  }
  return {from, to, cosine_less_one, least};
}

// slerp(a, b, t) = sin((1-t)W)/sin(W) a + sin(tW)/sin(W) b                                      (1)
GIRDLE_INLINE void Arcs::At(double t, std::span<SpherePoint> points) const noexcept {
  using namespace rotation_spline_detail;  // NOLINT(google-build-using-namespace): the series
  const auto near = [&](auto series) noexcept {
    SlerpBySeries(*this, SlerpCoefficients<series.kTerms>(t), points);
  };
  const auto far = [&]() noexcept { SlerpOneByOne(*this, t, points); };
  WithSeries(least, near, far);
}

// s_i = q_i exp(-(log(q_i^-1 q_i+1) + log(q_i^-1 q_i-1)) / 4)                                   (5)
//
// A product with q_i turns the sphere and takes 1 to q_i, and the vectors at 1 to those at q_i:
//   q_i log(q_i^-1 q) = 2 W/sin(W) (q - cos(W) q_i),   q_i exp(2 v) = cos|v| q_i + sin|v|/|v| q_i v
GIRDLE_INLINE void SquadControl(const Arcs& before, const Arcs& after,
                                std::span<SpherePoint> controls) noexcept {
  using namespace rotation_spline_detail;  // NOLINT(google-build-using-namespace): the series
  const auto with_arcs_over_sine = [&](auto arcs_over_sine) noexcept {
    for (std::size_t k = 0; k < controls.size(); ++k) {
      const SpherePoint& q_i = after.from[k];
      const Pair cosines_less_one{before.cosine_less_one[k], after.cosine_less_one[k]};
      const Pair weights = -0.25 * arcs_over_sine(cosines_less_one);
      const Pair of_q_i = weights * (1 + cosines_less_one);
      const SpherePoint v =
          weights[0] * before.from[k] + weights[1] * after.to[k] + -(of_q_i[0] + of_q_i[1]) * q_i;
      const CosineAndSine<double> exp = CosineAndSineOfRoot(Dot(v, v));
      controls[k] = exp.cosine * q_i + exp.sine_over_root * v;
    }
  };
  const auto by_series = [&](auto series) noexcept {
    constexpr auto kCoefficients = SeriesCoefficients<series.kTerms>(1.0, 0.0);
    with_arcs_over_sine([&](Pair x) noexcept { return PolynomialValue(kCoefficients, x); });
  };
  const auto far = [&]() {
    with_arcs_over_sine([](Pair x) {
      return Pair(TrigonometricArcOverSine(1 + x[0]), TrigonometricArcOverSine(1 + x[1]));
    });
  };
  WithSeries(std::min(before.least, after.least), by_series, far);
}

// squad(q_i, q_i+1, t) = slerp(slerp(q_i, q_i+1, t), slerp(s_i, s_i+1, t), 2t(1-t))             (4)
template <std::size_t MostArcs>
GIRDLE_INLINE void Squad(const Arcs& knots, const Arcs& controls, double t,
                         std::span<SpherePoint> points) noexcept {
  using namespace rotation_spline_detail;  // NOLINT(google-build-using-namespace): the series
  std::array<SpherePoint, MostArcs> outer;
  std::array<SpherePoint, MostArcs> inner;
  std::array<double, MostArcs> lengths;  // NOLINT(*-member-init): filled below
  const std::size_t count = points.size();
  const auto near = [&](auto series) noexcept {
    const auto coefficients = SlerpCoefficients<series.kTerms>(t);
    SlerpBySeries(knots, coefficients, {outer.data(), count});
    SlerpBySeries(controls, coefficients, {inner.data(), count});
  };
  const auto far = [&]() noexcept {
    SlerpOneByOne(knots, t, {outer.data(), count});
    SlerpOneByOne(controls, t, {inner.data(), count});
  };
  WithSeries(std::min(knots.least, controls.least), near, far);
  MeasuredArcs({outer.data(), count}, {inner.data(), count}, {lengths.data(), count})
      .At(2 * t * (1 - t), points);
}

}  // namespace girdle
