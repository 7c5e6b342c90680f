// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/rotation_spline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace girdle {
namespace {

SpherePoint TrigonometricSlerp(const SpherePoint& a, const SpherePoint& b, double t) noexcept {
  const double W = std::acos(std::clamp(Dot(a, b), -1.0, 1.0));
  const double sine = std::sin(W);
  // Opposite quaternions, within the accuracy of an arc cosine: the result is the nearer of the
  // two.
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
    const auto near = [&](auto series) noexcept {
      SlerpBySeries(arcs.Part(k, 1), SlerpCoefficients<series.kTerms>(t), points.subspan(k, 1));
    };
    const auto far = [&]() noexcept {
      points[k] = TrigonometricSlerp(arcs.from[k], arcs.to[k], t);
    };
    WithSeries(arcs.cosine_less_one[k], near, far);
  }
}

double TrigonometricArcOverSine(double cosine) noexcept {
  // Below this squared sine W / sin(W) is 1 to the last bit, and 0/0 must be avoided.
  constexpr double kTinySineSquared = 1e-16;
  const double sine_squared = (1 - cosine) * (1 + cosine);
  const double size =
      sine_squared < kTinySineSquared ? 1 : std::acos(std::abs(cosine)) / std::sqrt(sine_squared);
  return std::copysign(size, cosine);
}

}  // namespace rotation_spline_detail

Quaternion Slerp(const Quaternion& a, const Quaternion& b, double t) noexcept {
  const std::array from{SpherePoint(a)};
  const std::array to{SpherePoint(b)};
  std::array<double, 1> length{};
  std::array<SpherePoint, 1> point;
  MeasuredArcs(from, to, length).At(t, point);
  return point[0].quaternion();
}

Quaternion SquadControl(const Quaternion& q_previous, const Quaternion& q_i,
                        const Quaternion& q_next) noexcept {
  const std::array previous{SpherePoint(q_previous)};
  const std::array knot{SpherePoint(q_i)};
  const std::array next{SpherePoint(q_next)};
  std::array<double, 1> length_before{};
  std::array<double, 1> length_after{};
  std::array<SpherePoint, 1> control;
  SquadControl(MeasuredArcs(previous, knot, length_before), MeasuredArcs(knot, next, length_after),
               control);
  return control[0].quaternion();
}

Quaternion Squad(const Quaternion& q_i, const Quaternion& q_next, const Quaternion& s_i,
                 const Quaternion& s_next, double t) noexcept {
  const std::array knot{SpherePoint(q_i)};
  const std::array next_knot{SpherePoint(q_next)};
  const std::array control{SpherePoint(s_i)};
  const std::array next_control{SpherePoint(s_next)};
  std::array<double, 1> knot_length{};
  std::array<double, 1> control_length{};
  std::array<SpherePoint, 1> point;
  Squad<1>(MeasuredArcs(knot, next_knot, knot_length),
           MeasuredArcs(control, next_control, control_length), t, point);
  return point[0].quaternion();
}

}  // namespace girdle
