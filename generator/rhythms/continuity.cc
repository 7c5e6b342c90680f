// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "rhythms/continuity.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>

#include "kinematics/one_sided_difference.h"
#include "kinematics/worst_case.h"
#include "text/number_text.h"

namespace girdle {
namespace {

using BoneRotations = std::array<Quaternion, kJointCount>;

constexpr double kGrid_rad = kRadiansPerDegree;

BoneRotations JointsOf(const ShoulderPose& pose) { return {pose.q_TC, pose.q_CS, pose.q_SH}; }

// Returns the rotations of clavicle, scapula and humerus in the thorax.
BoneRotations BonesOf(const ShoulderPose& pose) { return {pose.q_TC, pose.q_TS(), pose.q_TH()}; }

// First and second derivative of the rotation vector log(q(x) q(0)^-1) at 0: the angular velocity
// and its derivative.
struct Motion {
  Vector3 first;
  Vector3 second;
};

// Computes the derivatives from the points 0, h .. 4h on one side (h may be negative).
std::array<Motion, kJointCount> OneSided(const std::function<BoneRotations(double)>& at, double h) {
  const BoneRotations origin = at(0);
  std::array<Motion, kJointCount> motions;
  motions.fill({{0, 0, 0}, {0, 0, 0}});
  for (std::size_t i = 0; i < kOneSidedFirst.size(); ++i) {
    const BoneRotations there = at(static_cast<double>(i + 1) * h);
    for (std::size_t joint = 0; joint < kJointCount; ++joint) {
      const Vector3 turn = Log(there[joint] * glm::conjugate(origin[joint]));
      motions[joint].first += kOneSidedFirst[i] / h * turn;
      motions[joint].second += kOneSidedSecond[i] / (h * h) * turn;
    }
  }
  return motions;
}

// Returns the jump of each joint where a path along a direction crosses a place.
std::array<JumpSummary, kJointCount> JumpsAt(const PoseFunction& pose, Direction direction,
                                             const ArmCommand& place) {
  const auto at = [&](double step_rad) {
    return JointsOf(pose(MovedAlong(direction, place, step_rad)));
  };
  const auto before = OneSided(at, -kOneSidedStep_rad);
  const auto after = OneSided(at, kOneSidedStep_rad);
  std::array<JumpSummary, kJointCount> jumps;
  for (std::size_t joint = 0; joint < kJointCount; ++joint) {
    jumps[joint] = {glm::distance(before[joint].first, after[joint].first),
                    glm::distance(before[joint].second, after[joint].second) * kRadiansPerDegree};
  }
  return jumps;
}

std::string PlaceText(const ArmCommand& place) {
  constexpr int kDecimals = 1;
  return "elevation " + RoundedText(DegreesFromRadians(place.elevation_rad), kDecimals) +
         ", plane " + RoundedText(DegreesFromRadians(place.plane_rad), kDecimals);
}

using Largest = WorstCase<ArmCommand>;

// Returns a check. A check without any place passes, because a rhythm need not have such places.
RhythmCheck CheckOf(const Largest& largest, std::string name, double limit, std::string unit) {
  if (largest.empty()) {
    return {std::move(name), -std::numeric_limits<double>::infinity(), limit, std::move(unit),
            "nowhere"};
  }
  return {std::move(name), largest.value(), limit, std::move(unit), PlaceText(largest.place())};
}

// Adds the jumps over lines of constant elevation or plane, along the whole of each.
class JumpMeter {
 public:
  explicit JumpMeter(const PoseFunction& pose) : pose_(pose) {}

  void Cross(Direction direction, const std::vector<double>& lines,
             const std::vector<double>& along) {
    for (const double line : lines) {
      for (const double place : along) {
        CrossAt(direction, direction == Direction::kElevation ? ArmCommand{line, place}
                                                              : ArmCommand{place, line});
      }
    }
  }

  void CrossAt(Direction direction, const ArmCommand& place) {
    const auto jumps = JumpsAt(pose_, direction, place);
    for (std::size_t joint = 0; joint < kJointCount; ++joint) {
      joints_[joint].first = WorseOf(joints_[joint].first, jumps[joint].first);
      joints_[joint].second = WorseOf(joints_[joint].second, jumps[joint].second);
      first_.Add(jumps[joint].first, place);
      second_.Add(jumps[joint].second, place);
    }
  }

