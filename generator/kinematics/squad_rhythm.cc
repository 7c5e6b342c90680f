// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/squad_rhythm.h"

#include <glm/gtc/quaternion.hpp>
#include <stdexcept>
#include <string>

namespace girdle {
namespace {

JointRotations RotationsAt(const RhythmPosition& position) noexcept {
  const ShoulderPose pose = PoseFromAngles(position.angles_rad);
  return {pose.q_TC, pose.q_CS, pose.q_SH};
}

// Cosine of half the angle between rotations half a turn apart, 0 but for rounding.
constexpr double kHalfTurnCosine = 1e-12;

}  // namespace

SquadRhythm::SquadRhythm(const RhythmTable& table, bool smooths)
    : smooths_(smooths), series_(table.planes_rad().size()) {
  const std::size_t elevations = table.elevations_rad().size();
  for (std::size_t plane = 0; plane < series_.size(); ++plane) {
    Series& series = series_[plane];
    series.knots.resize(elevations);
    for (std::size_t i = 0; i < elevations; ++i) {
      series.knots[i] = RotationsAt(table.position(plane, i));
      AlignSigns(table, plane, i);
    }
    // The ends of a series have one neighbour: s_0 = q_0 and s_n = q_n.
    series.controls = series.knots;
    for (std::size_t i = 1; i + 1 < elevations; ++i) {
      series.controls[i] = SquadControl(series.knots[i - 1], series.knots[i], series.knots[i + 1]);
    }
  }
}

// Signs agree along elevation, and along plane by way of the first elevation.
void SquadRhythm::AlignSigns(const RhythmTable& table, std::size_t plane, std::size_t elevation) {
  JointRotations& knot = series_[plane].knots[elevation];
  for (std::size_t joint = 0; joint < kJointCount; ++joint) {
    if (elevation > 0) {
      knot[joint] = AlignedWith(knot[joint], series_[plane].knots[elevation - 1][joint]);
    }
    if (plane == 0) {
      continue;
    }
    const Quaternion& neighbour = series_[plane - 1].knots[elevation][joint];
    if (elevation == 0) {
      knot[joint] = AlignedWith(knot[joint], neighbour);
    }
    if (glm::dot(knot[joint], neighbour) <= kHalfTurnCosine) {
      const auto degrees = [](double angle_rad) {
        return std::to_string(DegreesFromRadians(angle_rad));
      };
      throw std::invalid_argument(
          std::string(kJointNames[joint]) + " turns by 180 deg or more between planes " +
          degrees(table.planes_rad()[plane - 1]) + " and " + degrees(table.planes_rad()[plane]) +
          " deg at elevation " + degrees(table.elevations_rad()[elevation]) +
          " deg; a denser grid is needed");
    }
  }
}

// q_j = squad along theta in plane j                                                       (10)
// (11)
JointRotations SquadRhythm::AlongElevation(std::size_t plane,
                                           const RhythmCell& cell) const noexcept {
  const Series& series = series_[plane];
  const std::size_t i = cell.elevation_index;
  if (!smooths_) {
    return Slerp(series.knots[i], series.knots[i + 1], cell.elevation_weight);
  }
  return Squad(series.knots[i], series.knots[i + 1], series.controls[i], series.controls[i + 1],
               cell.elevation_weight);
}

// q = squad(q_j, q_j+1, t_psi), control points from the neighbouring planes at the same theta (12)
JointRotations SquadRhythm::RotationsIn(const RhythmCell& cell) const noexcept {
  const std::size_t j = cell.plane_index;
  const JointRotations q_j = AlongElevation(j, cell);
  const JointRotations q_next = AlongElevation(j + 1, cell);
  if (!smooths_) {
    return Slerp(q_j, q_next, cell.plane_weight);
  }
  const JointRotations s_j = j == 0 ? q_j : SquadControl(AlongElevation(j - 1, cell), q_j, q_next);
  const JointRotations s_next =
      j + 2 == series_.size() ? q_next : SquadControl(q_j, q_next, AlongElevation(j + 2, cell));
  return Squad(q_j, q_next, s_j, s_next, cell.plane_weight);
}

}  // namespace girdle
