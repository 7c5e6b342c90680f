// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Named postures of the girdle that belong to no position of a rhythm's table.
#pragma once

#include <istream>
#include <string>

#include "kinematics/shoulder_rhythm.h"

namespace girdle {

/// Clavicle in thorax and scapula in clavicle, the arm hanging.
struct Posture {
  Quaternion q_TC;
  Quaternion q_CS;
};

/// Reads the row `posture` of a file like data/postures.csv. Throws InputError with file and line
/// if a value cannot be, or if there is no such row or two.
[[nodiscard]] Posture ReadPosture(std::istream& in, const std::string& name,
                                  const std::string& posture);

/// Returns a posture with the arm hanging straight down, turned about its long axis as the rhythm's
/// lowest arm is: GH = (q_TC q_CS)^-1 Ry(tau).
[[nodiscard]] ShoulderPose HangingIn(const Posture& posture, const ShoulderRhythm& rhythm) noexcept;

}  // namespace girdle
