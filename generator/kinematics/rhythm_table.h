// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The measured shoulder rhythm: joint angles on a complete grid of planes and elevations.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "kinematics/shoulder_pose.h"

namespace girdle {

/// One measured position of the arm.
struct RhythmPosition {
  JointAngles angles_rad{};  ///< SC, AC, GH, each within [-pi, pi]
  /// False if SC and AC were derived from other measurements.
  bool measured = true;
  /// Published angles of the scapula in the thorax [rad], Y-X'-Z''. They serve as a check only and
  /// never drive a joint.
  std::optional<Vector3> scapulothoracic_rad;
};

/// A cell of the grid and a place within it.
struct RhythmCell {
  std::size_t elevation_index;  ///< i of equation (6): the cell lies between knots i and i + 1
  std::size_t plane_index;      ///< j of equation (7)
  double elevation_weight;      ///< t_theta of equation (8), [0, 1]
  double plane_weight;          ///< t_psi of equation (9), [0, 1]
};

/// Complete grid of measured positions over plane of elevation and humeral elevation.
///
/// An object that exists is valid. Each direction has at least two knots, which increase strictly.
/// Every value is finite, and every joint angle is within [-pi, pi].
class RhythmTable {
 public:
  /// `positions` contains all elevations of the first plane, then those of the next plane, and so
  /// on. Throws std::invalid_argument with a message that names index, value and expectation.
  RhythmTable(std::vector<double> planes_rad, std::vector<double> elevations_rad,
              std::vector<RhythmPosition> positions);

  [[nodiscard]] const std::vector<double>& planes_rad() const noexcept { return planes_rad_; }
  [[nodiscard]] const std::vector<double>& elevations_rad() const noexcept {
    return elevations_rad_;
  }
  /// Precondition: plane < planes_rad().size(), elevation < elevations_rad().size().
  [[nodiscard]] const RhythmPosition& position(std::size_t plane,
                                               std::size_t elevation) const noexcept {
    return positions_[plane * elevations_rad_.size() + elevation];
  }

  /// Returns the cell with theta_i < elevation <= theta_i+1 and psi_j < plane <= psi_j+1, and the
  /// place within it. The lowest edges belong to the first cells. Outside the grid the nearest
  /// point of the grid is used. A NaN counts as the lowest knot.
  [[nodiscard]] RhythmCell CellAt(double elevation_rad, double plane_rad) const noexcept;

 private:
  std::vector<double> planes_rad_;
  std::vector<double> elevations_rad_;
  std::vector<RhythmPosition> positions_;
};

}  // namespace girdle
