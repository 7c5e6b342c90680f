// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// How stiffly the nine joint coordinates follow their targets.
#pragma once

#include <array>

#include "kinematics/shoulder_pose.h"

namespace girdle {

/// Servo and passive properties of the three hinges of one joint.
struct JointDynamics {
  double stiffness_N_m_per_rad;  ///< of the servo: torque per radian of tracking error
  double damping_N_m_s_per_rad;  ///< of the hinge, integrated implicitly by MuJoCo
  double armature_kg_m2;         ///< keeps light bones well conditioned
};

/// SC, AC, GH. The damping is near critical for what hangs on the joint (about 0.2, 0.1, 0.06 kg
/// m^2 with the arm raised: c = 2 sqrt(k I)), so that targets are reached without overshoot and the
/// lag is damping / stiffness, 20 ms.
inline constexpr std::array<JointDynamics, kJointCount> kJointDynamics = {{
    {1500, 30, 0.02},
    {1000, 20, 0.02},
    {500, 10, 0.01},
}};

}  // namespace girdle
