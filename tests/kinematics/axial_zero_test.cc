// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Axial turns counted from other zeros than the rhythm's own.

#include "kinematics/axial_zero.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <vector>

#include "kinematics/arm_commands.h"
#include "kinematics/shipped_data.h"
#include "kinematics/shoulder_rhythm.h"

namespace girdle::axial_zero_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
// A few dozen roundings of angles of some hundred degrees.
constexpr double kRounding_deg = 1e-9;
constexpr double kRounding_rad = 1e-12;

const ShoulderRhythm& Whole() {
  static const ShoulderRhythm kRhythm(TableOf(MeasuredRows()));
  return kRhythm;
}
const ShoulderRhythm& Bounded() {
  static const ShoulderRhythm kRhythm(TableOf(MeasuredRows()), {}, ShippedJointRanges());
  return kRhythm;
}

ArmCommand From(AxialFrom zero, ArmCommand command) {
  command.axial_from = zero;
  return command;
}

double Apart_deg(const Quaternion& a, const Quaternion& b) {
  return DegreesFromRadians(AngleBetween(a, b));
}

Quaternion Humerus(const ShoulderRhythm& rhythm, const ArmCommand& command) {
  return rhythm.SolvePose(command).q_TH();
}

// Y(psi) X(-theta) Y(gamma), the ISB's sequence.
Quaternion FromIsb_deg(double elevation_deg, double plane_deg, double axial_deg) {
  return QuaternionFromEuler(EulerSequence::kYXY,
                             {RadiansFromDegrees(plane_deg), RadiansFromDegrees(-elevation_deg),
                              RadiansFromDegrees(axial_deg)});
}

double Remainder_deg(double angle_deg) { return std::remainder(angle_deg, kFullCircle_deg); }

// Directions that an arm reaches, hanging and straight up among them.
std::vector<ArmCommand> Reached() {
  std::vector<ArmCommand> reached;
  for (const double elevation_deg : Steps(0, 180, 36)) {
    for (const double plane_deg : Steps(-95, 135, 46)) {
      const ArmCommand command = Command_deg(elevation_deg, plane_deg);
      if (!Whole().Solve(command).clamped) reached.push_back(command);
    }
  }
  return reached;
}

TEST(AxialFromIsb, IsTheThirdAngleOfTheHumerus) {
  int checked = 0;
  for (const ArmCommand& direction : Reached()) {
    for (const double axial_deg : {-170., -90., 0., 45., 179.}) {
      ArmCommand command = From(AxialFrom::kIsb, direction);
      command.axial_rad = RadiansFromDegrees(axial_deg);
      const ShoulderSolution solution = Whole().Solve(command);
      EXPECT_FALSE(solution.clamped) << command;
      EXPECT_LT(Apart_deg(solution.pose.q_TH(),
                          FromIsb_deg(DegreesFromRadians(command.elevation_rad),
                                      DegreesFromRadians(command.plane_rad), axial_deg)),
                kRounding_deg)
          << command;
      EXPECT_NEAR(Remainder_deg(DegreesFromRadians(Whole().AxialOf(AxialFrom::kIsb, solution.pose,
                                                                   solution.used)) -
                                axial_deg),
                  0, kRounding_deg)
          << command;
      ++checked;
    }
  }
  EXPECT_GT(checked, 5000);
}

// The published angles of the table, of no rhythm: q_TC q_CS q_SH as Y-X'-Y''. The table's arm
// points some degrees beside its nominal direction, exact closure's to it, and both have one whole
// turn, the third angle and the plane together.
TEST(AxialFromIsb, OfExactClosureFollowsFromThePublishedTable) {
  int checked = 0;
  for (const MeasuredRow& row : MeasuredRows()) {
    const ArmAngles published =
        ArmAnglesFromRotation(PoseFromAngles(Radians(row.angles_deg)).q_TH());
    const ShoulderSolution solution = Whole().Solve(Command_deg(row.elevation_deg, row.plane_deg));
    const double axial_deg =
        DegreesFromRadians(Whole().AxialOf(AxialFrom::kIsb, solution.pose, solution.used));
    EXPECT_NEAR(Remainder_deg(axial_deg + row.plane_deg -
                              DegreesFromRadians(published.axial_rad + published.plane_rad)),
                0, 1e-6)
        << row.elevation_deg << ", " << row.plane_deg;
    ++checked;
  }
  EXPECT_EQ(checked, 3 * 22);
}

TEST(AxialFromIsb, WithClosureTableKeepsTheWholeTurn) {
  const ShoulderRhythm rhythm(TableOf(MeasuredRows()),
                              {Interpolation::kSmooth, Closure::kTable, {}});
  for (const double elevation_deg : Steps(15, 120, 7)) {
    for (const double plane_deg : Steps(0, 90, 9)) {
      const ArmCommand command = From(AxialFrom::kIsb, Command_deg(elevation_deg, plane_deg, -30));
      const ShoulderSolution solution = rhythm.Solve(command);
      const ArmAngles reached = ArmAnglesFromRotation(solution.pose.q_TH());
      EXPECT_NEAR(
          Remainder_deg(DegreesFromRadians(reached.axial_rad + reached.plane_rad) + 30 - plane_deg),
          0, kRounding_deg)
          << command;
      EXPECT_NEAR(DegreesFromRadians(rhythm.AxialOf(AxialFrom::kIsb, solution.pose, solution.used)),
                  -30, kRounding_deg);
    }
  }
}

