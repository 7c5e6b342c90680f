// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/shoulder_pose.h"

namespace girdle {

ShoulderPose PoseFromAngles(const JointAngles& angles_rad) noexcept {
  const auto rotation = [&angles_rad](std::size_t joint) {
    const std::size_t first = 3 * joint;
    return QuaternionFromEuler(kJointSequences[joint],
                               {angles_rad[first], angles_rad[first + 1], angles_rad[first + 2]});
  };
  return {rotation(0), rotation(1), rotation(2)};
}

JointAngles AnglesFromPose(const ShoulderPose& pose) noexcept {
  const Vector3 sc = EulerFromQuaternion(kJointSequences[0], pose.q_TC);
  const Vector3 ac = EulerFromQuaternion(kJointSequences[1], pose.q_CS);
  const Vector3 gh = EulerFromQuaternion(kJointSequences[2], pose.q_SH);
  return {sc.x, sc.y, sc.z, ac.x, ac.y, ac.z, gh.x, gh.y, gh.z};
}

ArmAngles ArmAnglesFromRotation(const Quaternion& q_TH) noexcept {
  const Vector3 angles_rad = EulerFromQuaternion(EulerSequence::kYXY, q_TH);
  return {-angles_rad.y, angles_rad.x, angles_rad.z};
}

}  // namespace girdle
