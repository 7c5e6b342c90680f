// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/smooth_rhythm.h"

#include "kinematics/smooth_rhythm_rule.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <stdexcept>
#include <string>

namespace girdle {
namespace {

// These values are from the in-vivo sets named in the header. Above the table's top, the mean rate
// over this span of elevation below the top continues. The slope at the very top is not used,
// because subjects drop out of the last rows.
constexpr double kRateSpan_rad = 30 * kRadiansPerDegree;
// SC and AC, Y-X'-Z'' [deg]. Upright: with the arm straight up (Sahara's maximum). Hanging: where
// the tangents of the planes meet on average, which is not the relaxed posture.
const Vector3 kUprightSc_deg{-54, -21, 37};
const Vector3 kUprightAc_deg{63, -23, 28};
const Vector3 kHangingSc_deg{-21.5, -9.5, -2};
const Vector3 kHangingAc_deg{55, -5, -6};

Quaternion FromDegrees(const Vector3& angles_deg) {
  return QuaternionFromEuler(EulerSequence::kYXZ, angles_deg * kRadiansPerDegree);
}

QuaternionOf<Pair> Paired(const Quaternion& a, const Quaternion& b) {
  return {{a.w, b.w}, {a.x, b.x}, {a.y, b.y}, {a.z, b.z}};
}

Quaternion Single(const QuaternionOf<Pair>& q, std::size_t i) {
  return {q.w[i], q.x[i], q.y[i], q.z[i]};
}

// Returns the posture at one end of the elevations, with quaternion signs that agree with the
// means.
QuaternionOf<Pair> EndPosture(const Vector3& sc_deg, const Vector3& ac_deg,
                              const QuaternionOf<Pair>& mean) {
  return Paired(AlignedWith(FromDegrees(sc_deg), Single(mean, 0)),
                AlignedWith(FromDegrees(ac_deg), Single(mean, 1)));
}

// Returns the rotation relative to which the logarithms of the rotations sum to zero.
Quaternion MeanRotation(const std::vector<Quaternion>& rotations) {
  Quaternion mean = rotations.front();
  constexpr int kMostRounds = 50;
  constexpr double kConverged_rad = 1e-15;
  for (int round = 0; round < kMostRounds; ++round) {
    Vector3 sum{0, 0, 0};
    for (const Quaternion& q : rotations) {
      sum += Log(q * glm::conjugate(mean));
    }
    const Vector3 step = sum / static_cast<double>(rotations.size());
    mean = glm::normalize(Exp(step) * mean);
    if (glm::length(step) < kConverged_rad) {
      break;
    }
  }
  return mean;
}

std::array<Quaternion, kJointCount> RotationsAt(const RhythmTable& table, std::size_t elevation,
                                                std::size_t plane) {
  const ShoulderPose pose = PoseFromAngles(table.position(plane, elevation).angles_rad);
  return {pose.q_TC, pose.q_CS, pose.q_SH};
}

// Returns log(q mean^-1). Throws near half a turn, where the logarithm is not unique.
Vector3 FromMean(const Quaternion& q, const Quaternion& mean, std::size_t joint) {
  constexpr double kFarthest_rad = 170 * kRadiansPerDegree;
  const Vector3 u = Log(q * glm::conjugate(mean));
  if (glm::length(u) > kFarthest_rad) {
    throw std::invalid_argument(
        std::string(kJointNames[joint]) + " is " +
        std::to_string(DegreesFromRadians(glm::length(u))) +
        " deg from its mean over the table, at most 170 can be interpolated smoothly. Check the "
        "signs and the sequence of the table's angles");
  }
  return u;
}

SplineAxis Axis(const std::vector<double>& knots, std::size_t fewest, const char* name) {
  if (knots.size() < fewest) {
    throw std::invalid_argument("the table has " + std::to_string(knots.size()) + " " + name +
                                ", the smooth interpolation needs at least " +
                                std::to_string(fewest) +
                                ". Add some, or choose the interpolation squad or slerp");
  }
  return SplineAxis(knots);
}

// Returns tau of every position, elevation by elevation in each plane, without jumps of a whole
// turn.
std::vector<double> TurnsOf(const RhythmTable& table) {
  const std::size_t elevations = table.elevations_rad().size();
  std::vector<double> turns_rad(table.planes_rad().size() * elevations);
  for (std::size_t plane = 0; plane < table.planes_rad().size(); ++plane) {
    for (std::size_t i = 0; i < elevations; ++i) {
      const Quaternion q_TH = PoseFromAngles(table.position(plane, i).angles_rad).q_TH();
      double turn_rad = 2 * std::atan2(q_TH.y, q_TH.w);
      if (plane > 0 || i > 0) {
        const double neighbour_rad =
            i > 0 ? turns_rad[plane * elevations + i - 1] : turns_rad[(plane - 1) * elevations];
        turn_rad = neighbour_rad + std::remainder(turn_rad - neighbour_rad, 2 * kPi);
      } else {
        turn_rad = std::remainder(turn_rad, 2 * kPi);
      }
      turns_rad[plane * elevations + i] = turn_rad;
    }
  }
  return turns_rad;
}

}  // namespace

SmoothRhythm::Mean SmoothRhythm::MeanOf(const RhythmTable& table) {
  std::array<std::vector<Quaternion>, kJointCount> rotations;
  for (std::size_t plane = 0; plane < table.planes_rad().size(); ++plane) {
    for (std::size_t i = 0; i < table.elevations_rad().size(); ++i) {
      const auto joints = RotationsAt(table, i, plane);
      for (std::size_t joint = 0; joint < kJointCount; ++joint) {
        rotations[joint].push_back(joints[joint]);
      }
    }
  }
  const Quaternion q_SH = MeanRotation(rotations[2]);
  return {Paired(MeanRotation(rotations[0]), MeanRotation(rotations[1])),
          {q_SH.w, q_SH.x, q_SH.y, q_SH.z}};
}

SmoothRhythm::SmoothRhythm(const RhythmTable& table)
    : edges_{table.elevations_rad().front(), table.elevations_rad().back(),
             table.planes_rad().front(), table.planes_rad().back()},
      grid_(Axis(table.elevations_rad(), kFewestElevations, "elevations"),
            Axis(table.planes_rad(), kFewestPlanes, "planes")),
      mean_(MeanOf(table)),
      girdle_(grid_,
              [&](std::size_t i, std::size_t plane) {
                const auto joints = RotationsAt(table, i, plane);
                const Vector3 sc = FromMean(joints[0], Single(mean_.q_TC_CS, 0), 0);
                const Vector3 ac = FromMean(joints[1], Single(mean_.q_TC_CS, 1), 1);
                return VectorOf<Pair>{Pair(sc.x, ac.x), Pair(sc.y, ac.y), Pair(sc.z, ac.z)};
              }),
      turn_(grid_,
            [turns = TurnsOf(table), count = table.elevations_rad().size()](std::size_t i,
                                                                            std::size_t plane) {
              return std::array<double, 1>{turns[plane * count + i]};
            }),
      glenohumeral_(grid_,
                    [&](std::size_t i, std::size_t plane) {
                      const Vector3 gh =
                          FromMean(RotationsAt(table, i, plane)[2],
                                   {mean_.q_SH.w, mean_.q_SH.x, mean_.q_SH.y, mean_.q_SH.z}, 2);
                      return std::array{Pair(gh.x, gh.y), Pair(gh.z, 0)};
                    }),
      four_(grid_,
            [&, turns = TurnsOf(table), count = table.elevations_rad().size()](std::size_t i,
                                                                               std::size_t plane) {
              const auto joints = RotationsAt(table, i, plane);
              const Vector3 sc = FromMean(joints[0], Single(mean_.q_TC_CS, 0), 0);
              const Vector3 ac = FromMean(joints[1], Single(mean_.q_TC_CS, 1), 1);
              return std::array{Four(sc.x, ac.x, sc.y, ac.y),
                                Four(sc.z, ac.z, turns[plane * count + i], 0)};
            }),
      glenohumeral_four_(grid_,
                         [&](std::size_t i, std::size_t plane) {
                           const Vector3 gh = FromMean(
                               RotationsAt(table, i, plane)[2],
                               {mean_.q_SH.w, mean_.q_SH.x, mean_.q_SH.y, mean_.q_SH.z}, 2);
                           return std::array{Four(gh.x, gh.y, gh.z, 0)};
                         }),
      mean_fours_{mean_.q_TC_CS.w, mean_.q_TC_CS.x, mean_.q_TC_CS.y, mean_.q_TC_CS.z},
      hanging_(EndPosture(kHangingSc_deg, kHangingAc_deg, mean_.q_TC_CS)),
      upright_(EndPosture(kUprightSc_deg, kUprightAc_deg, mean_.q_TC_CS)),
      span_rad_(std::min(kRateSpan_rad, edges_.highest_rad - edges_.lowest_rad)),
      bottom_(EndRowAt(edges_.lowest_rad, std::nullopt)),
      top_(EndRowAt(edges_.highest_rad, edges_.highest_rad - span_rad_)) {
  for (const double plane_rad : table.planes_rad()) {
    hanging_turn_rad_ += turn_.At(grid_.PlaceOf(edges_.lowest_rad, plane_rad))[0] /
                         static_cast<double>(table.planes_rad().size());
  }
}

SmoothRhythm::EndRow SmoothRhythm::EndRowAt(
    double elevation_rad, std::optional<double> inner_elevation_rad) const noexcept {
  // Derivatives by elevation, in the form of jets.
  const auto edge_at = [this](double theta, bool is_above) {
    Jet<double, 1> jet(theta);
    jet.part[kByElevation] = 1;
    const Edge<Jet<double, 1>> edge = EdgeAt<Jet<double, 1>>(jet, is_above);
    const auto dual = [](const auto& x) { return Dual(x.part[kValue], x.part[kByElevation]); };
    return Edge<Dual<double>>{{dual(edge.q.w), dual(edge.q.x), dual(edge.q.y), dual(edge.q.z)},
                              {dual(edge.w[0]), dual(edge.w[1]), dual(edge.w[2])},
                              dual(edge.turn_rad),
                              dual(edge.turn_by_plane)};
  };
  const double inner_rad = inner_elevation_rad.value_or(elevation_rad);
  const auto corner = [&](bool is_above) {
    return Corner{edge_at(elevation_rad, is_above), edge_at(inner_rad, is_above)};
  };
  return {elevation_rad,     inner_elevation_rad, SineOf(Dual<double>(elevation_rad, 1)),
          SineOf(inner_rad), corner(false),       corner(true)};
}

std::size_t SmoothRhythm::RegionOf(double elevation_rad, double plane_rad) const noexcept {
  constexpr std::size_t kElevationRegions = 6;
  std::size_t by_plane = 0;
  if (plane_rad > edges_.last_plane_rad) {
    by_plane = 2;
  } else if (plane_rad < edges_.first_plane_rad) {
    by_plane = 1;
  }
  std::size_t by_elevation = 0;
  if (elevation_rad > edges_.highest_rad) {
    const double half_rad = (kPi - edges_.highest_rad) / 2;
    const double x = elevation_rad - edges_.highest_rad;
    by_elevation = x > half_rad ? 4 : 3;
    by_elevation = x < half_rad / 2 ? 2 : by_elevation;
  } else if (elevation_rad < edges_.lowest_rad) {
    by_elevation = 1;
  } else if (by_plane != 0 && elevation_rad > kPi / 2) {
    by_elevation = kElevationRegions - 1;
  }
  return by_plane * kElevationRegions + by_elevation;
}

void SmoothRhythm::CheckWholeRange(const RhythmTable& table) const {
  constexpr double kFarthest_rad = kPi / 2;
  for (const double plane_rad : table.planes_rad()) {
    const auto check = [&](double elevation_rad, const QuaternionOf<Pair>& posture) {
      const QuaternionOf<Pair> q = Girdle<double>(elevation_rad, plane_rad).q_TC_CS;
      for (std::size_t joint = 0; joint < 2; ++joint) {
        const double angle_rad = AngleBetween(Single(q, joint), Single(posture, joint));
        if (angle_rad > kFarthest_rad) {
          throw std::invalid_argument(
              std::string(kJointNames[joint]) + " at plane " +
              std::to_string(DegreesFromRadians(plane_rad)) + ", elevation " +
              std::to_string(DegreesFromRadians(elevation_rad)) + " deg is " +
              std::to_string(DegreesFromRadians(angle_rad)) +
              " deg from where the arm hangs or points up, too far to go on from the table. "
              "Choose the range clamp");
        }
      }
    };
    check(edges_.lowest_rad, hanging_);
    check(edges_.highest_rad, upright_);
  }
}

MovingRotation<Pair> SmoothRhythm::MovingGirdle(const SurfaceGrid::Place& place) const noexcept {
  const auto u = girdle_.JetsAt<1>(place);
  const auto part = [&u](JetPart i) {
    return VectorOf<Pair>{u[0].part[i], u[1].part[i], u[2].part[i]};
  };
  return MovingExp(part(kValue), part(kByElevation), part(kByPlane), mean_.q_TC_CS);
}

GirdleRates SmoothRhythm::RatesOfGirdle(double elevation_rad, double plane_rad) const noexcept {
  const SurfaceGrid::Place place = grid_.PlaceOf(elevation_rad, plane_rad);
  const Jet<double, 1> turn = turn_.JetsAt<1>(place)[0];
  return {MovingGirdle(place), turn.part[kValue], turn.part[kByElevation], turn.part[kByPlane]};
}

JointRates SmoothRhythm::RatesOfJoints(double elevation_rad, double plane_rad) const noexcept {
  const SurfaceGrid::Place place = grid_.PlaceOf(elevation_rad, plane_rad);
  const auto gh = glenohumeral_.JetsAt<1>(place);
  const auto part = [&gh](JetPart i) {
    return VectorOf<double>{gh[0].part[i][0], gh[0].part[i][1], gh[1].part[i][0]};
  };
  return {MovingGirdle(place),
          MovingExp(part(kValue), part(kByElevation), part(kByPlane), mean_.q_SH)};
}

template GirdleOf<double> SmoothRhythm::Girdle(double, double) const noexcept;
template GirdleOf<Jet<double, 1>> SmoothRhythm::Girdle(double, double) const noexcept;
template GirdleOf<Jet<double, 2>> SmoothRhythm::Girdle(double, double) const noexcept;
template JointsOf<double> SmoothRhythm::Joints(double, double) const noexcept;
template JointsOf<Jet<double, 1>> SmoothRhythm::Joints(double, double) const noexcept;
template JointsOf<Jet<double, 2>> SmoothRhythm::Joints(double, double) const noexcept;

}  // namespace girdle
