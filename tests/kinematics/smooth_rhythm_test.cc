// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/smooth_rhythm.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/arm_commands.h"
#include "kinematics/cubic_spline.h"
#include "kinematics/humerus_rotation.h"
#include "kinematics/random_rotations.h"
#include "kinematics/shipped_data.h"

namespace girdle::smooth_rhythm_test {
namespace {

// Sums of 66 weighted rotations.
constexpr double kRounding_rad = 1e-12;

const SmoothRhythm& Shipped() {
  static const SmoothRhythm kRhythm(TableOf(MeasuredRows()));
  return kRhythm;
}

ShoulderPose PoseOf(const JointsOf<double>& joints) {
  const auto plain = [](const QuaternionOf<double>& q) { return Quaternion(q.w, q.x, q.y, q.z); };
  return {plain(Element(joints.q_TC_CS, 0)), plain(Element(joints.q_TC_CS, 1)), plain(joints.q_SH)};
}

ShoulderPose PoseAt(const SmoothRhythm& rhythm, const ArmCommand& command) {
  return PoseOf(rhythm.Joints<double>(command.elevation_rad, command.plane_rad));
}

// Clavicle and scapula, and no humerus.
ShoulderPose GirdleAt(const SmoothRhythm& rhythm, const ArmCommand& command) {
  const GirdleOf<double> girdle = rhythm.Girdle<double>(command.elevation_rad, command.plane_rad);
  return PoseOf({girdle.q_TC_CS, {1, 0, 0, 0}});
}

// Turn of the humerus about its long axis after the smallest rotation that takes a hanging arm
// where it points.
double TurnOf(const Quaternion& q_TH) {
  const Vector3 hanging(0, -1, 0);
  const Vector3 direction = q_TH * hanging;
  const Vector3 across = glm::cross(hanging, direction);
  const double angle_rad = std::atan2(glm::length(across), glm::dot(hanging, direction));
  const Quaternion smallest = Exp(angle_rad * glm::normalize(across));
  return Log(glm::conjugate(smallest) * q_TH).y;
}

TEST(SmoothRhythm, PassesThroughEveryMeasuredPosition) {
  const std::vector<MeasuredRow> rows = MeasuredRows();
  ASSERT_EQ(rows.size(), 66U);
  for (const MeasuredRow& row : rows) {
    const ArmCommand command = Command_deg(row.elevation_deg, row.plane_deg);
    const ShoulderPose measured = PoseFromAngles(Radians(row.angles_deg));
    EXPECT_LT(Apart_rad(PoseAt(Shipped(), command), measured), kRounding_rad) << command;
    const ShoulderPose girdle = GirdleAt(Shipped(), command);
    EXPECT_LT(AngleBetween(girdle.q_TC, measured.q_TC), kRounding_rad) << command;
    EXPECT_LT(AngleBetween(girdle.q_CS, measured.q_CS), kRounding_rad) << command;
  }
}

TEST(SmoothRhythm, TurnsTheHumerusAsTheTableDoes) {
  for (const MeasuredRow& row : MeasuredRows()) {
    const ArmCommand command = Command_deg(row.elevation_deg, row.plane_deg);
    const double turn_rad =
        Shipped().Girdle<double>(command.elevation_rad, command.plane_rad).turn_rad;
    const double expected_rad = TurnOf(PoseFromAngles(Radians(row.angles_deg)).q_TH());
    EXPECT_NEAR(std::remainder(turn_rad - expected_rad, 2 * kPi), 0, kRounding_rad) << command;
  }
}

RC_GTEST_PROP(SmoothRhythm, GivesUnitQuaternions, ()) {
  for (const Quaternion& joint : Joints(PoseAt(Shipped(), *InnerCommand()))) {
    RC_ASSERT(std::abs(glm::length(joint) - 1) < 1e-14);
  }
}

// A table of poses over the shipped grid.
RhythmTable TableOfPoses(const std::vector<ShoulderPose>& poses) {
  std::vector<MeasuredRow> rows = MeasuredRows();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const JointAngles angles_rad = AnglesFromPose(poses.at(i));
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      rows[i].angles_deg[k] = std::remainder(DegreesFromRadians(angles_rad[k]), 360.0);
    }
  }
  return TableOf(rows);
}

// The shipped poses, each changed.
template <typename Change>
RhythmTable Changed(const Change& change) {
  std::vector<ShoulderPose> poses;
  for (const MeasuredRow& row : MeasuredRows()) {
    poses.push_back(change(PoseFromAngles(Radians(row.angles_deg))));
  }
  return TableOfPoses(poses);
}

