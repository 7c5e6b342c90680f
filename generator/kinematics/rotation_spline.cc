// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/rotation_spline.h"

#include <algorithm>
#include <cmath>

namespace girdle {
namespace {

SpherePoint TrigonometricSlerp(const SpherePoint& a, const SpherePoint& b, double t) noexcept {
  const double W = std::acos(std::clamp(Dot(a, b), -1.0, 1.0));
  const double sine = std::sin(W);
  // Opposite quaternions, as far as an arc cosine can tell: stay on the nearer of the two.
  constexpr double kTinySine = 1e-7;
  if (sine < kTinySine) {
    return t < 0.5 ? a : b;
  }
  return (std::sin((1 - t) * W) / sine) * a + (std::sin(t * W) / sine) * b;
}

}  // namespace

namespace rotation_spline_detail {

void SlerpOneByOne(const Arcs& arcs, double t, std::span<SpherePoint> points) noexcept {
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double cosine_less_one = arcs.cosine_less_one[k];
    const auto near = [&](auto series) noexcept {
      SlerpBySeries(arcs.Part(k, 1), SlerpCoefficients<series.kTerms>(t), points.subspan(k, 1));
    };
    const auto far = [&]() noexcept {
      points[k] = TrigonometricSlerp(arcs.from[k], arcs.to[k], t);
    };
    WithSeries(cosine_less_one, near, far);
  }
}

double TrigonometricArcOverSine(double cosine) noexcept {
  // Below this sine squared W / sin(W) is 1 to the last bit, and 0/0 has to be avoided.
  constexpr double kTinySineSquared = 1e-16;
  const double sine_squared = (1 - cosine) * (1 + cosine);
  const double size =
      sine_squared < kTinySineSquared ? 1 : std::acos(std::abs(cosine)) / std::sqrt(sine_squared);
  return std::copysign(size, cosine);
}

}  // namespace rotation_spline_detail

Quaternion Slerp(const Quaternion& a, const Quaternion& b, double t) noexcept {
  const std::array ends{SpherePoint(a), SpherePoint(b)};
  const std::span<const SpherePoint> points(ends);
  double length;  // NOLINT(*-init-variables): the next line's result
  SpherePoint point;
  MeasuredArcs(points.first(1), points.last(1), {&length, 1}).At(t, {&point, 1});
  return point.quaternion();
}

Quaternion SquadControl(const Quaternion& q_previous, const Quaternion& q_i,
                        const Quaternion& q_next) noexcept {
  const std::array knots{SpherePoint(q_previous), SpherePoint(q_i), SpherePoint(q_next)};
  const std::span<const SpherePoint> points(knots);
  std::array<double, 2> lengths{};
  const Arcs arcs = MeasuredArcs(points.first(2), points.last(2), lengths);
  SpherePoint control;
  SquadControl(arcs.Part(0, 1), arcs.Part(1, 1), {&control, 1});
  return control.quaternion();
}

Quaternion Squad(const Quaternion& q_i, const Quaternion& q_next, const Quaternion& s_i,
                 const Quaternion& s_next, double t) noexcept {
  return Slerp(Slerp(q_i, q_next, t), Slerp(s_i, s_next, t), 2 * t * (1 - t));
}

}  // namespace girdle