TEST(AxialFrom, ZeroOfTheRhythmIsItsOwnHumerus) {
  for (const ArmCommand& command : Reached()) {
    for (const AxialFrom zero : {AxialFrom::kIsb, AxialFrom::kSwing}) {
      ArmCommand counted = From(zero, command);
      counted.axial_rad = Whole().AxialCountedFrom(zero, command);
      EXPECT_LT(Apart_rad(Whole().SolvePose(counted), Whole().SolvePose(command)), kRounding_rad)
          << command;
      EXPECT_NEAR(Whole().Solve(counted).used.axial_rad, 0, kRounding_rad) << command;
    }
  }
}

TEST(AxialFrom, CountsTheSameTurnFromEveryZero) {
  const ArmCommand isb = From(AxialFrom::kIsb, Command_deg(70, 110, -35));
  ArmCommand swung = From(AxialFrom::kSwing, isb);
  swung.axial_rad = Whole().AxialCountedFrom(AxialFrom::kSwing, isb);
  EXPECT_LT(Apart_rad(Whole().SolvePose(isb), Whole().SolvePose(swung)), kRounding_rad);
  EXPECT_EQ(Whole().AxialCountedFrom(AxialFrom::kIsb, isb), isb.axial_rad);
  EXPECT_EQ(Whole().AxialCountedFrom(AxialFrom::kRhythm, isb), Whole().Solve(isb).used.axial_rad);
  const ShoulderSolution solution = Whole().Solve(isb);
  EXPECT_NEAR(Whole().AxialOf(AxialFrom::kRhythm, solution.pose, solution.used),
              solution.used.axial_rad, kRounding_rad);
  EXPECT_NEAR(Whole().AxialOf(AxialFrom::kSwing, solution.pose, solution.used), swung.axial_rad,
              kRounding_rad);
}

// A plane and an axial turn that mean one humerus are answered by one, where they differ and where
// no arm reaches the plane.
TEST(AxialFromIsb, HangingAndStraightUpMeansOneHumerusWithItsPlane) {
  for (const double plane_deg : Steps(-340, 380, 72)) {
    EXPECT_LT(Apart_deg(Humerus(Whole(),
                                From(AxialFrom::kIsb, Command_deg(0, plane_deg, 25 - plane_deg))),
                        FromIsb_deg(0, 0, 25)),
              kRounding_deg)
        << plane_deg;
    EXPECT_LT(Apart_deg(Humerus(Whole(),
                                From(AxialFrom::kIsb, Command_deg(180, plane_deg, plane_deg - 60))),
                        FromIsb_deg(180, 0, -60)),
              kRounding_deg)
        << plane_deg;
  }
  const ArmCommand beside = From(AxialFrom::kIsb, Command_deg(0, -120, 40));
  EXPECT_FALSE(Whole().Solve(beside).clamped);
}

TEST(AxialFromSwing, IsIsbsInTheMiddleOfTheReach) {
  EXPECT_LT(Apart_deg(Humerus(Whole(), From(AxialFrom::kSwing, Command_deg(90, 20, -40))),
                      FromIsb_deg(90, 20, -40)),
            kRounding_deg);
}

// From the middle of the reach: the rotation between two humeri has its axis across both arms.
TEST(AxialFromSwing, TakesTheHumerusByTheSmallestRotation) {
  const Quaternion start = Humerus(Whole(), From(AxialFrom::kSwing, Command_deg(90, 20, 10)));
  const Vector3 arm = start * Vector3(0, -1, 0);
  for (const ArmCommand& direction : Reached()) {
    ArmCommand command = From(AxialFrom::kSwing, direction);
    command.axial_rad = RadiansFromDegrees(10);
    const Quaternion there = Humerus(Whole(), command);
    const double between_arms_deg = DegreesFromRadians(
        std::acos(std::clamp(glm::dot(arm, there * Vector3(0, -1, 0)), -1.0, 1.0)));
    EXPECT_NEAR(Apart_deg(there, start), between_arms_deg, 1e-5) << command;
  }
}

