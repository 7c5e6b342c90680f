// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Motions of the arm: commands over time.
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

/// An hour [s], the longest motion unless a longer one is allowed. A file with time stamps in
/// milliseconds seems a thousand times as long as it is, and a trace grows by some three gigabytes
/// an hour.
inline constexpr double kLongestMotion_s = 3600;

/// A year [s], the longest motion that can be allowed. The number of steps then stays countable.
inline constexpr double kLongestMotionAskedFor_s = 365 * 86400.0;

/// A motion: commands from time 0 to `duration_s`.
struct Motion {
  std::string name;
  double duration_s = 0;
  /// Returns the command at a time from the start [s]. The first command holds before 0, the last
  /// one after the end.
  std::function<ArmCommand(double time_s)> command;
  /// The zero of the axial turns in the motion's file; nothing if it has none.
  std::optional<AxialFrom> axial_from = std::nullopt;
  /// A possible mistake in the motion's file, one line without its line break; empty if there is
  /// none.
  std::string hint = {};
};

/// Rates of elevation, plane and axial [rad/s].
using CommandRate = std::array<double, kRateCount>;

/// Returns the mean rates of a motion's command over the step of `step_s` that begins at `time_s`.
/// Plane and axial take the short way round.
[[nodiscard]] CommandRate RateOf(const Motion& motion, double time_s, double step_s);

/// Returns a motion from one command to another on a straight line in (elevation, plane, axial). It
/// has the speed profile of a reaching arm (least jerk: Flash and Hogan, J Neurosci 1985;5:1688)
/// and is at rest at both ends. Precondition: both commands count axial turns from one zero, and
/// duration_s > 0.
[[nodiscard]] Motion ReachingMotion(std::string name, const ArmCommand& from, const ArmCommand& to,
                                    double duration_s);

/// How the file of a motion is read.
struct MotionReading {
  AngleReading angles;
  double longest_s = kLongestMotion_s;
};

/// Reads `time_s` and the columns of CommandColumns. Times must increase. The motion goes from row
/// to row by ArmPath. It starts at the first time, which may be any number. Throws InputError with
/// file and line, also for a motion longer than `longest_s`. If there are more than ten rows and
/// their median interval is a second or more, the motion's hint reports it: time stamps in
/// milliseconds look like that.
[[nodiscard]] Motion ReadMotion(std::istream& in, const std::string& name,
                                const MotionReading& reading = {});

}  // namespace girdle
