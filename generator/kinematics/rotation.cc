// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/rotation.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace girdle {
namespace {

Quaternion AboutX(double angle_rad) noexcept {
  return {std::cos(angle_rad / 2), std::sin(angle_rad / 2), 0, 0};
}
Quaternion AboutY(double angle_rad) noexcept {
  return {std::cos(angle_rad / 2), 0, std::sin(angle_rad / 2), 0};
}
Quaternion AboutZ(double angle_rad) noexcept {
  return {std::cos(angle_rad / 2), 0, 0, std::sin(angle_rad / 2)};
}

double ArcSine(double value) noexcept { return std::asin(std::clamp(value, -1.0, 1.0)); }

}  // namespace

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

// With R(row, column) the matrix of the rotation and (a, b, c) the angles in turning order:
//   Ry(a) Rx(b) Rz(c):  R(1,2) = -sin b   R(0,2), R(2,2) = cos b (sin a, cos a)
//                                         R(1,0), R(1,1) = cos b (sin c, cos c)
//   Rx(a) Rz(b) Ry(c):  R(0,1) = -sin b   R(2,1), R(1,1) = cos b (sin a, cos a)
//                                         R(0,2), R(0,0) = cos b (sin c, cos c)
//   Ry(a) Rx(b) Ry(c):  R(1,1) =  cos b   R(0,1), R(2,1) = sin b (sin a, cos a)
//                                         R(1,0), R(1,2) = sin b (sin c, -cos c)
Vector3 EulerFromQuaternion(EulerSequence sequence, const Quaternion& q_AB) noexcept {
  const Matrix3 columns = glm::mat3_cast(q_AB);
  const auto R = [&columns](int row, int column) { return columns[column][row]; };
  switch (sequence) {
    case EulerSequence::kYXZ:
      return {std::atan2(R(0, 2), R(2, 2)), ArcSine(-R(1, 2)), std::atan2(R(1, 0), R(1, 1))};
    case EulerSequence::kXZY:
      return {std::atan2(R(2, 1), R(1, 1)), ArcSine(-R(0, 1)), std::atan2(R(0, 2), R(0, 0))};
    case EulerSequence::kYXY:
      break;
  }
  return {std::atan2(-R(0, 1), -R(2, 1)), -std::atan2(std::hypot(R(0, 1), R(2, 1)), R(1, 1)),
          std::atan2(-R(1, 0), R(1, 2))};
}

// log(cos(W/2), sin(W/2) n) = W n, with the sign of q chosen so that W <= pi.
Vector3 Log(const Quaternion& q_AB) noexcept {
  const Vector3 sine_axis =
      q_AB.w < 0 ? Vector3(-q_AB.x, -q_AB.y, -q_AB.z) : Vector3(q_AB.x, q_AB.y, q_AB.z);
  const double sine = glm::length(sine_axis);
  // Below this W/sin(W/2) is 2 to the last bit, and 0/0 has to be avoided.
  constexpr double kTinySine = 1e-12;
  if (sine < kTinySine) {
    return 2.0 * sine_axis;
  }
  return (2.0 * std::atan2(sine, std::abs(q_AB.w)) / sine) * sine_axis;
}

Quaternion Exp(const Vector3& rotation_vector_rad) noexcept {
  const double half_angle = glm::length(rotation_vector_rad) / 2;
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