TEST(AxialFromSwing, HasOneHumerusHangingAndStraightUp) {
  for (const double elevation_deg : {0., 180.}) {
    const Quaternion first =
        Humerus(Whole(), From(AxialFrom::kSwing, Command_deg(elevation_deg, 20, -50)));
    for (const double plane_deg : Steps(-160, 200, 72)) {
      EXPECT_LT(Apart_deg(Humerus(Whole(), From(AxialFrom::kSwing,
                                                Command_deg(elevation_deg, plane_deg, -50))),
                          first),
                kRounding_deg)
          << elevation_deg << ", " << plane_deg;
    }
  }
  // The rhythm's own turns with the plane.
  EXPECT_GT(
      Apart_deg(Humerus(Whole(), Command_deg(180, 0)), Humerus(Whole(), Command_deg(180, 90))), 90);
}

// The largest turn of the humerus over a step of 0.001 deg along planes and elevations, beyond what
// the reach's own answer moves.
double FastestTurn_deg_per_deg(AxialFrom zero, double highest_deg) {
  constexpr double kStep_deg = 1e-3;
  double fastest = 0;
  for (const double elevation_deg : Steps(0, highest_deg, 60)) {
    for (const double plane_deg : Steps(-159.95, 199.95, 240)) {
      const auto at = [&](double up, double across) {
        return Humerus(Whole(), From(zero, Command_deg(elevation_deg + up * kStep_deg,
                                                       plane_deg + across * kStep_deg, -40)));
      };
      const Quaternion here = at(0, 0);
      fastest = std::max(
          {fastest, Apart_deg(at(1, 0), here) / kStep_deg, Apart_deg(at(0, 1), here) / kStep_deg});
    }
  }
  return fastest;
}

TEST(AxialFrom, IsAnsweredWithoutAJumpBeyondTheReach) {
  // Steps of elevation of 1 and of plane of 1.5 deg meet the limits of the reach everywhere.
  EXPECT_LT(FastestTurn_deg_per_deg(AxialFrom::kSwing, 180), 40);
  // Opposite to where (117.5, -160) is answered, there is no smallest rotation.
  EXPECT_LT(FastestTurn_deg_per_deg(AxialFrom::kIsb, 100), 40);
}

TEST(AxialFrom, TakesOfAllWholeTurnsTheOneThatTheJointComesNearestTo) {
  // Overhead and across the chest GH's own axial coordinate is near the lower end of its range, so
  // that turns of more than 180 deg from the rhythm are within it.
  const ArmCommand low = Command_deg(170, 130);
  const double own_rad = AnglesFromPose(Bounded().SolvePose(low))[kGhAxialIndex];
  const double most_rad = ShippedJointRanges()[kGhAxialIndex].upper_rad - own_rad;
  ASSERT_GT(most_rad, kPi);
  ArmCommand command = low;
  command.axial_rad = (most_rad + kPi) / 2;
  for (const double turns : {-1., 0., 1.}) {
    ArmCommand isb = From(AxialFrom::kIsb, command);
    isb.axial_rad = Bounded().AxialCountedFrom(AxialFrom::kIsb, command) + turns * 2 * kPi;
    const ShoulderSolution solution = Bounded().Solve(isb);
    EXPECT_FALSE(solution.clamped) << turns;
    EXPECT_NEAR(solution.used.axial_rad, command.axial_rad, kRounding_rad) << turns;
  }
}

TEST(AxialFromIsb, IsBoundedByTheRangeOfTheJoint) {
  const CoordinateRange range = ShippedJointRanges()[kGhAxialIndex];
  const ShoulderSolution solution = Bounded().Solve(From(AxialFrom::kIsb, Command_deg(60, 40, 90)));
  EXPECT_TRUE(solution.clamped);
  EXPECT_NEAR(AnglesFromPose(solution.pose)[kGhAxialIndex], range.upper_rad, kRounding_rad);
  EXPECT_LT(DegreesFromRadians(Bounded().AxialOf(AxialFrom::kIsb, solution.pose, solution.used)),
            90);
  EXPECT_EQ(solution.used.axial_from, AxialFrom::kRhythm);
}

TEST(AxialFromIsb, IsTheRhythmsOwnWhereItIsNoNumber) {
  for (const double axial_rad : {kNan, std::numeric_limits<double>::infinity()}) {
    ArmCommand command = From(AxialFrom::kIsb, Command_deg(60, 40));
    command.axial_rad = axial_rad;
    const ShoulderSolution solution = Whole().Solve(command);
    EXPECT_TRUE(SameBits(solution.pose, Whole().SolvePose(Command_deg(60, 40))));
    EXPECT_TRUE(solution.clamped);
  }
}

RC_GTEST_PROP(AxialFrom, EqualsItsPoseWhateverTheWay, ()) {
  ArmCommand command =
      Command_deg(*NumberWithin(0, 180), *NumberWithin(-400, 400), *NumberWithin(-360, 360));
  command.axial_from = *rc::gen::element(AxialFrom::kIsb, AxialFrom::kSwing);
  const ShoulderSolution solution = Bounded().Solve(command);
  // The command used, in the rhythm's terms, has the same pose.
  RC_ASSERT(Apart_rad(Bounded().SolvePose(solution.used), solution.pose) < 1e-10);
}

}  // namespace
}  // namespace girdle::axial_zero_test
