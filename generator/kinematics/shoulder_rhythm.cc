// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/shoulder_rhythm.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <stdexcept>
#include <string>
#include <utility>

#include "kinematics/rotation_spline.h"

namespace girdle {
namespace {

template <typename Enum, std::size_t N>
std::optional<Enum> FromName(const std::array<std::string_view, N>& names,
                             std::string_view name) noexcept {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    return std::nullopt;
  }
  return static_cast<Enum>(found - names.begin());
}

Quaternion JointRotationAt(const RhythmPosition& position, std::size_t joint) noexcept {
  const ShoulderPose pose = PoseFromAngles(position.angles_rad);
  return joint == 0 ? pose.q_TC : joint == 1 ? pose.q_CS : pose.q_SH;
}

// Nearest value of [lower, upper]; a NaN gives `lower`.
double Clamped(double value, double lower, double upper) noexcept {
  return value > lower ? std::min(value, upper) : lower;
}

// Index i with knot_i < value <= knot_i+1, equations (6) and (7); the lowest knot belongs to the
// first interval. Precondition: value lies within the knots.
std::size_t IntervalIndex(const std::vector<double>& knots, double value) noexcept {
  const auto upper = std::lower_bound(knots.begin() + 1, knots.end() - 1, value);
  return static_cast<std::size_t>(upper - knots.begin()) - 1;
}

// Place within interval i, equations (8) and (9).
double IntervalWeight(const std::vector<double>& knots, std::size_t i, double value) noexcept {
  return (value - knots[i]) / (knots[i + 1] - knots[i]);
}

}  // namespace

std::optional<Interpolation> InterpolationFromName(std::string_view name) noexcept {
  return FromName<Interpolation>(kInterpolationNames, name);
}

std::optional<Closure> ClosureFromName(std::string_view name) noexcept {
  return FromName<Closure>(kClosureNames, name);
}

std::string_view Name(Interpolation interpolation) noexcept {
  return kInterpolationNames[static_cast<std::size_t>(interpolation)];
}

std::string_view Name(Closure closure) noexcept {
  return kClosureNames[static_cast<std::size_t>(closure)];
}

ShoulderRhythm::ShoulderRhythm(RhythmTable table, RhythmOptions options)
    : table_(std::move(table)), options_(options) {
  const std::size_t planes = table_.planes_rad().size();
  const std::size_t elevations = table_.elevations_rad().size();
  series_.resize(kJointCount * planes);
  for (std::size_t joint = 0; joint < kJointCount; ++joint) {
    for (std::size_t plane = 0; plane < planes; ++plane) {
      Series& series = series_[joint * planes + plane];
      series.knots.resize(elevations);
      for (std::size_t i = 0; i < elevations; ++i) {
        const Quaternion q = JointRotationAt(table_.position(plane, i), joint);
        // Signs agree along elevation, and along plane by way of the first elevation.
        const Quaternion* plane_neighbour =
            plane > 0 ? &series_[joint * planes + plane - 1].knots[i] : nullptr;
        if (i > 0) {
          series.knots[i] = AlignedWith(q, series.knots[i - 1]);
        } else {
          series.knots[i] = plane_neighbour != nullptr ? AlignedWith(q, *plane_neighbour) : q;
        }
        if (plane_neighbour != nullptr && glm::dot(series.knots[i], *plane_neighbour) <= 0) {
          throw std::invalid_argument(
              "joint " + std::to_string(joint) + " turns by 180 deg or more between planes " +
              std::to_string(DegreesFromRadians(table_.planes_rad()[plane - 1])) + " and " +
              std::to_string(DegreesFromRadians(table_.planes_rad()[plane])) +
              " deg at elevation " +
              std::to_string(DegreesFromRadians(table_.elevations_rad()[i])) +
              " deg; a denser grid is needed");
        }
      }
      // The ends of a series have one neighbour: s_0 = q_0 and s_n = q_n.
      series.controls = series.knots;
      for (std::size_t i = 1; i + 1 < elevations; ++i) {
        series.controls[i] =
            SquadControl(series.knots[i - 1], series.knots[i], series.knots[i + 1]);
      }
    }
  }
}

// q_j = squad along theta in plane j                                                          (10)
// (11)
Quaternion ShoulderRhythm::AlongElevation(std::size_t joint, std::size_t plane,
                                          const RhythmCell& cell) const noexcept {
  const Series& series = series_[joint * table_.planes_rad().size() + plane];
  const std::size_t i = cell.elevation_index;
  if (options_.interpolation == Interpolation::kSlerp) {
    return Slerp(series.knots[i], series.knots[i + 1], cell.elevation_weight);
  }
  return Squad(series.knots[i], series.knots[i + 1], series.controls[i], series.controls[i + 1],
               cell.elevation_weight);
}

// q = squad(q_j, q_j+1, t_psi), its control points from the neighbouring planes at the same theta
// (12)
Quaternion ShoulderRhythm::JointRotation(std::size_t joint, const RhythmCell& cell) const noexcept {
  const std::size_t j = cell.plane_index;
  const Quaternion q_j = AlongElevation(joint, j, cell);
  const Quaternion q_next = AlongElevation(joint, j + 1, cell);
  if (options_.interpolation == Interpolation::kSlerp) {
    return Slerp(q_j, q_next, cell.plane_weight);
  }
  const Quaternion s_j =
      j == 0 ? q_j : SquadControl(AlongElevation(joint, j - 1, cell), q_j, q_next);
  const Quaternion s_next = j + 2 == table_.planes_rad().size()
                                ? q_next
                                : SquadControl(q_j, q_next, AlongElevation(joint, j + 2, cell));
  return Squad(q_j, q_next, s_j, s_next, cell.plane_weight);
}

double ShoulderRhythm::DistanceOutside(double elevation_rad, double plane_rad) const noexcept {
  const std::vector<double>& elevations = table_.elevations_rad();
  const std::vector<double>& planes = table_.planes_rad();
  const double distance =
      std::hypot(elevation_rad - Clamped(elevation_rad, elevations.front(), elevations.back()),
                 plane_rad - Clamped(plane_rad, planes.front(), planes.back()));
  return std::isnan(distance) ? 0 : distance;
}

ShoulderSolution ShoulderRhythm::Solve(const ArmCommand& command) const noexcept {
  const std::vector<double>& planes = table_.planes_rad();
  const std::vector<double>& elevations = table_.elevations_rad();
  const double elevation = Clamped(command.elevation_rad, elevations.front(), elevations.back());
  const double plane = Clamped(command.plane_rad, planes.front(), planes.back());

  RhythmCell cell{};
  cell.elevation_index = IntervalIndex(elevations, elevation);
  cell.plane_index = IntervalIndex(planes, plane);
  cell.elevation_weight = IntervalWeight(elevations, cell.elevation_index, elevation);
  cell.plane_weight = IntervalWeight(planes, cell.plane_index, plane);

  ShoulderPose pose{JointRotation(0, cell), JointRotation(1, cell), JointRotation(2, cell)};
  // A turn about the humerus's own y comes last in X-Z'-Y'': it adds to the measured axial angle.
  if (std::isfinite(command.axial_rad) && command.axial_rad != 0) {
    pose.q_SH = pose.q_SH * Exp({0, command.axial_rad, 0});
  }

  const bool clamped = elevation != command.elevation_rad || plane != command.plane_rad;
  return {pose, cell, clamped,
          clamped ? DistanceOutside(command.elevation_rad, command.plane_rad) : 0};
}

}  // namespace girdle