  [[nodiscard]] const std::array<JumpSummary, kJointCount>& joints() const { return joints_; }
  [[nodiscard]] const Largest& first() const { return first_; }
  [[nodiscard]] const Largest& second() const { return second_; }

 private:
  const PoseFunction& pose_;
  std::array<JumpSummary, kJointCount> joints_{};
  Largest first_;
  Largest second_;
};

JumpMeter InsideJumps(const RhythmTable& table, const PoseFunction& pose, Direction direction) {
  JumpMeter meter(pose);
  for (const ArmCommand& place : KnotCrossings(table, direction)) {
    meter.CrossAt(direction, place);
  }
  return meter;
}

class Checker {
 public:
  Checker(const ShoulderRhythm& rhythm, const JointRanges& ranges, const PoseFunction& pose)
      : rhythm_(rhythm),
        pose_(pose),
        ranges_(ranges),
        is_whole_(rhythm.options().range == Range::kWhole),
        elevations_(
            EvenSteps(rhythm.domain().lowest_elevation_rad, rhythm.domain().highest_elevation_rad)),
        planes_(EvenSteps(rhythm.domain().first_plane_rad, rhythm.domain().last_plane_rad)) {}

  std::vector<RhythmCheck> Run() {
    if (rhythm_.options().interpolation == Interpolation::kSmooth) {
      AddInsideJumps();
    }
    if (is_whole_) {
      AddBorderJumps();
      AddSingleValues();
      AddSpins();
    }
    AddGrid();
    return std::move(checks_);
  }

 private:
  void AddInsideJumps() {
    constexpr double kFirst = 1e-9;
    constexpr double kSecond = 1e-7;
    for (const Direction direction : {Direction::kElevation, Direction::kPlane}) {
      const JumpMeter meter = InsideJumps(rhythm_.table(), pose_, direction);
      const std::string lines = "over " + std::string(Name(direction)) + " knots";
      checks_.push_back(CheckOf(meter.first(), "jump of velocity " + lines, kFirst, "deg/deg"));
      checks_.push_back(
          CheckOf(meter.second(), "jump of acceleration " + lines, kSecond, "deg/deg^2"));
    }
  }

  // Measures jumps at the borders of the rule and where its form changes: half way from the table's
  // top to 180, and half way to there.
  void AddBorderJumps() {
    constexpr double kFirst = 1e-6;
    // Difference quotients need room before the ends and the limit of the reach.
    constexpr double kRoom_rad = 1 * kRadiansPerDegree;
    const RhythmTable& table = rhythm_.table();
    const double top_rad = table.elevations_rad().back();
    const double half_rad = (kPi - top_rad) / 2;
    JumpMeter over_elevations(pose_);
    // At 90 the turn of the humerus changes its form beyond the table.
    for (const double line_rad : {table.elevations_rad().front(), kPi / 2, top_rad,
                                  top_rad + half_rad / 2, top_rad + half_rad}) {
      if (line_rad > kRoom_rad && line_rad < kPi - kRoom_rad) {
        over_elevations.Cross(Direction::kElevation, {line_rad},
                              EvenSteps(rhythm_.LowestPlaneAt(line_rad + kRoom_rad) + kRoom_rad,
                                        rhythm_.domain().last_plane_rad - kRoom_rad));
      }
    }
    checks_.push_back(CheckOf(over_elevations.first(),
                              "jump of velocity where the table ends, over elevations", kFirst,
                              "deg/deg"));
    JumpMeter over_planes(pose_);
    for (const double line_rad : {table.planes_rad().front(), table.planes_rad().back()}) {
      for (const double elevation_rad : EvenSteps(kRoom_rad, kPi - kRoom_rad)) {
        // The table's edge may itself be the limit.
        if (line_rad - kRoom_rad > rhythm_.LowestPlaneAt(elevation_rad) &&
            line_rad + kRoom_rad < rhythm_.domain().last_plane_rad) {
          over_planes.CrossAt(Direction::kPlane, {elevation_rad, line_rad});
        }
      }
    }
    checks_.push_back(CheckOf(over_planes.first(),
                              "jump of velocity where the table ends, over planes", kFirst,
                              "deg/deg"));
  }

