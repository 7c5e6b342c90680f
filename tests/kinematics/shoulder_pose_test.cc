// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/shoulder_pose.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "kinematics/axis_matrices.h"
#include "kinematics/random_rotations.h"
#include "kinematics/shipped_data.h"

namespace girdle::shoulder_pose_test {
namespace {

// A few dozen roundings of numbers of size one.
constexpr double kRounding = 1e-14;
// Angles to and from quaternions, at second angles well inside their range.
constexpr double kAngleRounding_rad = 1e-13;

std::string Place(const MeasuredRow& row) {
  return "plane " + std::to_string(row.plane_deg) + ", elevation " +
         std::to_string(row.elevation_deg);
}

RowMatrix JointMatrix(std::size_t joint, const JointAngles& angles_rad) {
  const double a = angles_rad[3 * joint];
  const double b = angles_rad[3 * joint + 1];
  const double c = angles_rad[3 * joint + 2];
  const bool is_glenohumeral = joint == 2;
  return is_glenohumeral ? Product(Product(TurnAboutX(a), TurnAboutZ(b)), TurnAboutY(c))
                         : Product(Product(TurnAboutY(a), TurnAboutX(b)), TurnAboutZ(c));
}

rc::Gen<JointAngles> AnyJointAngles() {
  return rc::gen::exec([] {
    JointAngles angles_rad{};
    for (double& angle_rad : angles_rad) angle_rad = *NumberWithin(-kPi, kPi);
    return angles_rad;
  });
}

// Where the elbow lies, seen from GH.
Vector3 ArmDirection(const Quaternion& q_TH) { return q_TH * Vector3(0, -1, 0); }

// The humerus raised by `elevation` in `plane`, then turned about its own axis.
Quaternion RaisedArm(double elevation_rad, double plane_rad, double axial_rad) {
  const auto about = [](const Vector3& axis, double angle_rad) {
    return Quaternion(std::cos(angle_rad / 2), std::sin(angle_rad / 2) * axis.x,
                      std::sin(angle_rad / 2) * axis.y, std::sin(angle_rad / 2) * axis.z);
  };
  const Vector3 x{1, 0, 0};
  const Vector3 y{0, 1, 0};
  return about(y, plane_rad) * about(x, -elevation_rad) * about(y, axial_rad);
}

TEST(ShoulderPose, OfEveryMeasuredRowHasItsAngles) {
  for (const MeasuredRow& row : MeasuredRows()) {
    const JointAngles angles_rad = Radians(row.angles_deg);
    const JointAngles back_rad = AnglesFromPose(PoseFromAngles(angles_rad));
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      EXPECT_NEAR(back_rad[k], angles_rad[k], kAngleRounding_rad)
          << Place(row) << ", " << kCoordinateNames[k];
    }
  }
}

RC_GTEST_PROP(ShoulderPose, TurnsEachJointInItsSequence, ()) {
  const JointAngles angles_rad = *AnyJointAngles();
  const ShoulderPose pose = PoseFromAngles(angles_rad);
  RC_ASSERT(Difference(JointMatrix(0, angles_rad), pose.q_TC) < kRounding);
  RC_ASSERT(Difference(JointMatrix(1, angles_rad), pose.q_CS) < kRounding);
  RC_ASSERT(Difference(JointMatrix(2, angles_rad), pose.q_SH) < kRounding);
}

RC_GTEST_PROP(ShoulderPose, ChainsTheJointsFromTheThoraxOutward, ()) {
  const JointAngles angles_rad = *AnyJointAngles();
  const ShoulderPose pose = PoseFromAngles(angles_rad);
  const RowMatrix R_TS = Product(JointMatrix(0, angles_rad), JointMatrix(1, angles_rad));
  RC_ASSERT(Difference(R_TS, pose.q_TS()) < kRounding);
  RC_ASSERT(Difference(Product(R_TS, JointMatrix(2, angles_rad)), pose.q_TH()) < kRounding);
}

// "GH's axial angle in (-5 pi/4, 3 pi/4]", whatever the signs of the quaternions.
RC_GTEST_PROP(JointAngles, LieInTheirRangesAndGiveThePoseBack, ()) {
  const ShoulderPose pose{*UnitQuaternion(), *UnitQuaternion(), *UnitQuaternion()};
  const JointAngles angles_rad = AnglesFromPose(pose);
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    const double middle_rad = k == kGhAxialIndex ? kGhAxialMiddle_rad : 0;
    const double half_width_rad = k % 3 == 1 ? kPi / 2 : kPi;
    RC_ASSERT(std::abs(angles_rad[k] - middle_rad) <= half_width_rad + kRounding);
  }
  const ShoulderPose back = PoseFromAngles(angles_rad);
  RC_ASSERT(AngleBetween(back.q_TC, pose.q_TC) < kAngleRounding_rad);
  RC_ASSERT(AngleBetween(back.q_CS, pose.q_CS) < kAngleRounding_rad);
  RC_ASSERT(AngleBetween(back.q_SH, pose.q_SH) < kAngleRounding_rad);
}

