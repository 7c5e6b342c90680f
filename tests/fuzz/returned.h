// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Checks of what a reader returned.
#pragma once

#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "kinematics/shoulder_pose.h"

namespace girdle::fuzz {

/// Returns whether a quaternion is a rotation: finite and of length 1, up to rounding.
[[nodiscard]] inline bool IsRotation(const Quaternion& q) {
  constexpr double kRounding = 1e-9;
  return std::abs(glm::length(q) - 1) < kRounding;
}

/// Returns whether all three joints of a pose are rotations.
[[nodiscard]] inline bool IsPose(const ShoulderPose& pose) {
  return IsRotation(pose.q_TC) && IsRotation(pose.q_CS) && IsRotation(pose.q_SH);
}

}  // namespace girdle::fuzz
