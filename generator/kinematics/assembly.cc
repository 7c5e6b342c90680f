// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/assembly.h"

namespace girdle {

JointAngles DrivenAngles(Assembly assembly, const ShoulderPose& pose) noexcept {
  return AnglesFromPose(
      assembly == Assembly::kTree ? pose : ShoulderPose{pose.q_TC, pose.q_TS(), pose.q_SH});
}

}  // namespace girdle
