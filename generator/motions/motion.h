// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Motions of the arm: what is commanded when.
#pragma once

#include <array>
#include <functional>
#include <istream>
#include <optional>
#include <string>

#include "kinematics/shoulder_rhythm.h"
#include "motions/arm_angles.h"
#include "names/model_names.h"

namespace girdle {

inline constexpr const char* kTimeColumn = "time_s";

/// An hour [s], unless more is asked for: a file of stamps in milliseconds says a thousand times as
/// much as it means, and a trace grows by some three gigabytes an hour.
inline constexpr double kLongestMotion_s = 3600;

/// No motion is longer [s], whatever is asked for: a year, so that the number of steps stays
/// countable.
inline constexpr double kLongestMotionAskedFor_s = 365 * 86400.0;

struct Motion {
  std::string name;
  double duration_s = 0;
  /// Command at a time from the start [s]; held before 0 and after the end.
  std::function<ArmCommand(double time_s)> command;
  /// What axial turns of its file count from; nothing if it has none.
  std::optional<AxialFrom> axial_from = std::nullopt;
  /// What whoever wrote the file may not have meant, a line without its end; empty if nothing is
  /// odd.
  std::string hint = {};
};

/// How fast elevation, plane and axial change [rad/s].
using CommandRate = std::array<double, kRateCount>;

/// Returns how fast a motion's command changes over the step that begins at a time; of plane and
/// axial the short way round.
[[nodiscard]] CommandRate RateOf(const Motion& motion, double time_s, double step_s);

/// Returns a motion from one command to another, which count axial turns from one zero, on a
/// straight line in (elevation, plane, axial), with the speed profile of a reaching arm (least
/// jerk: Flash and Hogan, J Neurosci 1985;5:1688), at rest at both ends. Precondition: duration_s >
/// 0.
[[nodiscard]] Motion ReachingMotion(std::string name, const ArmCommand& from, const ArmCommand& to,
                                    double duration_s);

/// How the file of a motion is to be read.
struct MotionReading {
  AngleReading angles;
  double longest_s = kLongestMotion_s;
};

/// Reads `time_s` and the columns of CommandColumns, times increasing, and goes from row to row as
/// ArmPath does. The motion starts at the first time, whatever that is. Throws InputError with file
/// and line, also for a motion longer than `longest_s`. If more than ten rows are a second or more
/// apart in the median, the motion's hint says so: stamps of a recording in milliseconds are.
[[nodiscard]] Motion ReadMotion(std::istream& in, const std::string& name,
                                const MotionReading& reading = {});

}  // namespace girdle
