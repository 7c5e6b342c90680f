// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/squad_rhythm.h"

#include <algorithm>
#include <glm/gtc/quaternion.hpp>
#include <span>
#include <stdexcept>
#include <string>

namespace girdle {
namespace {

using JointPoints = SpherePoints<kJointCount>;
using JointArcLengths = ArcLengths<kJointCount>;

JointRotations RotationsAt(const RhythmPosition& position) noexcept {
  const ShoulderPose pose = PoseFromAngles(position.angles_rad);
  return {pose.q_TC, pose.q_CS, pose.q_SH};
}

// Cosine of half the angle between rotations half a turn apart, 0 but for rounding.
constexpr double kHalfTurnCosine = 1e-12;

void CheckLessThanHalfTurn(const Quaternion& knot, const Quaternion& neighbour,
                           const RhythmTable& table, std::size_t plane, std::size_t elevation,
                           std::size_t joint) {
  if (glm::dot(knot, neighbour) > kHalfTurnCosine) {
    return;
  }
  const auto degrees = [](double angle_rad) {
    return std::to_string(DegreesFromRadians(angle_rad));
  };
  throw std::invalid_argument(
      std::string(kJointNames[joint]) + " turns by 180 deg or more between planes " +
      degrees(table.planes_rad()[plane - 1]) + " and " + degrees(table.planes_rad()[plane]) +
      " deg at elevation " + degrees(table.elevations_rad()[elevation]) +
      " deg; a denser grid is needed");
}

// The joints at the elevations of one plane. Signs agree along elevation, and along plane by way of
// the first elevation. `previous` is the plane before, empty for the first.
std::vector<JointRotations> AlignedKnots(const RhythmTable& table, std::size_t plane,
                                         const std::vector<JointRotations>& previous) {
  std::vector<JointRotations> knots(table.elevations_rad().size());
  for (std::size_t i = 0; i < knots.size(); ++i) {
    knots[i] = RotationsAt(table.position(plane, i));
    for (std::size_t joint = 0; joint < kJointCount; ++joint) {
      Quaternion& knot = knots[i][joint];
      if (i > 0) {
        knot = AlignedWith(knot, knots[i - 1][joint]);
      } else if (!previous.empty()) {
        knot = AlignedWith(knot, previous[i][joint]);
      }
      if (!previous.empty()) {
        CheckLessThanHalfTurn(knot, previous[i][joint], table, plane, i, joint);
      }
    }
  }
  return knots;
}

JointPoints PointsOf(const JointRotations& rotations) noexcept {
  return {SpherePoint(rotations[0]), SpherePoint(rotations[1]), SpherePoint(rotations[2])};
}

// Lengths of the arcs from each of a series of knots to the next.
GIRDLE_INLINE void MeasureArcs(std::span<const JointPoints> knots,
                               std::span<JointArcLengths> lengths) noexcept {
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    lengths[i] = JointArcLengths(knots[i], knots[i + 1]);
  }
}

// Inner control points of a series of knots. Its ends have one neighbour: s_0 = q_0 and s_n = q_n.
GIRDLE_INLINE void FindControls(std::span<const JointPoints> knots,
                                std::span<const JointArcLengths> lengths,
                                std::span<JointPoints> controls) noexcept {
  std::copy(knots.begin(), knots.end(), controls.begin());
  for (std::size_t i = 1; i + 1 < knots.size(); ++i) {
    controls[i] = SquadControl(Arcs<kJointCount>{knots[i - 1], knots[i], lengths[i - 1]},
                               Arcs<kJointCount>{knots[i], knots[i + 1], lengths[i]});
  }
}

}  // namespace

SquadRhythm::SquadRhythm(const RhythmTable& table, bool smooths)
    : smooths_(smooths), series_(table.planes_rad().size()) {
  const std::size_t elevations = table.elevations_rad().size();
  std::vector<JointRotations> rotations;
  for (std::size_t plane = 0; plane < series_.size(); ++plane) {
    rotations = AlignedKnots(table, plane, rotations);
    Series& series = series_[plane];
    for (const JointRotations& knot : rotations) {
      series.knots.push_back(PointsOf(knot));
    }
    series.controls.resize(elevations);
    series.knot_lengths.resize(elevations - 1);
    series.control_lengths.resize(elevations - 1);
    MeasureArcs(series.knots, series.knot_lengths);
    FindControls(series.knots, series.knot_lengths, series.controls);
    MeasureArcs(series.controls, series.control_lengths);
  }
}

// q_j = squad along theta in plane j                                                       (10)
// (11)
GIRDLE_INLINE SquadRhythm::JointPoints SquadRhythm::AlongElevation(
    std::size_t plane, const RhythmCell& cell) const noexcept {
  const Series& series = series_[plane];
  const std::size_t i = cell.elevation_index;
  const JointArcs knots{series.knots[i], series.knots[i + 1], series.knot_lengths[i]};
  if (!smooths_) {
    return knots.At(cell.elevation_weight);
  }
  return Squad(knots,
               JointArcs{series.controls[i], series.controls[i + 1], series.control_lengths[i]},
               cell.elevation_weight);
}

// q = squad(q_j, q_j+1, t_psi), control points from the neighbouring planes at the same theta (12)
JointRotations SquadRhythm::RotationsIn(const RhythmCell& cell) const noexcept {
  // Planes j - 1 to j + 2 as far as there are such and they are needed.
  const std::size_t j = cell.plane_index;
  const std::size_t first = smooths_ && j > 0 ? j - 1 : j;
  const std::size_t last = smooths_ ? std::min(j + 2, series_.size() - 1) : j + 1;
  constexpr std::size_t kMostPlanes = 4;
  std::array<JointPoints, kMostPlanes> knots;
  std::array<JointArcLengths, kMostPlanes - 1> knot_lengths;
  for (std::size_t plane = first; plane <= last; ++plane) {
    knots[plane - first] = AlongElevation(plane, cell);
  }
  const std::span planes(knots.data(), last - first + 1);
  MeasureArcs(planes, knot_lengths);
  const std::size_t i = j - first;
  const JointArcs arcs{knots[i], knots[i + 1], knot_lengths[i]};
  JointPoints points;
  if (smooths_) {
    std::array<JointPoints, kMostPlanes> controls;
    FindControls(planes, knot_lengths, controls);
    const JointArcLengths control_lengths(controls[i], controls[i + 1]);
    points = Squad(arcs, JointArcs{controls[i], controls[i + 1], control_lengths},
                   cell.plane_weight);
  } else {
    points = arcs.At(cell.plane_weight);
  }
  return {points[0].quaternion(), points[1].quaternion(), points[2].quaternion()};
}

}  // namespace girdle
