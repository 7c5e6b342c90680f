// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Any way from a command to a pose, for what is measured on poses alone.
#pragma once

#include <functional>

#include "kinematics/shoulder_pose.h"
#include "kinematics/shoulder_rhythm.h"

namespace girdle {

/// The pose for a command.
using PoseFunction = std::function<ShoulderPose(const ArmCommand& command)>;

}  // namespace girdle