  // Straight up, every plane is the same direction, but the rhythm's own humerus rotates with the
  // plane. An axial turn counted from the swing's zero is the same humerus in every plane.
  void AddSpins() {
    constexpr double kStated = std::numeric_limits<double>::infinity();
    constexpr double kSame_deg = 1e-9;
    const auto humerus = [this](const ArmCommand& command) { return pose_(command).q_TH(); };
    const double end_rad = std::clamp(kPi / 2, planes_.front(), planes_.back());
    Largest own;
    own.Add(DegreesFromRadians(AngleBetween(humerus({kPi, 0}), humerus({kPi, end_rad}))), kPi,
            end_rad);
    checks_.push_back(CheckOf(own, "humerus at 180, turned from plane 0", kStated, "deg"));
    ArmCommand middle = {kPi, (planes_.front() + planes_.back()) / 2};
    middle.axial_rad = rhythm_.AxialCountedFrom(AxialFrom::kSwing, middle);
    middle.axial_from = AxialFrom::kSwing;
    const Quaternion q_TH = humerus(middle);
    Largest swung;
    for (const double plane_rad : planes_) {
      ArmCommand other = middle;
      other.plane_rad = plane_rad;
      swung.Add(DegreesFromRadians(AngleBetween(humerus(other), q_TH)), kPi, plane_rad);
    }
    checks_.push_back(
        CheckOf(swung, "humerus at 180, axial from swing, plane to plane", kSame_deg, "deg"));
  }

  // At hanging and straight up the plane has no meaning: the bones must be where they are for plane
  // 0.
  void AddSingleValues() {
    constexpr double kSame_deg = 1e-9;
    Largest hanging;
    Largest upright;
    const BoneRotations hanging_bones = BonesOf(pose_({0, 0}));
    const BoneRotations upright_bones = BonesOf(pose_({kPi, 0}));
    for (const double plane_rad : planes_) {
      const BoneRotations low = BonesOf(pose_({0, plane_rad}));
      const BoneRotations high = BonesOf(pose_({kPi, plane_rad}));
      for (std::size_t bone = 0; bone < kJointCount; ++bone) {
        hanging.Add(DegreesFromRadians(AngleBetween(low[bone], hanging_bones[bone])), 0.0,
                    plane_rad);
      }
      for (std::size_t bone = 0; bone + 1 < kJointCount; ++bone) {
        upright.Add(DegreesFromRadians(AngleBetween(high[bone], upright_bones[bone])), kPi,
                    plane_rad);
      }
    }
    checks_.push_back(
        CheckOf(hanging, "all bones at elevation 0, plane to plane", kSame_deg, "deg"));
    checks_.push_back(
        CheckOf(upright, "clavicle and scapula at 180, plane to plane", kSame_deg, "deg"));
  }

  void AddGrid() {
    for (const double elevation_rad : elevations_) {
      for (const double plane_rad : planes_) {
        if (!rhythm_.Solve({elevation_rad, plane_rad}).clamped) {
          AddPose(elevation_rad, plane_rad);
        }
      }
    }
    if (rhythm_.options().closure == Closure::kExact) {
      constexpr double kExact_deg = 1e-9;
      checks_.push_back(
          CheckOf(elevation_error_, "elevation reached - commanded", kExact_deg, "deg"));
      checks_.push_back(CheckOf(plane_error_, "plane reached - commanded", kExact_deg, "deg"));
    }
    if (rhythm_.options().interpolation == Interpolation::kSmooth) {
      constexpr double kFastest = 3;
      constexpr double kFastestLow = 4.5;
      // A humerus rotates with its plane: at elevation 15 by the sine of the elevation, and hanging
      // not at all. The planes from -60 to -95 are 35 deg. A share of 0.26 of them is passed in 15
      // deg, and midway 1.5 times as fast.
      constexpr double kFastestBehind = kFastestLow + 1.5 * 0.26 * 35 / 15;
      checks_.push_back(
          CheckOf(fastest_, "fastest bone per degree of elevation", kFastest, "deg/deg"));
      if (is_whole_) {
        checks_.push_back(CheckOf(fastest_low_,
                                  "fastest bone below elevation 15, per degree of elevation",
                                  kFastestLow, "deg/deg"));
        checks_.push_back(CheckOf(fastest_behind_,
                                  "fastest bone behind plane -60, per degree of elevation",
                                  kFastestBehind, "deg/deg"));
      }
      checks_.push_back(
          CheckOf(fastest_plane_, "fastest bone per degree of plane", kFastest, "deg/deg"));
    }
    constexpr double kOutside_deg = 1e-9;
    checks_.push_back(CheckOf(outside_, "joint out of its range", kOutside_deg, "deg"));
  }

