// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/rotation_spline.h"

#include <algorithm>
#include <cmath>

namespace girdle {
namespace rotation_spline_detail {

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

double TrigonometricArcOverSine(double cosine) noexcept {
  // Below this sine squared W / sin(W) is 1 to the last bit, and 0/0 has to be avoided.
  constexpr double kTinySineSquared = 1e-16;
  const double sine_squared = (1 - cosine) * (1 + cosine);
  const double size = sine_squared < kTinySineSquared
                          ? 1
                          : std::acos(std::abs(cosine)) / std::sqrt(sine_squared);
  return std::copysign(size, cosine);
}

}  // namespace rotation_spline_detail

namespace {

SpherePoints<1> Points(const Quaternion& q) noexcept {
  return {SpherePoint(q)};
}

}  // namespace

Quaternion Slerp(const Quaternion& a, const Quaternion& b, double t) noexcept {
  const SpherePoints<1> from = Points(a);
  const SpherePoints<1> to = Points(b);
  return Arcs<1>{from, to, ArcLengths<1>(from, to)}.At(t)[0].quaternion();
}

Quaternion SquadControl(const Quaternion& q_previous, const Quaternion& q_i,
                        const Quaternion& q_next) noexcept {
  const SpherePoints<1> previous = Points(q_previous);
  const SpherePoints<1> knot = Points(q_i);
  const SpherePoints<1> next = Points(q_next);
  return SquadControl(Arcs<1>{previous, knot, ArcLengths<1>(previous, knot)},
                      Arcs<1>{knot, next, ArcLengths<1>(knot, next)})[0]
      .quaternion();
}

Quaternion Squad(const Quaternion& q_i, const Quaternion& q_next, const Quaternion& s_i,
                 const Quaternion& s_next, double t) noexcept {
  return Slerp(Slerp(q_i, q_next, t), Slerp(s_i, s_next, t), 2 * t * (1 - t));
}

}  // namespace girdle