// Angles beside a gimbal lock, to and from which the changed tables go, keep half their digits.
constexpr double kChangeRounding_rad = 1e-7;

RC_GTEST_PROP(SmoothRhythm, TurnsWithATableThatIsTurnedInItsParents, ()) {
  const Quaternion a = *UnitQuaternion();
  const Quaternion b = *UnitQuaternion();
  const Quaternion c = *UnitQuaternion();
  const SmoothRhythm turned(Changed([&](const ShoulderPose& pose) -> ShoulderPose {
    return {a * pose.q_TC, b * pose.q_CS, c * pose.q_SH};
  }));
  const ArmCommand command = *InnerCommand();
  const ShoulderPose pose = PoseAt(Shipped(), command);
  RC_ASSERT(Apart_rad(PoseAt(turned, command), {a * pose.q_TC, b * pose.q_CS, c * pose.q_SH}) <
            kChangeRounding_rad);
}

RC_GTEST_PROP(SmoothRhythm, TurnsWithATableThatIsTurnedInItsChildren, ()) {
  const Quaternion a = *UnitQuaternion();
  const Quaternion b = *UnitQuaternion();
  const Quaternion c = *UnitQuaternion();
  const SmoothRhythm turned(Changed([&](const ShoulderPose& pose) -> ShoulderPose {
    return {pose.q_TC * a, pose.q_CS * b, pose.q_SH * c};
  }));
  const ArmCommand command = *InnerCommand();
  const ShoulderPose pose = PoseAt(Shipped(), command);
  RC_ASSERT(Apart_rad(PoseAt(turned, command), {pose.q_TC * a, pose.q_CS * b, pose.q_SH * c}) <
            kChangeRounding_rad);
}

// The humerus's zero is a matter of its frame: turning it about its own axis adds to tau.
RC_GTEST_PROP(SmoothRhythm, AddsToTheTurnWhatTheHumerusIsTurnedBy, ()) {
  const double added_rad = *NumberWithin(-kPi, kPi);
  const Quaternion about_y = Exp(Vector3(0, added_rad, 0));
  const SmoothRhythm turned(Changed([&](const ShoulderPose& pose) -> ShoulderPose {
    return {pose.q_TC, pose.q_CS, pose.q_SH * about_y};
  }));
  const ArmCommand command = *InnerCommand();
  const auto turn_rad = [&](const SmoothRhythm& rhythm) {
    return rhythm.Girdle<double>(command.elevation_rad, command.plane_rad).turn_rad;
  };
  RC_ASSERT(std::abs(std::remainder(turn_rad(turned) - turn_rad(Shipped()) - added_rad, 2 * kPi)) <
            kChangeRounding_rad);
}

// The same rotation by other angles: (a, b, c) and (a +- 180, 180 - b, c +- 180).
TEST(SmoothRhythm, DoesNotDependOnTheSignsOfTheTablesQuaternions) {
  std::vector<MeasuredRow> rows = MeasuredRows();
  int flipped = 0;
  for (std::size_t i = 1; i < rows.size(); i += 3) {
    const ShoulderPose before = PoseFromAngles(Radians(rows[i].angles_deg));
    for (std::size_t joint = 0; joint < kJointCount; ++joint) {
      double* const angles_deg = &rows[i].angles_deg[3 * joint];
      const auto half_a_turn_off_deg = [](double angle_deg) {
        return angle_deg > 0 ? angle_deg - 180 : angle_deg + 180;
      };
      angles_deg[0] = half_a_turn_off_deg(angles_deg[0]);
      angles_deg[1] = (angles_deg[1] < 0 ? -180 : 180) - angles_deg[1];
      angles_deg[2] = half_a_turn_off_deg(angles_deg[2]);
    }
    const ShoulderPose after = PoseFromAngles(Radians(rows[i].angles_deg));
    for (std::size_t joint = 0; joint < kJointCount; ++joint) {
      if (glm::dot(Joints(before)[joint], Joints(after)[joint]) < 0) ++flipped;
    }
  }
  ASSERT_GT(flipped, 0) << "the test must change signs";
  const SmoothRhythm other(TableOf(rows));
  for (const double elevation_deg : Steps(15, 120, 35)) {
    for (const double plane_deg : Steps(0, 90, 12)) {
      const ArmCommand command = Command_deg(elevation_deg, plane_deg);
      EXPECT_LT(Apart_rad(PoseAt(Shipped(), command), PoseAt(other, command)), kRounding_rad)
          << command;
    }
  }
}

// Numbers over a grid of uneven knots.
struct Numbers {
  std::vector<double> elevations_rad;
  std::vector<double> planes_rad;
  std::vector<double> values;  // elevation by elevation in each plane

