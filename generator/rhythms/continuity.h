// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Measures how smooth rhythms are, from their poses alone: one-sided differences on both sides of
/// every line where an interpolant or a rule changes its formula. The derivatives that a rhythm
/// computes itself are not used.
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "kinematics/knot_crossings.h"
#include "kinematics/pose_function.h"
#include "kinematics/shoulder_rhythm.h"

namespace girdle {

/// Largest jumps of a joint's angular velocity, and of its derivative, over some lines.
struct JumpSummary {
  double first = 0;   ///< [deg/deg]
  double second = 0;  ///< [deg/deg^2]
};

/// Jumps over the table's inner knot lines, for SC, AC and GH.
struct InterpolationJumps {
  Interpolation interpolation;
  Direction direction;
  std::array<JumpSummary, kJointCount> joints;
};

/// A property that a rhythm must have, or a number that is only reported.
struct RhythmCheck {
  std::string name;
  double value = 0;
  double limit = 0;  ///< infinite for a number that is only reported
  std::string unit;
  std::string where;  ///< place of the worst case

  /// A value that is NaN does not pass.
  [[nodiscard]] bool passed() const noexcept { return value < limit; }
  [[nodiscard]] bool is_stated() const noexcept { return std::isinf(limit); }
};

/// Returns the jumps of slerp, squad and smooth in both directions, with closure table, on the same
/// table. Throws std::invalid_argument if the table is too small for one of them.
[[nodiscard]] std::vector<InterpolationJumps> MeasureJumps(const RhythmTable& table);

/// Returns the checks of a rhythm over everything that it answers, on a grid of 1 deg.
///
/// - Smooth: jumps inside the table.
/// - Range whole: jumps at the table's borders and where the rule changes its form; one value at
///   elevations 0 and 180; the spin of the humerus at 180, which is zero for axial turns from the
///   swing's zero; how fast bones turn.
/// - Closure exact: commanded minus reached.
/// - Always: how far joints are out of `ranges`.
[[nodiscard]] std::vector<RhythmCheck> MeasureChecks(const ShoulderRhythm& rhythm,
                                                     const JointRanges& ranges);
/// Returns the checks of poses that come from elsewhere: the properties that a rhythm like `rhythm`
/// must have.
[[nodiscard]] std::vector<RhythmCheck> MeasureChecks(const ShoulderRhythm& rhythm,
                                                     const JointRanges& ranges,
                                                     const PoseFunction& pose);

}  // namespace girdle
