// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Named postures of the girdle that are not positions of a rhythm's table.
#pragma once

#include <istream>
#include <string>

#include "kinematics/shoulder_rhythm.h"

namespace girdle {

/// Clavicle in thorax and scapula in clavicle while the arm hangs.
struct Posture {
  Quaternion q_TC;
  Quaternion q_CS;
};

/// Reads the row `posture` of a file like data/postures.csv. Throws InputError with file and line
/// if a value is invalid, if the row is missing or if it is repeated.
[[nodiscard]] Posture ReadPosture(std::istream& in, const std::string& name,
                                  const std::string& posture);

/// Returns the pose of a posture with the arm straight down. The humerus has the turn about its
/// long axis that the rhythm's lowest arm has, tau: q_SH = (q_TC q_CS)^-1 Ry(tau).
[[nodiscard]] ShoulderPose HangingIn(const Posture& posture, const ShoulderRhythm& rhythm) noexcept;

}  // namespace girdle