  [[nodiscard]] double SplineAt(double elevation_rad, double plane_rad) const {
    std::vector<double> across;
    for (std::size_t j = 0; j < planes_rad.size(); ++j) {
      const auto first = values.begin() + static_cast<std::ptrdiff_t>(j * elevations_rad.size());
      const std::vector<double> along(first,
                                      first + static_cast<std::ptrdiff_t>(elevations_rad.size()));
      across.push_back(CubicSpline(elevations_rad, along).At(elevation_rad));
    }
    return CubicSpline(planes_rad, across).At(plane_rad);
  }
};

Numbers AnyNumbers(double lowest, double highest) {
  const auto knots = [](double first, std::size_t count) {
    std::vector<double> knots_rad = {first};
    while (knots_rad.size() < count)
      knots_rad.push_back(knots_rad.back() + *NumberWithin(0.1, 0.4));
    return knots_rad;
  };
  Numbers numbers{knots(0.2, *rc::gen::inRange<std::size_t>(4, 8)),
                  knots(-0.1, *rc::gen::inRange<std::size_t>(3, 6)),
                  {}};
  const std::size_t count = numbers.elevations_rad.size() * numbers.planes_rad.size();
  while (numbers.values.size() < count) numbers.values.push_back(*NumberWithin(lowest, highest));
  return numbers;
}

// Joints that turn about one axis each, fixed in parent and child.
RC_GTEST_PROP(SmoothRhythm, AboutAFixedAxisIsTheSplineOfTheAngle, ()) {
  constexpr double kTolerance_rad = 1e-7;  // angles beside a gimbal lock
  const Numbers angles_rad = AnyNumbers(-0.8, 0.8);
  std::array<Vector3, kJointCount> axes;
  std::array<Quaternion, kJointCount> origins;
  for (std::size_t joint = 0; joint < kJointCount; ++joint) {
    axes[joint] = *UnitVector();
    origins[joint] = *UnitQuaternion();
  }
  const auto pose_of = [&](double angle_rad) -> ShoulderPose {
    const auto turned = [&](std::size_t joint) {
      return Exp(angle_rad * axes[joint]) * origins[joint];
    };
    return {turned(0), turned(1), turned(2)};
  };
  std::vector<RhythmPosition> positions;
  for (const double angle_rad : angles_rad.values) {
    JointAngles& joint_angles_rad = positions.emplace_back().angles_rad;
    joint_angles_rad = AnglesFromPose(pose_of(angle_rad));
    double& axial_rad = joint_angles_rad[kGhAxialIndex];
    axial_rad = std::clamp(std::remainder(axial_rad, 2 * kPi), -kPi, kPi);
  }
  const SmoothRhythm rhythm(
      RhythmTable(angles_rad.planes_rad, angles_rad.elevations_rad, positions));
  ArmCommand command;
  command.elevation_rad =
      *NumberWithin(angles_rad.elevations_rad.front(), angles_rad.elevations_rad.back());
  command.plane_rad = *NumberWithin(angles_rad.planes_rad.front(), angles_rad.planes_rad.back());
  const double angle_rad = angles_rad.SplineAt(command.elevation_rad, command.plane_rad);
  // Between random values a spline may swing beyond half a turn.
  RC_PRE(std::abs(angle_rad) < 2);
  RC_ASSERT(Apart_rad(PoseAt(rhythm, command), pose_of(angle_rad)) < kTolerance_rad);
}

// A number a position, so that the turn about the long axis is known.
RC_GTEST_PROP(SmoothRhythm, TurnsTheHumerusByTheSplineOfItsTurns, ()) {
  const Numbers turns_rad = AnyNumbers(-1, 1);
  std::vector<RhythmPosition> positions;
  for (std::size_t j = 0; j < turns_rad.planes_rad.size(); ++j) {
    for (std::size_t i = 0; i < turns_rad.elevations_rad.size(); ++i) {
      // A girdle that stands still, an arm raised in the frontal plane.
      const auto q = HumerusRotation(turns_rad.elevations_rad[i], 0.0,
                                     turns_rad.values[j * turns_rad.elevations_rad.size() + i]);
      positions.emplace_back().angles_rad =
          AnglesFromPose({{1, 0, 0, 0}, {1, 0, 0, 0}, {q.w, q.x, q.y, q.z}});
    }
  }
  const SmoothRhythm rhythm(RhythmTable(turns_rad.planes_rad, turns_rad.elevations_rad, positions));
  const double elevation_rad =
      *NumberWithin(turns_rad.elevations_rad.front(), turns_rad.elevations_rad.back());
  const double plane_rad = *NumberWithin(turns_rad.planes_rad.front(), turns_rad.planes_rad.back());
  RC_ASSERT(std::abs(rhythm.Girdle<double>(elevation_rad, plane_rad).turn_rad -
                     turns_rad.SplineAt(elevation_rad, plane_rad)) < 1e-10);
}

