// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Motions of the arm: what is commanded when.
#pragma once

#include <array>
#include <functional>
#include <istream>
#include <string>

#include "kinematics/shoulder_rhythm.h"
#include "names/model_names.h"

namespace girdle {

/// A day: nobody raises an arm for longer, and the number of steps stays countable.
inline constexpr double kLongestMotion_s = 86400;

struct Motion {
  std::string name;
  double duration_s = 0;
  /// Command at a time [s]; held before 0 and after the end.
  std::function<ArmCommand(double time_s)> command;
};

/// How fast elevation, plane and axial change [rad/s].
using CommandRate = std::array<double, kRateCount>;

/// Returns how fast a motion's command changes over the step that begins at a time.
[[nodiscard]] CommandRate RateOf(const Motion& motion, double time_s, double step_s);

/// Returns a motion from one command to another, which count axial turns from one zero, on a
/// straight line in (elevation, plane, axial),
/// with the speed profile of a reaching arm (least jerk: Flash and Hogan, J Neurosci 1985;5:1688),
/// at rest at both ends. Precondition: duration_s > 0.
[[nodiscard]] Motion ReachingMotion(std::string name, const ArmCommand& from, const ArmCommand& to,
                                    double duration_s);

/// Reads `time_s,elevation_deg,plane_deg`, optionally `axial_deg`, `shrug_deg` and
/// `protraction_deg`, columns in any order, times not negative and increasing, offsets within
/// kShrugRange and kProtractionRange, and goes in straight lines from row to row. The column
/// axial_deg is counted from `axial_from`; without it the turn is the rhythm's own. Throws
/// InputError with file and line.
[[nodiscard]] Motion ReadMotion(std::istream& in, const std::string& name,
                                AxialFrom axial_from = AxialFrom::kRhythm);

}  // namespace girdle
