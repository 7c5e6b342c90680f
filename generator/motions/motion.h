// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Motions of the arm: commands over time.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/shoulder_rhythm.h"
#include "motions/arm_angles.h"
#include "motions/column_names.h"
#include "motions/gap_reading.h"
#include "names/model_names.h"

namespace girdle {

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
  /// Lines about the motion's file, without line breaks: names that were read as known columns, and
  /// possible mistakes.
  std::vector<std::string> notes = {};
  std::size_t gaps = 0;     ///< rows of the file with gaps that the motion passes over
  std::size_t bridged = 0;  ///< rows of the file with gaps that are bridged
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
  std::vector<NamedColumn> columns = {};  ///< names of `--columns`
  GapReading gaps = {GapRule::kRefuse};
};

/// Reads `time_s` and the columns of CommandColumns. Times must increase. The motion goes from row
/// to row by ArmPath. It starts at the first time, which may be any number. Throws InputError with
/// file and line, also for a motion longer than `longest_s`. If there are more than ten rows and
/// their median interval is a second or more, a note reports it: time stamps in milliseconds look
/// like that.
///
/// The path leaves out rows with gaps that are bridged or kept, and goes from the row before them
/// to the row after them. At an end of the file the nearest row holds.
[[nodiscard]] Motion ReadMotion(std::istream& in, const std::string& name,
                                const MotionReading& reading = {});

}  // namespace girdle
