// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Removes from a measured table the steps that arise when people leave the measurement.
///
/// A row of the table is a mean over those people who reached its elevation. Where one of them
/// drops out, the mean jumps, and an interpolant through the rows jumps too. For each joint and
/// each plane the rows q_i are replaced by the rotations r_i that minimize
///
///     sum_i |e_i|^2 + lambda sum_i p_i |t_i|^2,    e_i = log(q_i^-1 r_i),                     (1)
///     t_i = third difference of r_i .. r_i+3,      w_i = log(r_i^-1 r_i+1)                    (2)
///
/// This is a Whittaker-Henderson smoother on the rotation group. p_i is 1, except for the lowest
/// rows of GH (SmoothingOptions). On even elevations t_i = w_i+2 - 2 w_i+1 + w_i. On uneven ones,
/// with the steps of elevation h_i and s_i = (h_i + h_i+1 + h_i+2) / 3,
///
///     t_i = s_i^2 (a_i+1 - a_i),    a_i = (w_i+1 / h_i+1 - w_i / h_i) / ((h_i + h_i+1) / 2),  (3)
///
/// which is the third divided difference in steps of its own rows. For equal h it is the t_i of
/// even elevations. So lambda has no unit and has the same effect whether rows are 5 or 10 degrees
/// apart.
///
/// (1) is solved by Gauss-Newton steps r_i <- r_i exp(d_i), without coordinates on the group. K(v)
/// is the inverse of the right Jacobian of SO(3) (Sola, Deray, Atchuthan, A micro Lie theory for
/// state estimation in robotics, arXiv:1812.01537); the inverse of the left one is its transpose.
/// Then
///
///     d e_i = K(e_i) d_i,    d w_i = K(w_i) d_i+1 - K(w_i)^T d_i,                             (4)
///     K(v) = 1 + [v]/2 + (1 - |v|/2 cot(|v|/2)) / |v|^2 [v]^2.                                (5)
///
/// Both sums of (1) are equal for c r_i g and for r_i, so the choice of axes in either bone does
/// not change the result. Rows that turn at a constant rate about an axis fixed in the bones do not
/// change.
#pragma once

#include <array>
#include <cstddef>

#include "kinematics/rhythm_table.h"
#include "kinematics/worst_case.h"

namespace girdle {

/// The smallest number of elevations that has a third difference.
inline constexpr std::size_t kFewestSmoothedElevations = 4;

/// The largest penalty. Above it, rounding would determine the result.
inline constexpr double kLargestPenalty = 1e6;

struct SmoothingOptions {
  /// lambda of equation (1), in [0, kLargestPenalty]. 0 leaves the table unchanged.
  double penalty = 10;
  /// p_i of GH's third differences that begin below `gh_low_elevation_rad`, in [0, 1].
  ///
  /// Nobody drops out there. Near hanging the humerus really turns fast about its own axis, in the
  /// table and in its source. A full penalty would remove up to 1.6 deg of this turn and would bend
  /// the higher rows too. This share removes only what cannot be motion: the axial rate of the
  /// frontal plane that falls, rises and falls again. It moves no row by more than the steps at
  /// higher elevations need (0.7 deg).
  double gh_low_share = 0.005;
  /// Lowest elevation of the bone-pin table [rad]. GH below it comes from another data set.
  double gh_low_elevation_rad = RadiansFromDegrees(30);
};

/// Returns the table of the rotations that minimize (1).
///
/// Planes, elevations, `measured` and the published scapula are those of `table`. Angles are in the
/// ranges of EulerFromQuaternion unless the penalty is 0. Throws std::invalid_argument if there are
/// fewer than kFewestSmoothedElevations elevations or if an option is out of its range. Throws it
/// also if a joint turns so far from row to row that the steps do not converge; the message names
/// joint and plane.
[[nodiscard]] RhythmTable Smoothed(const RhythmTable& table, const SmoothingOptions& options = {});

/// Indices of a position in a table. A second difference has the position of the middle one of its
/// three rows.
struct GridPlace {
  std::size_t plane = 0;
  std::size_t elevation = 0;
};
/// The largest of an angle [rad] over a table's positions, and its position.
using LargestOnGrid = WorstCase<GridPlace>;

/// The bend of the rows of one joint.
struct JointBend {
  /// w_i+1 - w_i| with w of equation (2), for uneven elevations in the steps of (3).
  LargestOnGrid rotation;
  /// The second difference of each Euler angle alone; the largest of the three.
  LargestOnGrid euler;
};

/// The changes of one joint by smoothing.
struct JointChange {
  LargestOnGrid move;  ///< angle between a row before and after
  JointBend before;
  JointBend after;
};

/// Returns the changes of SC, AC and GH between two tables. Throws std::invalid_argument if the
/// tables have different planes or elevations.
[[nodiscard]] std::array<JointChange, kJointCount> ChangesBetween(const RhythmTable& before,
                                                                  const RhythmTable& after);

}  // namespace girdle