// ISB's axial angle passes half a turn, tau goes on.
TEST(SmoothRhythm, FollowsATurnOverHalfATurn) {
  const std::vector<double> elevations_rad = {0.5, 0.8, 1.1, 1.4};
  const std::vector<double> planes_rad = {0, 0.5, 1};
  std::vector<RhythmPosition> positions;
  for (std::size_t j = 0; j < planes_rad.size(); ++j) {
    for (const double elevation_rad : elevations_rad) {
      const auto q = HumerusRotation(elevation_rad, 0.0, 2.5 + elevation_rad);
      const JointAngles angles_rad =
          AnglesFromPose({{1, 0, 0, 0}, {1, 0, 0, 0}, {q.w, q.x, q.y, q.z}});
      positions.emplace_back().angles_rad = angles_rad;
      double& axial_rad = positions.back().angles_rad[kGhAxialIndex];
      axial_rad = std::clamp(std::remainder(axial_rad, 2 * kPi), -kPi, kPi);
    }
  }
  const SmoothRhythm rhythm(RhythmTable(planes_rad, elevations_rad, positions));
  for (const double elevation_rad : Steps(0.5, 1.4, 20)) {
    EXPECT_NEAR(
        std::remainder(rhythm.Girdle<double>(elevation_rad, 0.3).turn_rad - 2.5 - elevation_rad,
                       2 * kPi),
        0, kRounding_rad)
        << elevation_rad;
  }
}

RhythmTable StillTable(std::size_t planes, std::size_t elevations) {
  std::vector<double> planes_rad(planes);
  std::vector<double> elevations_rad(elevations);
  for (std::size_t j = 0; j < planes; ++j) planes_rad[j] = 0.5 * static_cast<double>(j);
  for (std::size_t i = 0; i < elevations; ++i) elevations_rad[i] = 0.2 * static_cast<double>(i + 1);
  return {planes_rad, elevations_rad, std::vector<RhythmPosition>(planes * elevations)};
}

std::string RefusalOf(const RhythmTable& table) {
  try {
    const SmoothRhythm rhythm(table);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(SmoothRhythm, NeedsThreePlanes) {
  EXPECT_EQ(
      RefusalOf(StillTable(2, 4)),
      "the table has 2 planes, the smooth interpolation needs at least 3. Add some, or choose "
      "the interpolation squad or slerp");
}

TEST(SmoothRhythm, NeedsFourElevations) {
  EXPECT_EQ(RefusalOf(StillTable(3, 3)),
            "the table has 3 elevations, the smooth interpolation needs at least 4. Add some, or "
            "choose the interpolation squad or slerp");
}

TEST(SmoothRhythm, TakesThreePlanesOfFourElevations) {
  EXPECT_EQ(RefusalOf(StillTable(3, 4)), "accepted");
}

// A clavicle that stands still but for one position of 24, half a turn away.
TEST(SmoothRhythm, RefusesARotationHalfATurnFromTheMean) {
  std::vector<RhythmPosition> positions(24);
  positions[5].angles_rad[0] = kPi;
  EXPECT_EQ(RefusalOf(RhythmTable({0, 0.5, 1}, Steps(0.2, 1.6, 7), positions)),
            "SC is 172.500000 deg from its mean over the table, at most 170 can be interpolated "
            "smoothly. Check the signs and the sequence of the table's angles");
}

std::string RefusalOfTheWholeRange(const RhythmTable& table) {
  const SmoothRhythm rhythm(table);
  try {
    rhythm.CheckWholeRange(table);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(SmoothRhythm, GoesOnFromTheShippedTable) {
  EXPECT_EQ(RefusalOfTheWholeRange(TableOf(MeasuredRows())), "accepted");
}

TEST(SmoothRhythm, DoesNotGoOnFromATableFarFromItsRule) {
  const Quaternion turn = Exp(Vector3(0, RadiansFromDegrees(100), 0));
  const std::string refusal =
      RefusalOfTheWholeRange(Changed([&](const ShoulderPose& pose) -> ShoulderPose {
        return {pose.q_TC, turn * pose.q_CS, pose.q_SH};
      }));
  EXPECT_EQ(refusal.find("AC at plane 0"), 0U) << refusal;
  EXPECT_NE(refusal.find("Choose the range clamp"), std::string::npos) << refusal;
}

}  // namespace
}  // namespace girdle::smooth_rhythm_test
