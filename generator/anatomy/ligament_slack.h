// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// From which length on the ligaments of a model pull, and where they tear.
#pragma once

#include <array>
#include <functional>

#include "anatomy/anatomy.h"
#include "kinematics/assembled_rhythm.h"

namespace girdle {

using LigamentLengths = std::array<double, kLigamentCount>;  ///< [m], in the order of LigamentName

/// Called with a pose and the command that it answers.
using AskedPoseVisit = std::function<void(const ArmCommand& used, const ShoulderPose& pose)>;

/// Returns slack [m]: the anatomy's, or the longest length wherever the rhythm goes, rounded up, if
/// that is longer. So nothing that is asked of the joints stretches a ligament.
///
/// The rhythm is looked at a degree apart all over its domain, and with the arm hanging relaxed.
/// `visit` is called at each of its poses; what it throws leaves this function.
[[nodiscard]] LigamentLengths SlackFor_m(
    const Anatomy& anatomy, const AssembledRhythm& rhythm,
    const AskedPoseVisit& visit = [](const ArmCommand&, const ShoulderPose&) {});

/// Returns the length [m] at which a ligament of that slack tears.
[[nodiscard]] double TearingLength_m(const Ligament& ligament, double slack_m) noexcept;

}  // namespace girdle
