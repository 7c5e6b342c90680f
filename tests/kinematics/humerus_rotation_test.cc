// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/humerus_rotation.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "kinematics/random_rotations.h"
#include "kinematics/rotation.h"

namespace girdle::humerus_rotation_test {
namespace {

// A few dozen roundings of numbers of size one.
constexpr double kRounding = 1e-14;

RC_GTEST_PROP(HumerusRotation, PointsWhereItIsTold, ()) {
  const double theta_rad = *NumberWithin(0, kPi);
  const double psi_rad = *NumberWithin(-kPi, kPi);
  const double tau_rad = *NumberWithin(-kPi, kPi);
  const auto q = HumerusRotation(theta_rad, psi_rad, tau_rad);
  const Quaternion q_TH(q.w, q.x, q.y, q.z);
  const Vector3 elbow{std::sin(theta_rad) * std::sin(psi_rad), -std::cos(theta_rad),
                      std::sin(theta_rad) * std::cos(psi_rad)};
  RC_ASSERT(glm::length(q_TH * Vector3(0, -1, 0) - elbow) < kRounding);
}

// The smallest rotation has its axis across both directions, and a turn by tau about y is first.
RC_GTEST_PROP(HumerusRotation, IsTheSmallestRotationThereAfterTheTurn, ()) {
  const double theta_rad = *NumberWithin(0, kPi);
  const double psi_rad = *NumberWithin(-kPi, kPi);
  const double tau_rad = *NumberWithin(-kPi, kPi);
  const Vector3 axis(-std::cos(psi_rad), 0, std::sin(psi_rad));
  const Quaternion expected = Exp(theta_rad * axis) * Exp(Vector3(0, tau_rad, 0));
  const auto q = HumerusRotation(theta_rad, psi_rad, tau_rad);
  RC_ASSERT(AngleBetween({q.w, q.x, q.y, q.z}, expected) < kRounding);
}

RC_GTEST_PROP(HumerusRotation, HasTheIsbAnglesThatTheHeaderSays, ()) {
  const double theta_rad = *NumberWithin(0, kPi);
  const double psi_rad = *NumberWithin(-kPi, kPi);
  const double tau_rad = *NumberWithin(-kPi, kPi);
  const auto q = HumerusRotation(theta_rad, psi_rad, tau_rad);
  const Quaternion expected =
      QuaternionFromEuler(EulerSequence::kYXY, {psi_rad, -theta_rad, tau_rad - psi_rad});
  RC_ASSERT(AngleBetween({q.w, q.x, q.y, q.z}, expected) < kRounding);
}

}  // namespace
}  // namespace girdle::humerus_rotation_test
