// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/squad_rhythm.h"

#include <algorithm>
#include <glm/gtc/quaternion.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

namespace girdle {
namespace {

JointRotations RotationsAt(const RhythmPosition& position) noexcept {
  const ShoulderPose pose = PoseFromAngles(position.angles_rad);
  return {pose.q_TC, pose.q_CS, pose.q_SH};
}

// Most joint rotations that a cell needs along elevation: in its two planes and the next on each
// side.
constexpr std::size_t kMostRotations = 4 * kJointCount;

// Cosine of half the angle between rotations that are half a turn apart: 0 within rounding.
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

// Returns the joints at the elevations of one plane. Signs agree along elevation, and from plane to
// plane at the first elevation. `previous` is the plane before, empty for the first plane.
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

}  // namespace

SquadRhythm::Rows::Rows(std::vector<SpherePoint> points, std::size_t row_size)
    : row_size_(row_size), points_(std::move(points)), lengths_(points_.size() - row_size) {
  const std::span all(std::as_const(points_));
  for (std::size_t first = 0; first < lengths_.size(); first += row_size) {
    const Arcs arcs =
        MeasuredArcs(all.subspan(first, row_size), all.subspan(first + row_size, row_size),
                     std::span(lengths_).subspan(first, row_size));
    least_.push_back(arcs.least);
  }
}

SquadRhythm::SquadRhythm(const RhythmTable& table, bool smooths)
    : smooths_(smooths), planes_(table.planes_rad().size()) {
  const std::size_t elevations = table.elevations_rad().size();
  const std::size_t row_size = planes_ * kJointCount;
  std::vector<SpherePoint> points(elevations * row_size);
  std::vector<JointRotations> rotations;
  for (std::size_t plane = 0; plane < planes_; ++plane) {
    rotations = AlignedKnots(table, plane, rotations);
    for (std::size_t i = 0; i < elevations; ++i) {
      for (std::size_t joint = 0; joint < kJointCount; ++joint) {
        points[i * row_size + plane * kJointCount + joint] = SpherePoint(rotations[i][joint]);
      }
    }
  }
  knots_ = Rows(points, row_size);
  if (smooths_) {
    // The ends of a series have one neighbour only: s_0 = q_0 and s_n = q_n, which are already
    // copied.
    for (std::size_t i = 1; i + 1 < elevations; ++i) {
      SquadControl(knots_.ArcsFrom(i - 1), knots_.ArcsFrom(i),
                   std::span(points).subspan(i * row_size, row_size));
    }
    controls_ = Rows(std::move(points), row_size);
  }
}

// q_j = squad along theta in plane j                                                    (10), (11)
GIRDLE_INLINE void SquadRhythm::AlongElevation(const RhythmCell& cell, std::size_t first_plane,
                                               std::span<SpherePoint> points) const noexcept {
  const std::size_t i = cell.elevation_index;
  const std::size_t first = first_plane * kJointCount;
  const Arcs knots = knots_.ArcsFrom(i).Part(first, points.size());
  if (!smooths_) {
    knots.At(cell.elevation_weight, points);
    return;
  }
  const Arcs controls = controls_.ArcsFrom(i).Part(first, points.size());
  Squad<kMostRotations>(knots, controls, cell.elevation_weight, points);
}

// q = squad(q_j, q_j+1, t_psi), control points from the neighbouring planes at the same theta (12)
JointRotations SquadRhythm::RotationsIn(const RhythmCell& cell) const noexcept {
  // The planes j - 1 to j + 2, if they exist and are needed.
  const std::size_t j = cell.plane_index;
  const std::size_t first = smooths_ && j > 0 ? j - 1 : j;
  const std::size_t last = smooths_ ? std::min(j + 2, planes_ - 1) : j + 1;
  const std::size_t count = (last - first + 1) * kJointCount;
  std::array<SpherePoint, kMostRotations> knot_storage;
  const std::span knots(knot_storage.data(), count);
  AlongElevation(cell, first, knots);

  // Arcs from the joints in each plane to those in the next.
  const std::size_t arc_count = count - kJointCount;
  std::array<double, kMostRotations> lengths;  // NOLINT(*-member-init): filled next
  const Arcs arcs =
      MeasuredArcs(knots.first(arc_count), knots.last(arc_count), {lengths.data(), arc_count});
  const std::size_t here = (j - first) * kJointCount;
  const Arcs cell_arcs = arcs.Part(here, kJointCount);
  std::array<SpherePoint, kJointCount> joints;
  if (smooths_) {
    // The ends of the series are their own control points, as along elevation.
    std::array<SpherePoint, kMostRotations> controls;
    const std::size_t inner_count = arc_count - kJointCount;
    std::copy_n(knots.begin(), kJointCount, controls.begin());
    SquadControl(arcs.Part(0, inner_count), arcs.Part(kJointCount, inner_count),
                 {controls.data() + kJointCount, inner_count});
    std::copy_n(knots.end() - kJointCount, kJointCount, controls.begin() + arc_count);
    const std::span<const SpherePoint> s(controls);
    std::array<double, kJointCount> control_lengths;  // NOLINT(*-member-init): filled next
    const Arcs control_arcs = MeasuredArcs(
        s.subspan(here, kJointCount), s.subspan(here + kJointCount, kJointCount), control_lengths);
    Squad<kJointCount>(cell_arcs, control_arcs, cell.plane_weight, joints);
  } else {
    cell_arcs.At(cell.plane_weight, joints);
  }
  return {joints[0].quaternion(), joints[1].quaternion(), joints[2].quaternion()};
}

}  // namespace girdle
