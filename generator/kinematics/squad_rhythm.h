// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The published interpolation of a measured rhythm: squad, or slerp in its place, along elevation
/// and then along plane.
///
/// Kim, Park, Jung, Han, "Data-driven shoulder inverse kinematics"; equation numbers are theirs.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "kinematics/rhythm_table.h"
#include "kinematics/rotation_spline.h"

namespace girdle {

/// Rotations of the joints of a shoulder: SC, AC, GH.
using JointRotations = std::array<Quaternion, kJointCount>;

class SquadRhythm {
 public:
  /// With slerp in place of squad unless `smooths`. Throws std::invalid_argument if neighbouring
  /// planes differ by 180 degrees or more, so that the way between them is not determined.
  SquadRhythm(const RhythmTable& table, bool smooths);

  /// Returns SC, AC and GH at a place within a cell of the table, equations (4) to (12).
  [[nodiscard]] JointRotations RotationsIn(const RhythmCell& cell) const noexcept;

 private:
  using JointPoints = SpherePoints<kJointCount>;
  using JointArcs = Arcs<kJointCount>;
  using JointArcLengths = ArcLengths<kJointCount>;

  /// One plane: the three joints at its elevations, squad's inner control points, and the lengths
  /// of the arcs from each of them to the next.
  struct Series {
    std::vector<JointPoints> knots;
    std::vector<JointPoints> controls;
    std::vector<JointArcLengths> knot_lengths;
    std::vector<JointArcLengths> control_lengths;
  };

  [[nodiscard]] JointPoints AlongElevation(std::size_t plane,
                                           const RhythmCell& cell) const noexcept;

  bool smooths_;
  std::vector<Series> series_;  ///< one a plane
};

}  // namespace girdle
