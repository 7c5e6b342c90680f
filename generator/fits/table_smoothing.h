// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// A measured table without the steps that people make who leave the measurement on the way.
///
/// A row of the table is a mean over those who reached its elevation. Where one of them drops out
/// the mean jumps, and an interpolant through the rows jumps with it. For each joint and each plane
/// the rows q_i are replaced by the rotations r_i that make
///
///     sum_i |e_i|^2 + lambda sum_i p_i |t_i|^2,    e_i = log(q_i^-1 r_i),                     (1)
///     t_i = third difference of r_i .. r_i+3,      w_i = log(r_i^-1 r_i+1)                    (2)
///
/// least: a Whittaker-Henderson smoother on the rotation group. p_i is 1 but for the lowest rows of
/// GH (SmoothingOptions). On even elevations t_i = w_i+2 - 2 w_i+1 + w_i. On any others, with h_i
/// the steps of elevation and s_i = (h_i + h_i+1 + h_i+2) / 3,
///
///     t_i = s_i^2 (a_i+1 - a_i),    a_i = (w_i+1 / h_i+1 - w_i / h_i) / ((h_i + h_i+1) / 2),  (3)
///
/// the third divided difference in steps of its own rows, which is the former for equal h. So
/// lambda has no unit and means the same whether rows lie 5 or 10 degrees apart.
///
/// (1) is solved by Gauss-Newton steps r_i <- r_i exp(d_i), without a chart. With K(v) the inverse
/// of the right Jacobian of SO(3) (Sola, Deray, Atchuthan, A micro Lie theory for state estimation
/// in robotics, arXiv:1812.01537; the left one's inverse is its transpose),
///
///     d e_i = K(e_i) d_i,    d w_i = K(w_i) d_i+1 - K(w_i)^T d_i,                             (4)
///     K(v) = 1 + [v]/2 + (1 - |v|/2 cot(|v|/2)) / |v|^2 [v]^2.                                (5)
///
/// Both sums are the same for c r_i g as for r_i: no choice of axes in either bone changes the
/// result. Rows that turn at a constant rate about an axis fixed in the bones stay as they are.
#pragma once

#include <array>
#include <cstddef>

#include "kinematics/rhythm_table.h"
#include "kinematics/worst_case.h"

namespace girdle {

/// Fewest elevations that have a third difference.
inline constexpr std::size_t kFewestSmoothedElevations = 4;

/// Above this penalty rounding would decide the result.
inline constexpr double kLargestPenalty = 1e6;

struct SmoothingOptions {
  /// lambda of equation (1), [0, kLargestPenalty]; 0 leaves the table as it is.
  double penalty = 10;
  /// p_i of the third differences of GH that begin below `gh_low_elevation_rad`, [0, 1].
  ///
  /// Nobody drops out there: near hanging the humerus really turns fast about its own axis, in
  /// table and in source. A full penalty takes up to 1.6 deg of that away and bends the rows above
  /// as well. This share takes out the one thing that cannot be motion, the axial rate of the
  /// frontal plane that falls, rises and falls again, with no row moved by more than the steps
  /// above need (0.7 deg).
  double gh_low_share = 0.005;
  /// Lowest elevation of the bone-pin table [rad]; GH below it comes from another collection.
  double gh_low_elevation_rad = RadiansFromDegrees(30);
};

/// Returns the table of the rotations that make (1) least.
///
/// Planes, elevations, `measured` and the published scapula are those of `table`. Angles are in the
/// ranges of EulerFromQuaternion unless the penalty is 0. Throws std::invalid_argument for fewer
/// than kFewestSmoothedElevations elevations, for options outside their ranges, and for a joint
/// that turns so far from row to row that the steps do not settle, naming it and its plane.
[[nodiscard]] RhythmTable Smoothed(const RhythmTable& table, const SmoothingOptions& options = {});

/// Numbers of a table's position; of a second difference, of the middle one of its three rows.
struct GridPlace {
  std::size_t plane = 0;
  std::size_t elevation = 0;
};
/// The largest of an angle [rad] over a table's positions, and where it is.
using LargestOnGrid = WorstCase<GridPlace>;

/// How far the rows of one joint bend.
struct JointBend {
  /// |w_i+1 - w_i| with w of equation (2), in steps of elevation as in (3).
  LargestOnGrid rotation;
  /// The same of each Euler angle by itself; the largest of the three.
  LargestOnGrid euler;
};

/// What has become of one joint.
struct JointChange {
  LargestOnGrid move;  ///< angle between a row before and after
  JointBend before;
  JointBend after;
};

/// Returns the changes of SC, AC and GH. Throws std::invalid_argument if the tables have different
/// planes or elevations.
[[nodiscard]] std::array<JointChange, kJointCount> ChangesBetween(const RhythmTable& before,
                                                                  const RhythmTable& after);

}  // namespace girdle
