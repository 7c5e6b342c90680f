// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/rotation.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "kinematics/euler_angles.h"

namespace girdle {
namespace {

Quaternion AboutX(double angle_rad) noexcept {
  return {std::cos(angle_rad / 2), std::sin(angle_rad / 2), 0, 0};
}
Quaternion AboutZ(double angle_rad) noexcept {
  return {std::cos(angle_rad / 2), 0, 0, std::sin(angle_rad / 2)};
}

double Length(double x, double y) noexcept { return std::sqrt(x * x + y * y); }

}  // namespace

double TypedDegrees(double angle_rad) noexcept {
  constexpr double kPerDegree = 1e9;
  return std::round(DegreesFromRadians(angle_rad) * kPerDegree) / kPerDegree;
}

Quaternion AboutY(double angle_rad) noexcept {
  return {std::cos(angle_rad / 2), 0, std::sin(angle_rad / 2), 0};
}

Quaternion QuaternionFromEuler(EulerSequence sequence, const Vector3& angles_rad) noexcept {
  switch (sequence) {
    case EulerSequence::kYXZ:
      return AboutY(angles_rad.x) * AboutX(angles_rad.y) * AboutZ(angles_rad.z);
    case EulerSequence::kXZY:
      return AboutX(angles_rad.x) * AboutZ(angles_rad.y) * AboutY(angles_rad.z);
    case EulerSequence::kYXY:
      break;
  }
  return AboutY(angles_rad.x) * AboutX(angles_rad.y) * AboutY(angles_rad.z);
}

// Ry(a) Rx(b) Ry(c) = (cos(b/2) cos((a+c)/2), sin(b/2) cos((a-c)/2), cos(b/2) sin((a+c)/2),
//                      -sin(b/2) sin((a-c)/2)); the other sequences are in euler_angles.h.
Vector3 EulerFromQuaternion(EulerSequence sequence, const Quaternion& q_AB_any_sign) noexcept {
  const Quaternion q_AB = q_AB_any_sign.w < 0 ? -q_AB_any_sign : q_AB_any_sign;
  const auto different_axes = [&q_AB](double q_1, double q_2, double q_3) {
    const VectorOf<double> angles_rad = EulerAngles(q_AB.w, q_1, q_2, q_3);
    return Vector3(angles_rad[0], angles_rad[1], angles_rad[2]);
  };
  switch (sequence) {
    case EulerSequence::kYXZ:
      return different_axes(q_AB.y, q_AB.x, q_AB.z);
    case EulerSequence::kXZY:
      return different_axes(q_AB.x, q_AB.z, q_AB.y);
    case EulerSequence::kYXY:
      break;
  }
  // sin(b/2) is taken as negative, so that the second angle lies in [-pi, 0].
  const double half_sum = std::atan2(q_AB.y, q_AB.w);
  const double half_difference = std::atan2(q_AB.z, -q_AB.x);
  return {WithinHalfTurn(half_sum + half_difference),
          -2 * std::atan2(Length(q_AB.x, q_AB.z), Length(q_AB.w, q_AB.y)),
          WithinHalfTurn(half_sum - half_difference)};
}

// With e_1 the first axis in A, e_2 the second after the first turn, and e_3 the third after two
// turns, w = a' e_1 + b' e_2 + c' e_3. e_2 is perpendicular to the others, whose product is s = e_1
// . e_3.
Vector3 EulerRates(EulerSequence sequence, const Vector3& angles_rad,
                   const Vector3& w_AB) noexcept {
  const bool tilts_last = sequence == EulerSequence::kYXZ;
  const double cosine_a = std::cos(angles_rad.x);
  const double sine_a = std::sin(angles_rad.x);
  const double cosine_b = std::cos(angles_rad.y);
  const double sine_b = std::sin(angles_rad.y);
  const Vector3 e_1 = tilts_last ? Vector3(0, 1, 0) : Vector3(1, 0, 0);
  const Vector3 e_2 = tilts_last ? Vector3(cosine_a, 0, -sine_a) : Vector3(0, -sine_a, cosine_a);
  const Vector3 e_3 = tilts_last ? Vector3(sine_a * cosine_b, -sine_b, cosine_a * cosine_b)
                                 : Vector3(-sine_b, cosine_a * cosine_b, sine_a * cosine_b);
  const double w_1 = glm::dot(w_AB, e_1);
  const double w_3 = glm::dot(w_AB, e_3);
  const double c_rate = (w_3 + sine_b * w_1) / (cosine_b * cosine_b);
  return {w_1 + sine_b * c_rate, glm::dot(w_AB, e_2), c_rate};
}

// log(cos(W/2), sin(W/2) n) = W n, with the sign of q chosen so that W <= pi.
Vector3 Log(const Quaternion& q_AB) noexcept {
  const Vector3 sine_axis =
      q_AB.w < 0 ? Vector3(-q_AB.x, -q_AB.y, -q_AB.z) : Vector3(q_AB.x, q_AB.y, q_AB.z);
  const double sine = glm::length(sine_axis);
  // Below this limit W/sin(W/2) is 2 to the last bit, and 0/0 must be avoided.
  constexpr double kTinySine = 1e-12;
  if (sine < kTinySine) {
    return 2.0 * sine_axis;
  }
  return (2.0 * std::atan2(sine, std::abs(q_AB.w)) / sine) * sine_axis;
}

Quaternion Exp(const Vector3& rotation_vector_rad) noexcept {
  // hypot does not overflow where the sum of squares would, but takes longer.
  const double length = glm::length(rotation_vector_rad);
  const double half_angle =
      (std::isinf(length)
           ? std::hypot(rotation_vector_rad.x, rotation_vector_rad.y, rotation_vector_rad.z)
           : length) /
      2;
  // sin(h)/h is 1 to the last bit below this half angle.
  constexpr double kTinyHalfAngle = 1e-9;
  const double scale = half_angle < kTinyHalfAngle ? 0.5 : std::sin(half_angle) / half_angle / 2;
  const Vector3 sine_axis = scale * rotation_vector_rad;
  return {std::cos(half_angle), sine_axis.x, sine_axis.y, sine_axis.z};
}

double AngleBetween(const Quaternion& a, const Quaternion& b) noexcept {
  return glm::length(Log(glm::conjugate(a) * b));
}

Quaternion AlignedWith(const Quaternion& q_AB, const Quaternion& reference) noexcept {
  return glm::dot(q_AB, reference) < 0 ? -q_AB : q_AB;
}

}  // namespace girdle
