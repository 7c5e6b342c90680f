// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/assembled_rhythm.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace girdle {
namespace {

// Width over which u fades out beyond the table. Below the table, u fades out over the whole way to
// hanging.
constexpr double kFade_rad = 30 * kRadiansPerDegree;

// Returns 1 up to an edge and 0 from `width` past it on. Twice continuously differentiable.
double Fading(double past_edge_rad, double width_rad) noexcept {
  if (past_edge_rad <= 0) {
    return 1;
  }
  if (past_edge_rad >= width_rad) {
    return 0;
  }
  const double s = past_edge_rad / width_rad;
  return 1 - s * s * s * (10 - s * (15 - 6 * s));
}

// Returns a coordinate that follows `value` within a table. Past the table's edges it slows down
// over a short way and comes to rest, because a spline runs away fast past the edge of its last
// cell. The slope is Fading, so that the result is twice continuously differentiable.
double Slowing(double value, double lowest, double highest) noexcept {
  constexpr double kWidth_rad = 10 * kRadiansPerDegree;
  const auto past = [](double distance) {
    const double s = std::min(distance / kWidth_rad, 1.0);
    return kWidth_rad * s * (1 - s * s * s * (2.5 - s * (3 - s)));
  };
  if (value > highest) {
    return highest + past(value - highest);
  }
  return value < lowest ? lowest - past(lowest - value) : value;
}

}  // namespace

ScapulothoracicRanges AssembledRhythm::Unbounded() noexcept {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  ScapulothoracicRanges ranges;
  ranges.fill({-kInfinity, kInfinity});
  return ranges;
}

AssembledRhythm::AssembledRhythm(ShoulderRhythm rhythm, Assembly assembly,
                                 const ScapulothoracicRanges& st_ranges)
    : rhythm_(std::move(rhythm)), assembly_(assembly), st_ranges_(st_ranges) {
  if (assembly == Assembly::kLoop) {
    correction_ = CorrectionOf(rhythm_.table());
  }
}

std::optional<AssembledRhythm::Correction> AssembledRhythm::CorrectionOf(const RhythmTable& table) {
  constexpr std::size_t kFewest = 3;  // that a spline needs
  const std::size_t planes = table.planes_rad().size();
  const std::size_t elevations = table.elevations_rad().size();
  if (planes < kFewest || elevations < kFewest) {
    throw std::invalid_argument(
        "the assembly loop needs a table of at least 3 planes and 3 elevations, this one has " +
        std::to_string(planes) + " and " + std::to_string(elevations));
  }
  const SurfaceGrid grid{SplineAxis(table.elevations_rad()), SplineAxis(table.planes_rad())};
  if (!table.position(0, 0).scapulothoracic_rad) {
    return std::nullopt;  // either all positions have it or none has
  }
  const auto u_at = [&table](std::size_t elevation, std::size_t plane) {
    const RhythmPosition& position = table.position(plane, elevation);
    const Quaternion q_TS = QuaternionFromEuler(EulerSequence::kYXZ, *position.scapulothoracic_rad);
    const Vector3 u = Log(glm::conjugate(PoseFromAngles(position.angles_rad).q_TS()) * q_TS);
    return SurfaceSpline<double, 3>::Values{u.x, u.y, u.z};
  };
  return Correction{grid,
                    SurfaceSpline<double, 3>(grid, u_at),
                    {table.elevations_rad().front(), table.elevations_rad().back(),
                     table.planes_rad().front(), table.planes_rad().back()}};
}

