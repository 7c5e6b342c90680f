// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// A function from a command to a pose, for measures that need poses only.
#pragma once

#include <functional>

#include "kinematics/shoulder_pose.h"
#include "kinematics/shoulder_rhythm.h"

namespace girdle {

/// Returns the pose for a command.
using PoseFunction = std::function<ShoulderPose(const ArmCommand& command)>;

}  // namespace girdle
