// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/shoulder_rhythm.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <stdexcept>
#include <string>
#include <utility>

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

JointRotations RotationsAt(const RhythmPosition& position) noexcept {
  const ShoulderPose pose = PoseFromAngles(position.angles_rad);
  return {pose.q_TC, pose.q_CS, pose.q_SH};
}

// Cosine of half the angle between rotations half a turn apart, 0 but for rounding.
constexpr double kHalfTurnCosine = 1e-12;

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
    : table_(std::move(table)), options_(options), series_(table_.planes_rad().size()) {
  const std::size_t elevations = table_.elevations_rad().size();
  for (std::size_t plane = 0; plane < series_.size(); ++plane) {
    Series& series = series_[plane];
    series.knots.resize(elevations);
    for (std::size_t i = 0; i < elevations; ++i) {
      series.knots[i] = RotationsAt(table_.position(plane, i));
      AlignSigns(plane, i);
    }
    // The ends of a series have one neighbour: s_0 = q_0 and s_n = q_n.
    series.controls = series.knots;
    for (std::size_t i = 1; i + 1 < elevations; ++i) {
      series.controls[i] = SquadControl(series.knots[i - 1], series.knots[i], series.knots[i + 1]);
    }
  }
}

// Signs agree along elevation, and along plane by way of the first elevation.
void ShoulderRhythm::AlignSigns(std::size_t plane, std::size_t elevation) {
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
          degrees(table_.planes_rad()[plane - 1]) + " and " + degrees(table_.planes_rad()[plane]) +
          " deg at elevation " + degrees(table_.elevations_rad()[elevation]) +
          " deg; a denser grid is needed");
    }
  }
}

// q_j = squad along theta in plane j                                                       (10)
// (11)
JointRotations ShoulderRhythm::AlongElevation(std::size_t plane,
                                              const RhythmCell& cell) const noexcept {
  const Series& series = series_[plane];
  const std::size_t i = cell.elevation_index;
  if (options_.interpolation == Interpolation::kSlerp) {
    return Slerp(series.knots[i], series.knots[i + 1], cell.elevation_weight);
  }
  return Squad(series.knots[i], series.knots[i + 1], series.controls[i], series.controls[i + 1],
               cell.elevation_weight);
}

// q = squad(q_j, q_j+1, t_psi), control points from the neighbouring planes at the same theta (12)
JointRotations ShoulderRhythm::RotationsIn(const RhythmCell& cell) const noexcept {
  const std::size_t j = cell.plane_index;
  const JointRotations q_j = AlongElevation(j, cell);
  const JointRotations q_next = AlongElevation(j + 1, cell);
  if (options_.interpolation == Interpolation::kSlerp) {
    return Slerp(q_j, q_next, cell.plane_weight);
  }
  const JointRotations s_j = j == 0 ? q_j : SquadControl(AlongElevation(j - 1, cell), q_j, q_next);
  const JointRotations s_next =
      j + 2 == series_.size() ? q_next : SquadControl(q_j, q_next, AlongElevation(j + 2, cell));
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
  const double elevation_rad =
      Clamped(command.elevation_rad, elevations.front(), elevations.back());
  const double plane_rad = Clamped(command.plane_rad, planes.front(), planes.back());

  RhythmCell cell{};
  cell.elevation_index = IntervalIndex(elevations, elevation_rad);
  cell.plane_index = IntervalIndex(planes, plane_rad);
  cell.elevation_weight = IntervalWeight(elevations, cell.elevation_index, elevation_rad);
  cell.plane_weight = IntervalWeight(planes, cell.plane_index, plane_rad);

  const JointRotations rotations = RotationsIn(cell);
  ShoulderPose pose{rotations[0], rotations[1], rotations[2]};
  // A turn about the humerus's own y comes last in X-Z'-Y'': it adds to the measured axial angle.
  if (std::isfinite(command.axial_rad) && command.axial_rad != 0) {
    const double half_rad = command.axial_rad / 2;
    pose.q_SH = pose.q_SH * Quaternion{std::cos(half_rad), 0, std::sin(half_rad), 0};
  }

  const bool clamped = elevation_rad != command.elevation_rad || plane_rad != command.plane_rad;
  return {pose, cell, clamped,
          clamped ? DistanceOutside(command.elevation_rad, command.plane_rad) : 0};
}

}  // namespace girdle