Vector3 AssembledRhythm::Correction::At(double elevation_rad, double plane_rad) const noexcept {
  const double weight =
      Fading(measured.lowest_elevation_rad - elevation_rad, measured.lowest_elevation_rad) *
      Fading(elevation_rad - measured.highest_elevation_rad,
             std::min(kFade_rad, kPi - measured.highest_elevation_rad)) *
      Fading(measured.first_plane_rad - plane_rad, kFade_rad) *
      Fading(plane_rad - measured.last_plane_rad, kFade_rad);
  if (weight == 0) {
    return {0, 0, 0};
  }
  const auto u = surface.At(grid.PlaceOf(
      Slowing(elevation_rad, measured.lowest_elevation_rad, measured.highest_elevation_rad),
      Slowing(plane_rad, measured.first_plane_rad, measured.last_plane_rad)));
  return weight * Vector3{u[0], u[1], u[2]};
}

ShoulderPose AssembledRhythm::Corrected(const ArmCommand& command,
                                        ArmCommand& used) const noexcept {
  ShoulderPose pose = rhythm_.SolvePose(command, &used);
  if (correction_) {
    const Quaternion q_TH = pose.q_TH();
    pose.q_CS = pose.q_CS * Exp(correction_->At(used.elevation_rad, used.plane_rad));
    if (rhythm_.options().closure == Closure::kExact) {
      pose.q_SH = glm::conjugate(pose.q_TS()) * q_TH;
    }
  }
  return pose;
}

bool AssembledRhythm::KeepsScapulaWithin(const ShoulderPose& pose) const noexcept {
  const Vector3 st_rad = EulerFromQuaternion(EulerSequence::kYXZ, pose.q_TS());
  for (int i = 0; i < 3; ++i) {
    const CoordinateRange& range = st_ranges_[static_cast<std::size_t>(i)];
    if (st_rad[i] < range.lower_rad || st_rad[i] > range.upper_rad) {
      return false;
    }
  }
  return true;
}

ShoulderPose AssembledRhythm::SolvePose(const ArmCommand& command,
                                        ArmCommand* used) const noexcept {
  if (assembly_ == Assembly::kTree) {
    return rhythm_.SolvePose(command, used);
  }
  ArmCommand answered;
  ShoulderPose pose = Corrected(command, answered);
  if ((answered.shrug_rad != 0 || answered.protraction_rad != 0) && !KeepsScapulaWithin(pose)) {
    // Bisection finds the largest share of the offsets that keeps ST within its ranges.
    ArmCommand less = answered;
    double share = 0;
    double step = 0.5;
    constexpr int kHalvings = 30;  // to 1e-9 of the offsets
    for (int i = 0; i < kHalvings; ++i, step /= 2) {
      less.shrug_rad = (share + step) * answered.shrug_rad;
      less.protraction_rad = (share + step) * answered.protraction_rad;
      ArmCommand ignored;
      share += KeepsScapulaWithin(Corrected(less, ignored)) ? step : 0;
    }
    less.shrug_rad = share * answered.shrug_rad;
    less.protraction_rad = share * answered.protraction_rad;
    pose = Corrected(less, answered);
  }
  // GH's last hinge turns about the humerus itself. A turn past its range is taken back, but no
  // more than the axial turn itself. A hinge at the end of its range may be off by rounding.
  const double hinge_rad = AnglesFromPose(pose)[kGhAxialIndex];
  const CoordinateRange& range = rhythm_.ranges()[kGhAxialIndex];
  const double excess_rad = hinge_rad - std::clamp(hinge_rad, range.lower_rad, range.upper_rad);
  const double taken_back_rad =
      std::clamp(excess_rad, std::min(answered.axial_rad, 0.0), std::max(answered.axial_rad, 0.0));
  constexpr double kRounding_rad = 1e-12;
  if (std::abs(taken_back_rad) > kRounding_rad) {
    pose.q_SH = pose.q_SH * Exp({0, -taken_back_rad, 0});
    answered.axial_rad -= taken_back_rad;
  }
  if (used != nullptr) {
    *used = answered;
  }
  return pose;
}

JointAngles AssembledRhythm::SolveAngles(const ArmCommand& command,
                                         ArmCommand* used) const noexcept {
  return DrivenAngles(assembly_, SolvePose(command, used));
}

}  // namespace girdle
