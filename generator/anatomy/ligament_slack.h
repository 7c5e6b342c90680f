// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The lengths from which on the ligaments of a model pull, and at which they tear.
#pragma once

#include <array>
#include <functional>

#include "anatomy/anatomy.h"
#include "kinematics/assembled_rhythm.h"

namespace girdle {

using LigamentLengths = std::array<double, kLigamentCount>;  ///< [m], in the order of LigamentName

/// Function called with a pose and the command that it answers.
using AskedPoseVisit = std::function<void(const ArmCommand& used, const ShoulderPose& pose)>;

/// Returns the slack lengths [m]. Each is the anatomy's, or the longest length of the ligament in
/// any pose of the rhythm, rounded up, if that is longer. So no commanded pose stretches a
/// ligament.
///
/// Poses are computed at every degree of the rhythm's domain and with the arm hanging relaxed.
/// `visit` is called for each pose. An exception of `visit` passes through.
[[nodiscard]] LigamentLengths SlackFor_m(
    const Anatomy& anatomy, const AssembledRhythm& rhythm,
    const AskedPoseVisit& visit = [](const ArmCommand&, const ShoulderPose&) {});

/// Returns the length [m] at which a ligament with that slack length tears.
[[nodiscard]] double TearingLength_m(const Ligament& ligament, double slack_m) noexcept;

}  // namespace girdle
