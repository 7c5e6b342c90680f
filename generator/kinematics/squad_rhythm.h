// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The published interpolation of a measured rhythm: squad (or slerp instead) along elevation, then
/// along plane.
///
/// Method: Kim, Park, Jung, Han, "Data-driven shoulder inverse kinematics". Equation numbers below
/// are the paper's.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "kinematics/rhythm_table.h"
#include "kinematics/rotation_spline.h"

namespace girdle {

/// Rotations of the joints of a shoulder: SC, AC, GH.
using JointRotations = std::array<Quaternion, kJointCount>;

/// Interpolates the joints of a table by equations (4) to (12). Immutable. Evaluation is
/// thread-safe and allocates nothing.
class SquadRhythm {
 public:
  /// Uses squad if `smooths` is true, otherwise slerp. Throws std::invalid_argument if neighbouring
  /// planes differ by 180 degrees or more, because the way between them is then not determined.
  SquadRhythm(const RhythmTable& table, bool smooths);

  /// Returns SC, AC and GH at a place in a cell of the table, equations (4) to (12).
  [[nodiscard]] JointRotations RotationsIn(const RhythmCell& cell) const noexcept;

 private:
  /// Points in rows of equal size, and the arcs from each point to that of the next row.
  class Rows {
   public:
    Rows() = default;
    Rows(std::vector<SpherePoint> points, std::size_t row_size);

    [[nodiscard]] std::span<const SpherePoint> Row(std::size_t i) const noexcept {
      return std::span(points_).subspan(i * row_size_, row_size_);
    }
    /// Precondition: row i is not the last.
    [[nodiscard]] Arcs ArcsFrom(std::size_t i) const noexcept {
      return {Row(i), Row(i + 1), std::span(lengths_).subspan(i * row_size_, row_size_), least_[i]};
    }

   private:
    std::size_t row_size_ = 0;
    std::vector<SpherePoint> points_;
    std::vector<double> lengths_;  ///< as in Arcs
    std::vector<double> least_;    ///< as in Arcs, one a row
  };

  /// Computes the joints of successive planes, from `first_plane` on, at the cell's elevation.
  void AlongElevation(const RhythmCell& cell, std::size_t first_plane,
                      std::span<SpherePoint> points) const noexcept;

  bool smooths_;
  std::size_t planes_;
  /// One row for each elevation: the joints of the first plane, then those of the next, ...
  Rows knots_;
  Rows controls_;  ///< squad's inner control points; empty with slerp
};

}  // namespace girdle
