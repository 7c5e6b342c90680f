// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Definitions of SmoothRhythm's templates, for every scalar type. Only smooth_rhythm.cc and
/// solve_many.cc include this file.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>

#include "kinematics/four.h"
#include "kinematics/smooth_rhythm.h"

namespace girdle {

namespace smooth_rhythm_detail {

// ---- The rule's constants, from the in-vivo sets named in smooth_rhythm.h.

// Turn of clavicle and scapula (in AC) about the parent's y, per degree that a level arm goes
// beyond the last plane. Bourne's scapula turns by 0.5 to 0.6, three times the table's last slope.
inline constexpr std::array<double, 2> kAcross = {0.34, 0.11};
// The table's own slope fades out over this angle beyond the first or last plane.
inline constexpr double kPlaneFading_rad = 5 * kRadiansPerDegree;

// The two arguments as scalars of type T: numbers, or the variables of jets.
template <typename T>
struct Variables {
  T elevation_rad;
  T plane_rad;
};
template <typename T>
Variables<T> VariablesAt(double elevation_rad, double plane_rad) noexcept {
  Variables<T> variables{T(elevation_rad), T(plane_rad)};
  if constexpr (!std::is_same_v<T, double>) {
    variables.elevation_rad.part[kByElevation] = 1;
    variables.plane_rad.part[kByPlane] = 1;
  }
  return variables;
}

// Returns the surfaces at the point itself, by the fastest way.
template <typename T, typename L, std::size_t K>
GIRDLE_INLINE auto AtPoint(const SurfaceSpline<L, K>& surface,
                           const SurfaceGrid::Place& place) noexcept {
  if constexpr (std::is_same_v<T, double>) {
    return surface.At(place);
  } else {
    return surface.template JetsAt < T::kParts == 3 ? 1 : 2 > (place);
  }
}

// Returns the number of one pose. A double is equal for all four poses.
GIRDLE_INLINE double OfPose(double x, std::size_t /*pose*/) noexcept { return x; }
GIRDLE_INLINE double OfPose(const Four& x, std::size_t pose) noexcept { return x[pose]; }

template <typename T>
GIRDLE_INLINE QuaternionOf<T> FromMeanBy(const VectorOf<T>& u,
                                         const QuaternionOf<Pair>& mean) noexcept {
  return ExpOf(u) * mean;
}

// Step is 3 s^2 - 2 s^3: from 0 to 1, with slope 0 at both ends. Start is s - 2 s^2 + s^3: 0 at
// both ends, with slope 1 at s = 0 and slope 0 at s = 1.
template <typename T>
T Step(const T& s) noexcept {
  return s * s * (T(3.0) - 2.0 * s);
}
template <typename T>
T Start(const T& s) noexcept {
  const T left = T(1.0) - s;
  return s * left * left;
}

// Returns a constant rotation as a rotation over T.
template <typename T>
QuaternionOf<PairOf<T>> Constant(const QuaternionOf<Pair>& q) noexcept {
  using P = PairOf<T>;
  return {P(q.w), P(q.x), P(q.y), P(q.z)};
}
template <typename T>
QuaternionOf<Dual<PairOf<T>>> Constant(const QuaternionOf<Dual<Pair>>& q) noexcept {
  using P = PairOf<T>;
  return {{P(q.w.value), P(q.w.slope)},
          {P(q.x.value), P(q.x.slope)},
          {P(q.y.value), P(q.y.slope)},
          {P(q.z.value), P(q.z.slope)}};
}

}  // namespace smooth_rhythm_detail

// ---- Within the table.

template <typename T, std::size_t I, std::size_t J, typename E, typename P>
SmoothRhythm::Surfaces<T> SmoothRhythm::SurfacesAt(const E& elevation_rad,
                                                   const P& plane_rad) const noexcept {
  if constexpr (std::is_same_v<T, Four>) {
    return SurfacesOfFour<I, J>(elevation_rad, plane_rad);
  } else {
    return {Evaluate<I, J>(girdle_, grid_, elevation_rad, plane_rad),
            Evaluate<I, J>(turn_, grid_, elevation_rad, plane_rad)[0]};
  }
}

template <std::size_t I, std::size_t J, typename E, typename P>
SmoothRhythm::Surfaces<Four> SmoothRhythm::SurfacesOfFour(const E& elevation_rad,
                                                          const P& plane_rad) const noexcept {
  using smooth_rhythm_detail::OfPose;
  std::array<SurfaceSpline<Four, 2>::Values, Four::kSize> of_pose;
  for (std::size_t i = 0; i < Four::kSize; ++i) {
    const auto place = grid_.PlaceOf(OfPose(elevation_rad, i), OfPose(plane_rad, i));
    if constexpr (I == 0 && J == 0) {
      of_pose[i] = four_.At(place);
    } else {
      of_pose[i] = four_.Partial<I, J>(place);
    }
  }
  auto& [a, b, c, d] = of_pose;
  Four::Transpose(a[0], b[0], c[0], d[0]);
  Four::Transpose(a[1], b[1], c[1], d[1]);
  return {{FourPairs(a[0], b[0]), FourPairs(c[0], d[0]), FourPairs(a[1], b[1])}, c[1]};
}

// ---- Beyond the table.

// Beyond the first or last plane e, with x = psi - e, L = kPlaneFading_rad and w the angular
// velocity by psi at the edge:
//   g = sign(x) L (1 - exp(-|x|/L))
//   q = Ry(k sin(theta) (x - g)) exp(w g) q(theta, e)              k = 0 below the first plane
//   tau = tau(theta, e) + dtau/dpsi g + sin(min(theta, 90)) (x - g)

// The part that does not depend on elevation: g and x - g.
template <typename T>
struct SmoothRhythm::Beyond {
  bool is_above;
  T g;
  T rest;
};

template <typename T>
GIRDLE_INLINE SmoothRhythm::Beyond<T> SmoothRhythm::BeyondAt(const T& plane_rad) const noexcept {
  using smooth_rhythm_detail::kPlaneFading_rad;
  const bool is_above = ValueOf(plane_rad) > edges_.last_plane_rad;
  const double sign = is_above ? 1 : -1;
  const T x = plane_rad - T(is_above ? edges_.last_plane_rad : edges_.first_plane_rad);
  const T g = (sign * kPlaneFading_rad) * (T(1.0) - Decay(T((sign / kPlaneFading_rad) * x)));
  return {is_above, g, x - g};
}

template <typename T, typename E>
SmoothRhythm::Edge<T> SmoothRhythm::EdgeAt(const E& elevation_rad, bool is_above) const noexcept {
  const double plane_rad = is_above ? edges_.last_plane_rad : edges_.first_plane_rad;
  const Surfaces<T> surfaces = SurfacesAt<T, 0, 0>(elevation_rad, plane_rad);
  const Surfaces<T> by_plane = SurfacesAt<T, 0, 1>(elevation_rad, plane_rad);
  const auto girdle = TurningExp(surfaces.u, by_plane.u, mean_.q_TC_CS);
  return {girdle.q, girdle.w, surfaces.turn_rad, by_plane.turn_rad};
}

template <typename S, typename T>
GIRDLE_INLINE GirdleOf<S> SmoothRhythm::Across(const Edge<S>& edge, const Beyond<T>& beyond,
                                               const ElevationSine<S>& elevation) const noexcept {
  const VectorOf<PairOf<S>> v{edge.w[0] * Both(beyond.g), edge.w[1] * Both(beyond.g),
                              edge.w[2] * Both(beyond.g)};
  const QuaternionOf<PairOf<S>> faded = ExpOf(v) * edge.q;
  const S turn =
      edge.turn_rad + edge.turn_by_plane * beyond.g + elevation.sine_to_level * beyond.rest;
  if (!beyond.is_above) {
    return {faded, turn};
  }
  const Pair per_rad{smooth_rhythm_detail::kAcross[0], smooth_rhythm_detail::kAcross[1]};
  return {AboutYOf(PairOf<S>(Both(elevation.sine * beyond.rest) * per_rad)) * faded, turn};
}

// Above the table, with x = theta - theta_1, half = (180 - theta_1) / 2, w the mean rate below the
// highest row, w_e the angular velocity by theta at that row and V = log(Q_180 q_1^-1):
//   x <= half:  v = w x + [x < half / 2] (w_e - w) x (1 - x / (half / 2))^2
//   x > half:   s = (x - half) / half,
//               v = half w (1 - 3 s^2 + 2 s^3) + V (3 s^2 - 2 s^3) + half w (s - 2 s^2 + s^3)
//   q = exp(v) q_1;  tau = tau_1 + [x < half / 2] dtau/dtheta x (1 - x / (half / 2))^2
template <typename T>
GirdleOf<T> SmoothRhythm::AboveTable(const T& elevation_rad, const T& plane_rad) const noexcept {
  using namespace smooth_rhythm_detail;  // NOLINT(google-build-using-namespace): its functions
  using P = PairOf<T>;
  const double half_rad = (kPi - edges_.highest_rad) / 2;
  const T x = elevation_rad - T(edges_.highest_rad);
  const bool is_near = ValueOf(x) < half_rad / 2;
  const Row<T> top = RowAt(plane_rad, top_, is_near);
  const VectorOf<P> rate = Scaled(P(1 / span_rad_), LogOf(top.q * Inverse(top.inner_q)));
  if (ValueOf(x) > half_rad) {
    const VectorOf<P> whole = LogOf(Constant<T>(upright_) * Inverse(top.q));
    const T s = (1 / half_rad) * (x - T(half_rad));
    const VectorOf<P> v = Scaled(Both(T(half_rad * (T(1.0) - Step(s) + Start(s)))), rate) +
                          Scaled(Both(Step(s)), whole);
    return {ExpOf(v) * top.q, top.turn_rad};
  }
  VectorOf<P> v = Scaled(Both(x), rate);
  T turn = top.turn_rad;
  if (is_near) {
    const T left = T(1.0) - (2 / half_rad) * x;
    const T fading = x * left * left;
    v = v + Scaled(Both(fading), top.w - rate);
    turn = turn + fading * top.turn_by_elevation;
  }
  return {ExpOf(v) * top.q, turn};
}

// Below the table, with s = 1 - theta / theta_0, w the angular velocity by theta at theta_0 and
// V = log(Q_hanging q_0^-1):
//   q = exp(V (3 s^2 - 2 s^3) - theta_0 w (s - 2 s^2 + s^3)) q_0, and tau by the same polynomials
template <typename T>
GirdleOf<T> SmoothRhythm::BelowTable(const T& elevation_rad, const T& plane_rad) const noexcept {
  using namespace smooth_rhythm_detail;  // NOLINT(google-build-using-namespace): its functions
  using P = PairOf<T>;
  const Row<T> bottom = RowAt(plane_rad, bottom_, true);
  const T s = T(1.0) - (1 / edges_.lowest_rad) * elevation_rad;
  const T step = Step(s);
  const T start = edges_.lowest_rad * Start(s);
  const VectorOf<P> whole = LogOf(Constant<T>(hanging_) * Inverse(bottom.q));
  const VectorOf<P> v = Scaled(Both(step), whole) - Scaled(Both(start), bottom.w);
  return {ExpOf(v) * bottom.q, bottom.turn_rad + step * (T(hanging_turn_rad_) - bottom.turn_rad) -
                                   start * bottom.turn_by_elevation};
}

// The last or first row of the table and the inner row that gives the mean rate, at any plane.
// Beyond the table's planes only its corners count, and they are precomputed.
template <typename T>
SmoothRhythm::Row<T> SmoothRhythm::RowAt(const T& plane_rad, const EndRow& end,
                                         bool with_slopes) const noexcept {
  using namespace smooth_rhythm_detail;  // NOLINT(google-build-using-namespace): its functions
  using P = PairOf<T>;
  if constexpr (std::is_same_v<T, Jet<double, 1>>) {
    // A row does not depend on elevation, so one derivative is enough.
    const Dual<double> psi{plane_rad.part[kValue], plane_rad.part[kByPlane]};
    return AsJets(RowAt(psi, end, with_slopes));
  }
  Row<T> row;
  const double psi = ValueOf(plane_rad);
  if (psi >= edges_.first_plane_rad && psi <= edges_.last_plane_rad) {
    const Surfaces<T> surfaces = SurfacesAt<T, 0, 0>(end.elevation_rad, plane_rad);
    row.turn_rad = surfaces.turn_rad;
    if (with_slopes) {
      const Surfaces<T> slopes = SurfacesAt<T, 1, 0>(end.elevation_rad, plane_rad);
      const auto girdle = TurningExp(surfaces.u, slopes.u, mean_.q_TC_CS);
      row.q = girdle.q;
      row.w = girdle.w;
      row.turn_by_elevation = slopes.turn_rad;
    } else {
      row.q = FromMeanBy<P>(surfaces.u, mean_.q_TC_CS);
    }
    if (end.inner_elevation_rad) {
      row.inner_q =
          FromMeanBy<P>(SurfacesAt<T, 0, 0>(*end.inner_elevation_rad, plane_rad).u, mean_.q_TC_CS);
    }
    return row;
  }
  const Beyond<T> beyond = BeyondAt(plane_rad);
  const Corner& corner = beyond.is_above ? end.last_plane : end.first_plane;
  const auto edge_of = [](const Edge<Dual<double>>& edge) -> Edge<T> {
    return {Constant<T>(ValueOf(edge.q)),
            {P(edge.w[0].value), P(edge.w[1].value), P(edge.w[2].value)},
            T(edge.turn_rad.value),
            T(edge.turn_by_plane.value)};
  };
  const ElevationSine<Dual<double>>& sine = end.sine;
  if (with_slopes) {
    using D = Dual<T>;
    const auto dual = [](const Dual<double>& x) { return D(T(x.value), T(x.slope)); };
    const auto duals = [](const Dual<Pair>& x) { return Dual<P>(P(x.value), P(x.slope)); };
    const Edge<Dual<double>>& edge = corner.edge;
    const Edge<D> constant{Constant<T>(edge.q),
                           {duals(edge.w[0]), duals(edge.w[1]), duals(edge.w[2])},
                           dual(edge.turn_rad),
                           dual(edge.turn_by_plane)};
    const GirdleOf<D> girdle =
        Across(constant, beyond, ElevationSine<D>{dual(sine.sine), dual(sine.sine_to_level)});
    row.q = ValueOf(girdle.q_TC_CS);
    row.w = ParentVelocity(girdle.q_TC_CS);
    row.turn_rad = girdle.turn_rad.value;
    row.turn_by_elevation = girdle.turn_rad.slope;
  } else {
    const GirdleOf<T> girdle =
        Across(edge_of(corner.edge), beyond,
               ElevationSine<T>{T(sine.sine.value), T(sine.sine_to_level.value)});
    row.q = girdle.q_TC_CS;
    row.turn_rad = girdle.turn_rad;
  }
  if (end.inner_elevation_rad) {
    row.inner_q = Across(edge_of(corner.inner_edge), beyond,
                         ElevationSine<T>{T(end.inner_sine.sine), T(end.inner_sine.sine_to_level)})
                      .q_TC_CS;
  }
  return row;
}

inline SmoothRhythm::Row<Jet<double, 1>> SmoothRhythm::AsJets(
    const Row<Dual<double>>& row) noexcept {
  const auto jet = []<typename L>(const Dual<L>& x) {
    Jet<L, 1> by_plane(x.value);
    by_plane.part[kByPlane] = x.slope;
    return by_plane;
  };
  return {{jet(row.q.w), jet(row.q.x), jet(row.q.y), jet(row.q.z)},
          {jet(row.w[0]), jet(row.w[1]), jet(row.w[2])},
          jet(row.turn_rad),
          jet(row.turn_by_elevation),
          {jet(row.inner_q.w), jet(row.inner_q.x), jet(row.inner_q.y), jet(row.inner_q.z)}};
}

template <typename T>
SmoothRhythm::ElevationSine<T> SmoothRhythm::SineOf(const T& elevation_rad) noexcept {
  const T sine = SineAndCosineOf(elevation_rad).sine;
  return {sine, ValueOf(elevation_rad) > kPi / 2 ? T(1.0) : sine};
}

template <typename T>
GirdleOf<T> SmoothRhythm::BeyondTable(const T& elevation_rad, const T& plane_rad) const noexcept {
  const double theta = ValueOf(elevation_rad);
  if (theta > edges_.highest_rad) {
    return AboveTable(elevation_rad, plane_rad);
  }
  if (theta < edges_.lowest_rad) {
    return BelowTable(elevation_rad, plane_rad);
  }
  const Beyond<T> beyond = BeyondAt(plane_rad);
  return Across(EdgeAt<T>(elevation_rad, beyond.is_above), beyond, SineOf(elevation_rad));
}

template <typename T>
GirdleOf<T> SmoothRhythm::Girdle(double elevation_rad, double plane_rad) const noexcept {
  using namespace smooth_rhythm_detail;  // NOLINT(google-build-using-namespace): its functions
  if (elevation_rad >= edges_.lowest_rad && elevation_rad <= edges_.highest_rad &&
      plane_rad >= edges_.first_plane_rad && plane_rad <= edges_.last_plane_rad) [[likely]] {
    const SurfaceGrid::Place place = grid_.PlaceOf(elevation_rad, plane_rad);
    return {FromMeanBy<PairOf<T>>(AtPoint<T>(girdle_, place), mean_.q_TC_CS),
            AtPoint<T>(turn_, place)[0]};
  }
  const auto [theta, psi] = VariablesAt<T>(elevation_rad, plane_rad);
  return BeyondTable(theta, psi);
}

template <typename T>
JointsOf<T> SmoothRhythm::Joints(double elevation_rad, double plane_rad) const noexcept {
  using namespace smooth_rhythm_detail;  // NOLINT(google-build-using-namespace): its functions
  const SurfaceGrid::Place place = grid_.PlaceOf(elevation_rad, plane_rad);
  const auto gh = AtPoint<T>(glenohumeral_, place);
  const VectorOf<T> u_SH{Element(gh[0], 0), Element(gh[0], 1), Element(gh[1], 0)};
  return {FromMeanBy<PairOf<T>>(AtPoint<T>(girdle_, place), mean_.q_TC_CS),
          ExpOf(u_SH) * mean_.q_SH};
}

inline GirdleOf<Four> SmoothRhythm::GirdlesInTable(const Four& elevations_rad,
                                                   const Four& planes_rad) const noexcept {
  const Surfaces<Four> surfaces = SurfacesOfFour<0, 0>(elevations_rad, planes_rad);
  return {ExpOf(surfaces.u) * mean_fours_, surfaces.turn_rad};
}

inline GirdleOf<Four> SmoothRhythm::GirdlesBeyondTable(const Four& elevations_rad,
                                                       const Four& planes_rad) const noexcept {
  return BeyondTable(elevations_rad, planes_rad);
}

inline QuaternionOf<Four> SmoothRhythm::HumeriInScapulae(const Four& elevations_rad,
                                                         const Four& planes_rad) const noexcept {
  std::array<Four, Four::kSize> u;
  for (std::size_t i = 0; i < Four::kSize; ++i) {
    u[i] = glenohumeral_four_.At(grid_.PlaceOf(elevations_rad[i], planes_rad[i]))[0];
  }
  Four::Transpose(u[0], u[1], u[2], u[3]);
  return ExpOf(VectorOf<Four>{u[0], u[1], u[2]}) * mean_.q_SH;
}

}  // namespace girdle
