// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// How smooth rhythms are, measured on their poses alone: one-sided differences left and right of
/// every line where an interpolant or a rule changes its formula. The derivatives that a rhythm
/// computes itself are not asked.
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "kinematics/knot_crossings.h"
#include "kinematics/pose_function.h"
#include "kinematics/shoulder_rhythm.h"

namespace girdle {

/// Largest change of a joint's angular velocity over some lines, and of what that changes by.
struct JumpSummary {
  double first = 0;   ///< [deg/deg]
  double second = 0;  ///< [deg/deg^2]
};

/// Jumps over the table's inner knot lines, SC, AC, GH.
struct InterpolationJumps {
  Interpolation interpolation;
  Direction direction;
  std::array<JumpSummary, kJointCount> joints;
};

/// Something that a rhythm keeps, or a number that is only stated.
struct RhythmCheck {
  std::string name;
  double value = 0;
  double limit = 0;  ///< infinite for what is stated
  std::string unit;
  std::string where;  ///< the worst case

  /// A value that is not a number does not pass.
  [[nodiscard]] bool passed() const noexcept { return value < limit; }
  [[nodiscard]] bool is_stated() const noexcept { return std::isinf(limit); }
};

/// Returns the jumps of slerp, squad and smooth in both directions, each with closure table on the
/// same table. Throws std::invalid_argument if the table is too small for one of them.
[[nodiscard]] std::vector<InterpolationJumps> MeasureJumps(const RhythmTable& table);

/// Returns what a rhythm keeps over all that it answers, looked at on a grid of 1 deg: with smooth,
/// jumps inside the table; with the range whole, jumps at the table's borders and where the rule
/// changes its form, one value at elevations 0 and 180, the humerus's spin at 180 and that it has
/// none with axial turns from the swing's zero, how fast bones turn; with closure exact,
/// commanded minus reached; always, how far joints are out of `ranges`.
[[nodiscard]] std::vector<RhythmCheck> MeasureChecks(const ShoulderRhythm& rhythm,
                                                     const JointRanges& ranges);
/// The same of poses that come from elsewhere: what a rhythm like this one has to keep.
[[nodiscard]] std::vector<RhythmCheck> MeasureChecks(const ShoulderRhythm& rhythm,
                                                     const JointRanges& ranges,
                                                     const PoseFunction& pose);

}  // namespace girdle