  void AddPose(double elevation_rad, double plane_rad) {
    const ShoulderPose pose = pose_({elevation_rad, plane_rad});
    const ArmAngles reached = ArmAnglesFromRotation(pose.q_TH());
    elevation_error_.Add(DegreesFromRadians(std::abs(reached.elevation_rad - elevation_rad)),
                         elevation_rad, plane_rad);
    // Nearer to the ends than this, the plane has no meaning.
    if (elevation_rad > kGrid_rad / 2 && elevation_rad < kPi - kGrid_rad / 2) {
      plane_error_.Add(
          DegreesFromRadians(std::abs(std::remainder(reached.plane_rad - plane_rad, 2 * kPi))),
          elevation_rad, plane_rad);
    }
    const JointAngles angles_rad = AnglesFromPose(pose);
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      outside_.Add(DegreesFromRadians(std::max({ranges_[k].lower_rad - angles_rad[k],
                                                angles_rad[k] - ranges_[k].upper_rad, 0.0})),
                   elevation_rad, plane_rad);
    }
    if (rhythm_.options().interpolation == Interpolation::kSmooth) {
      AddSpeeds(elevation_rad, plane_rad);
    }
  }

  // Measures speeds by difference quotients on the inner side of the ends. Behind the body, a
  // rising arm reaches an end.
  void AddSpeeds(double elevation_rad, double plane_rad) {
    const ArmRectangle& domain = rhythm_.domain();
    const double above_rad = elevation_rad + kGrid_rad / 2;
    const double up =
        above_rad < domain.highest_elevation_rad && rhythm_.LowestPlaneAt(above_rad) <= plane_rad
            ? 1
            : -1;
    const double across = plane_rad + kGrid_rad / 2 < domain.last_plane_rad ? 1 : -1;
    const auto along_elevation = [&](double step_rad) {
      return BonesOf(pose_({elevation_rad + step_rad, plane_rad}));
    };
    const auto along_plane = [&](double step_rad) {
      return BonesOf(pose_({elevation_rad, plane_rad + step_rad}));
    };
    constexpr double kLow_rad = 15 * kRadiansPerDegree;
    constexpr double kBehind_rad = -60 * kRadiansPerDegree;
    for (const Motion& bone : OneSided(along_elevation, up * kOneSidedStep_rad)) {
      Largest& fastest = is_whole_ && plane_rad < kBehind_rad    ? fastest_behind_
                         : is_whole_ && elevation_rad < kLow_rad ? fastest_low_
                                                                 : fastest_;
      fastest.Add(glm::length(bone.first), elevation_rad, plane_rad);
    }
    for (const Motion& bone : OneSided(along_plane, across * kOneSidedStep_rad)) {
      fastest_plane_.Add(glm::length(bone.first), elevation_rad, plane_rad);
    }
  }

  const ShoulderRhythm& rhythm_;
  const PoseFunction& pose_;
  const JointRanges& ranges_;
  bool is_whole_;
  std::vector<double> elevations_;
  std::vector<double> planes_;
  Largest elevation_error_;
  Largest plane_error_;
  Largest fastest_;
  Largest fastest_low_;
  Largest fastest_behind_;
  Largest fastest_plane_;
  Largest outside_;
  std::vector<RhythmCheck> checks_;
};

}  // namespace

std::vector<InterpolationJumps> MeasureJumps(const RhythmTable& table) {
  std::vector<InterpolationJumps> all;
  for (const Interpolation interpolation :
       {Interpolation::kSlerp, Interpolation::kSquad, Interpolation::kSmooth}) {
    const ShoulderRhythm rhythm(table, {interpolation, Closure::kTable, {}});
    const PoseFunction pose = [&](const ArmCommand& command) { return rhythm.SolvePose(command); };
    for (const Direction direction : {Direction::kElevation, Direction::kPlane}) {
      all.push_back({interpolation, direction, InsideJumps(table, pose, direction).joints()});
    }
  }
  return all;
}

std::vector<RhythmCheck> MeasureChecks(const ShoulderRhythm& rhythm, const JointRanges& ranges) {
  return MeasureChecks(rhythm, ranges,
                       [&](const ArmCommand& command) { return rhythm.SolvePose(command); });
}

std::vector<RhythmCheck> MeasureChecks(const ShoulderRhythm& rhythm, const JointRanges& ranges,
                                       const PoseFunction& pose) {
  return Checker(rhythm, ranges, pose).Run();
}

}  // namespace girdle