class AxialAngle : public testing::TestWithParam<double> {};

// Over -180 deg the angle goes on; it leaps at -225 and 135.
TEST_P(AxialAngle, OfGhIsGivenAroundItsMiddle) {
  JointAngles angles_rad{};
  angles_rad[6] = -0.5;
  angles_rad[7] = 0.3;
  angles_rad[kGhAxialIndex] = RadiansFromDegrees(GetParam());
  EXPECT_NEAR(DegreesFromRadians(AnglesFromPose(PoseFromAngles(angles_rad))[kGhAxialIndex]),
              GetParam(), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Angles, AxialAngle,
                         testing::Values(-224.9, -190.0, -180.0, -179.9, -45.0, 0.0, 60.0, 134.9));

RC_GTEST_PROP(FrozenGirdle, KeepsTheOtherGirdleAndTheArmWhereItPoints, ()) {
  const ShoulderPose pose = PoseFromAngles(*AnyJointAngles());
  const ShoulderPose at = PoseFromAngles(*AnyJointAngles());
  const ShoulderPose frozen = FrozenGirdle(pose, at);
  RC_ASSERT(frozen.q_TC == at.q_TC);
  RC_ASSERT(frozen.q_CS == at.q_CS);
  RC_ASSERT(AngleBetween(frozen.q_TH(), pose.q_TH()) < kAngleRounding_rad);
}

RC_GTEST_PROP(ArmAngles, OfARaisedArmAreThoseThatRaisedIt, ()) {
  // The plane of an arm this close to vertical is worth 1e-16 / 0.01.
  constexpr double kMargin_rad = 0.01;
  constexpr double kTolerance_rad = 1e-12;
  const double elevation_rad = *NumberWithin(kMargin_rad, kPi - kMargin_rad);
  const double plane_rad = *NumberWithin(-kPi + kMargin_rad, kPi - kMargin_rad);
  const double axial_rad = *NumberWithin(-kPi + kMargin_rad, kPi - kMargin_rad);
  const ArmAngles arm = ArmAnglesFromRotation(RaisedArm(elevation_rad, plane_rad, axial_rad));
  RC_ASSERT(std::abs(arm.elevation_rad - elevation_rad) < kTolerance_rad);
  RC_ASSERT(std::abs(arm.plane_rad - plane_rad) < kTolerance_rad);
  RC_ASSERT(std::abs(arm.axial_rad - axial_rad) < kTolerance_rad);
}

RC_GTEST_PROP(ArmAngles, HaveTheElevationBetweenTheArmAndHangingDown, ()) {
  const Quaternion q_TH = *UnitQuaternion();
  const double cosine = glm::dot(ArmDirection(q_TH), Vector3(0, -1, 0));
  RC_ASSERT(std::abs(std::cos(ArmAnglesFromRotation(q_TH).elevation_rad) - cosine) < kRounding);
}

struct ArmCase {
  const char* name;
  double elevation_deg;
  double plane_deg;
  Vector3 direction;  // of the elbow in the thorax: x forward, y up, z right
};

void PrintTo(const ArmCase& arm, std::ostream* out) { *out << arm.name; }

class NamedArm : public testing::TestWithParam<ArmCase> {};

TEST_P(NamedArm, PointsWhereItsNameSays) {
  const Quaternion q_TH = RaisedArm(RadiansFromDegrees(GetParam().elevation_deg),
                                    RadiansFromDegrees(GetParam().plane_deg), 0.4);
  EXPECT_LT(glm::length(ArmDirection(q_TH) - GetParam().direction), kRounding);
}

TEST_P(NamedArm, HasItsElevationAndPlane) {
  const ArmAngles arm = ArmAnglesFromRotation(RaisedArm(
      RadiansFromDegrees(GetParam().elevation_deg), RadiansFromDegrees(GetParam().plane_deg), 0.4));
  EXPECT_NEAR(DegreesFromRadians(arm.elevation_rad), GetParam().elevation_deg, 1e-12);
  EXPECT_NEAR(DegreesFromRadians(arm.plane_rad), GetParam().plane_deg, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(
    Planes, NamedArm,
    testing::Values(
        ArmCase{"abducted", 90, 0, {0, 0, 1}}, ArmCase{"flexed", 90, 90, {1, 0, 0}},
        ArmCase{"in the scapular plane",
                90,
                40,
                {std::sin(RadiansFromDegrees(40)), 0, std::cos(RadiansFromDegrees(40))}},
        ArmCase{"extended backward",
                60,
                -90,
                {-std::sin(RadiansFromDegrees(60)), -std::cos(RadiansFromDegrees(60)), 0}},
        ArmCase{"across the chest", 90, 180, {0, 0, -1}},
        ArmCase{"steeply up in front",
                150,
                90,
                {std::sin(RadiansFromDegrees(150)), -std::cos(RadiansFromDegrees(150)), 0}}));

class HangingArm : public testing::TestWithParam<double> {};

TEST_P(HangingArm, HasNoElevation) {
  EXPECT_NEAR(ArmAnglesFromRotation(RaisedArm(0, 0, GetParam())).elevation_rad, 0, kRounding);
}

TEST_P(HangingArm, HasItsTurnAsTheSumOfPlaneAndAxialAngle) {
  const ArmAngles arm = ArmAnglesFromRotation(RaisedArm(0, 0, GetParam()));
  EXPECT_NEAR(std::remainder(arm.plane_rad + arm.axial_rad - GetParam(), 2 * kPi), 0, kRounding);
}

TEST_P(HangingArm, HasAPlaneAboveMinusPi) {
  EXPECT_GT(ArmAnglesFromRotation(RaisedArm(0, 0, GetParam())).plane_rad, -kPi);
}

INSTANTIATE_TEST_SUITE_P(Turns, HangingArm, testing::Values(0.0, 0.5, -1.0, kPi / 2, 3.0));

struct MeasuredArm {
  double elevation_deg;
  double plane_deg;
  double reached_plane_deg;
};

void PrintTo(const MeasuredArm& arm, std::ostream* out) {
  *out << "plane " << arm.plane_deg << ", elevation " << arm.elevation_deg;
}

class ArmOfTheTable : public testing::TestWithParam<MeasuredArm> {};

// What is known about the table: its arm leaves the nominal plane.
TEST_P(ArmOfTheTable, DriftsFromItsPlaneAsIsKnown) {
  constexpr double kPrintedWhole_deg = 0.5;
  for (const MeasuredRow& row : MeasuredRows()) {
    if (row.elevation_deg == GetParam().elevation_deg && row.plane_deg == GetParam().plane_deg) {
      const Quaternion q_TH = PoseFromAngles(Radians(row.angles_deg)).q_TH();
      EXPECT_NEAR(DegreesFromRadians(ArmAnglesFromRotation(q_TH).plane_rad),
                  GetParam().reached_plane_deg, kPrintedWhole_deg);
      return;
    }
  }
  FAIL() << "the table has no such row";
}

INSTANTIATE_TEST_SUITE_P(KnownFigures, ArmOfTheTable,
                         testing::Values(MeasuredArm{30, 0, -7}, MeasuredArm{60, 0, 4},
                                         MeasuredArm{90, 0, 10}, MeasuredArm{120, 0, 19},
                                         MeasuredArm{30, 40, 27}, MeasuredArm{60, 40, 38},
                                         MeasuredArm{90, 40, 41}, MeasuredArm{120, 40, 41},
                                         MeasuredArm{30, 90, 68}, MeasuredArm{60, 90, 74},
                                         MeasuredArm{90, 90, 75}, MeasuredArm{120, 90, 67}));

TEST(ArmOfTheTableEverywhere, HasItsNominalElevationToTwoDegrees) {
  // Known figures: nominal -1.7 to +1.3 deg, over the measured rows.
  constexpr double kLowest_deg = -1.75;
  constexpr double kHighest_deg = 1.35;
  constexpr double kFirstMeasured_deg = 30;
  int rows = 0;
  for (const MeasuredRow& row : MeasuredRows()) {
    if (row.elevation_deg < kFirstMeasured_deg) continue;
    const Quaternion q_TH = PoseFromAngles(Radians(row.angles_deg)).q_TH();
    const double error_deg =
        DegreesFromRadians(ArmAnglesFromRotation(q_TH).elevation_rad) - row.elevation_deg;
    EXPECT_GT(error_deg, kLowest_deg) << Place(row);
    EXPECT_LT(error_deg, kHighest_deg) << Place(row);
    ++rows;
  }
  EXPECT_EQ(rows, 57);
}

// SC and AC against the scapula's own measurement, which never drives.
TEST(ScapulaOfTheTable, DiffersFromThePublishedOneByTwoDegreesAsIsKnown) {
  constexpr double kPrintedTenth_deg = 0.05;
  constexpr double kPrintedHundredth_deg = 0.005;
  double least_deg = 180;
  double most_deg = 0;
  double sum_of_squares = 0;
  const std::vector<MeasuredRow> rows = MeasuredRows();
  for (const MeasuredRow& row : rows) {
    const auto& [internal_deg, upward_deg, tilt_deg] = row.scapulothoracic_deg;
    const Quaternion published = QuaternionFromEuler(
        EulerSequence::kYXZ, kRadiansPerDegree * Vector3(internal_deg, upward_deg, tilt_deg));
    const double difference_deg =
        DegreesFromRadians(AngleBetween(PoseFromAngles(Radians(row.angles_deg)).q_TS(), published));
    least_deg = std::min(least_deg, difference_deg);
    most_deg = std::max(most_deg, difference_deg);
    sum_of_squares += difference_deg * difference_deg;
  }
  EXPECT_NEAR(least_deg, 1.7, kPrintedTenth_deg);
  EXPECT_NEAR(most_deg, 2.5, kPrintedTenth_deg);
  EXPECT_NEAR(std::sqrt(sum_of_squares / static_cast<double>(rows.size())), 2.03,
              kPrintedHundredth_deg);
}

}  // namespace
}  // namespace girdle::shoulder_pose_test
