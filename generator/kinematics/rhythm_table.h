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
  /// False where SC and AC were derived from other measurements rather than measured.
  bool measured = true;
  /// Published scapula in thorax [rad], Y-X'-Z''. For checking only: it never drives.
  std::optional<Vector3> scapulothoracic_rad;
};

/// Complete grid of measured positions over plane of elevation and humeral elevation.
///
/// Knots are strictly increasing, at least two in each direction; every value is finite and every
/// angle within
/// [-pi, pi]. An object that exists is valid.
class RhythmTable {
 public:
  /// `positions` holds all elevations of the first plane, then of the next. Throws
  /// std::invalid_argument that names index, value and expectation.
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

 private:
  std::vector<double> planes_rad_;
  std::vector<double> elevations_rad_;
  std::vector<RhythmPosition> positions_;
};

}  // namespace girdle
