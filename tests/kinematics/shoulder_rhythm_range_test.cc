// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Where the arm goes, inside and outside the table, with the closure exact.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "kinematics/arm_commands.h"
#include "kinematics/random_rotations.h"
#include "kinematics/shipped_data.h"
#include "kinematics/shoulder_rhythm.h"

namespace girdle::shoulder_rhythm_range_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A few dozen roundings of angles of some hundred degrees.
constexpr double kRounding_deg = 1e-9;

const ShoulderRhythm& Whole() {
  static const ShoulderRhythm kRhythm(TableOf(MeasuredRows()));
  return kRhythm;
}

ShoulderPose PoseAt_deg(double elevation_deg, double plane_deg) {
  return Whole().SolvePose(Command_deg(elevation_deg, plane_deg));
}

double LowestPlane_deg(double elevation_deg) {
  return DegreesFromRadians(Whole().LowestPlaneAt(RadiansFromDegrees(elevation_deg)));
}

bool Reaches(double elevation_deg, double plane_deg) {
  return plane_deg >= LowestPlane_deg(elevation_deg) - kRounding_deg;
}

// Every whole degree that an arm can reach.
void ForEachReachable(const std::function<void(double, double)>& visit) {
  for (int elevation_deg = 0; elevation_deg <= 180; ++elevation_deg) {
    for (int plane_deg = -95; plane_deg <= 135; ++plane_deg) {
      if (Reaches(elevation_deg, plane_deg)) visit(elevation_deg, plane_deg);
    }
  }
}

// A command that an arm can follow.
rc::Gen<ArmCommand> ReachableCommand() {
  return rc::gen::exec([] {
    const double elevation_deg = *NumberWithin(0, 180);
    return Command_deg(elevation_deg, *NumberWithin(LowestPlane_deg(elevation_deg), 135));
  });
}

struct CheckValue {
  double elevation_deg;
  double plane_deg;
  Vector3 sc_deg;
  Vector3 ac_deg;
  Vector3 st_deg;
  double tolerance_deg;
};

void PrintTo(const CheckValue& check, std::ostream* out) {
  *out << "elevation " << check.elevation_deg << ", plane " << check.plane_deg;
}

class CheckedPosition : public testing::TestWithParam<CheckValue> {};

TEST_P(CheckedPosition, IsWhereTheRuleSays) {
  const CheckValue& check = GetParam();
  const ShoulderPose pose = PoseAt_deg(check.elevation_deg, check.plane_deg);
  const auto near = [&](const Quaternion& q, const Vector3& expected_deg, const char* name) {
    const Vector3 angles_deg = kDegreesPerRadian * EulerFromQuaternion(EulerSequence::kYXZ, q);
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(angles_deg[k], expected_deg[k], check.tolerance_deg) << name << " " << k;
    }
  };
  near(pose.q_TC, check.sc_deg, "SC");
  near(pose.q_CS, check.ac_deg, "AC");
  near(pose.q_TS(), check.st_deg, "ST");
}

// Computed from the rule apart from this code, by another spline of the table, and printed to
// tenths. Below the table the rule starts from the edge slope, in which splines differ most.
constexpr double kPrinted_deg = 0.06;
constexpr double kNearAnEdgeSlope_deg = 0.6;

INSTANTIATE_TEST_SUITE_P(
    Values, CheckedPosition,
    testing::Values(
        CheckValue{10,
                   0,
                   {-25.3, -12.0, -0.6},
                   {55.1, -4.3, -4.7},
                   {31.0, -10.6, -15.0},
                   kNearAnEdgeSlope_deg},
        CheckValue{10,
                   90,
                   {-19.8, -9.4, -2.8},
                   {57.7, -8.3, -3.6},
                   {39.3, -10.8, -13.2},
                   kNearAnEdgeSlope_deg},
        CheckValue{
            135, 0, {-45.8, -20.0, 29.4}, {62.4, -18.0, 17.1}, {27.0, -52.3, 8.6}, kPrinted_deg},
        CheckValue{
            150, 40, {-40.8, -17.6, 33.5}, {64.1, -16.1, 14.8}, {31.0, -53.4, 10.8}, kPrinted_deg},
        CheckValue{
            165, 90, {-47.2, -17.4, 37.6}, {65.3, -19.3, 22.6}, {26.4, -60.2, 19.3}, kPrinted_deg},
        CheckValue{
            60, -30, {-38.5, -17.1, 8.6}, {60.6, -11.9, 6.7}, {27.5, -27.3, -5.4}, kPrinted_deg},
        CheckValue{
            90, 105, {-20.8, -13.4, 14.0}, {66.8, -15.5, 7.5}, {51.1, -33.2, -0.7}, kPrinted_deg},
        CheckValue{
            90, 135, {-10.7, -13.4, 14.0}, {70.1, -15.5, 7.6}, {65.0, -32.8, -1.9}, kPrinted_deg},
        CheckValue{120,
                   135,
                   {-19.7, -14.3, 25.1},
                   {70.3, -15.5, 12.3},
                   {57.6, -43.5, 4.8},
                   kPrinted_deg}));

// The turn of the humerus about its long axis: what is left of q_TH = S Ry(tau).
double Turn_deg(const ShoulderPose& pose, double elevation_deg, double plane_deg) {
  const double plane_rad = RadiansFromDegrees(plane_deg);
  const Vector3 axis(-std::cos(plane_rad), 0, std::sin(plane_rad));
  const Quaternion smallest = Exp(RadiansFromDegrees(elevation_deg) * axis);
  return DegreesFromRadians(Log(glm::conjugate(smallest) * pose.q_TH()).y);
}

struct TurnValue {
  double elevation_deg;
  double plane_deg;
  double turn_deg;
};

void PrintTo(const TurnValue& turn, std::ostream* out) {
  *out << "elevation " << turn.elevation_deg << ", plane " << turn.plane_deg;
}

class CheckedTurn : public testing::TestWithParam<TurnValue> {};

TEST_P(CheckedTurn, IsTheTablesOwn) {
  constexpr double kPrintedWhole_deg = 0.5;
  const TurnValue& check = GetParam();
  EXPECT_NEAR(Turn_deg(PoseAt_deg(check.elevation_deg, check.plane_deg), check.elevation_deg,
                       check.plane_deg),
              check.turn_deg, kPrintedWhole_deg);
}

INSTANTIATE_TEST_SUITE_P(
    Values, CheckedTurn,
    testing::Values(TurnValue{15, 0, -23}, TurnValue{30, 0, -36}, TurnValue{60, 0, -43},
                    TurnValue{90, 0, -47}, TurnValue{120, 0, -48}, TurnValue{15, 40, 4},
                    TurnValue{30, 40, -8}, TurnValue{60, 40, -11}, TurnValue{90, 40, -13},
                    TurnValue{120, 40, -20}, TurnValue{15, 90, 26}, TurnValue{30, 90, 25},
                    TurnValue{60, 90, 24}, TurnValue{90, 90, 24}, TurnValue{120, 90, 11}));

// "To tau0 = 2.3, the mean of the planes."
TEST(WholeRange, TurnsAHangingHumerusByTheMeanOfThePlanes) {
  EXPECT_NEAR(Turn_deg(PoseAt_deg(0, 40), 0, 40), 2.3, 0.05);
}

// "q exp(v), v from w x ..., tau: above 120 held, with the edge slope faded out."
TEST(WholeRange, HoldsTheTurnHighUp) {
  for (const double plane_deg : Steps(-30, 135, 33)) {
    EXPECT_NEAR(Turn_deg(PoseAt_deg(136, plane_deg), 136, plane_deg),
                Turn_deg(PoseAt_deg(120, plane_deg), 120, plane_deg), kRounding_deg)
        << plane_deg;
  }
}

// A raised arm turns with its plane, so that the ISB axial angle stays; a hanging one does not.
TEST(WholeRange, TurnsTheHumerusWithThePlaneFarBesideTheTable) {
  // What is left of the table's own slope 35 deg and more beyond it.
  constexpr double kFaded_deg = 0.05;
  const auto turned_deg = [](double elevation_deg, double from_deg, double to_deg) {
    return Turn_deg(PoseAt_deg(elevation_deg, to_deg), elevation_deg, to_deg) -
           Turn_deg(PoseAt_deg(elevation_deg, from_deg), elevation_deg, from_deg);
  };
  for (const double elevation_deg : {20.0, 30.0, 60.0, 90.0, 110.0}) {
    const double share = std::sin(RadiansFromDegrees(std::min(elevation_deg, 90.0)));
    EXPECT_NEAR(turned_deg(elevation_deg, 125, 135), 10 * share, kFaded_deg) << elevation_deg;
    if (elevation_deg > 60) continue;
    EXPECT_NEAR(turned_deg(elevation_deg, -50, -60), -10 * share, kFaded_deg) << elevation_deg;
  }
}

TEST(WholeRange, ReachesExactlyWhatIsCommanded) {
  double elevation_off_deg = 0;
  double plane_off_deg = 0;
  ForEachReachable([&](double elevation_deg, double plane_deg) {
    const ArmAngles arm = ArmAnglesFromRotation(PoseAt_deg(elevation_deg, plane_deg).q_TH());
    const double elevation_off = std::abs(DegreesFromRadians(arm.elevation_rad) - elevation_deg);
    const double plane_off = std::abs(DegreesFromRadians(arm.plane_rad) - plane_deg);
    elevation_off_deg = std::max(elevation_off_deg, elevation_off);
    if (elevation_deg > 0 && elevation_deg < 180) {
      plane_off_deg = std::max(plane_off_deg, plane_off);
    }
  });
  EXPECT_LT(elevation_off_deg, kRounding_deg);
  EXPECT_LT(plane_off_deg, kRounding_deg);
}

TEST(WholeRange, HasOnePoseHangingWhateverThePlane) {
  const ShoulderPose hanging = PoseAt_deg(0, 0);
  for (int plane_deg = -60; plane_deg <= 135; ++plane_deg) {
    EXPECT_LT(DegreesFromRadians(Apart_rad(PoseAt_deg(0, plane_deg), hanging)), kRounding_deg)
        << plane_deg;
  }
}

TEST(WholeRange, HasOneGirdleAndOneDirectionStraightUpWhateverThePlane) {
  const ShoulderPose upright = PoseAt_deg(180, 0);
  for (int plane_deg = -30; plane_deg <= 135; ++plane_deg) {
    const ShoulderPose pose = PoseAt_deg(180, plane_deg);
    EXPECT_LT(DegreesFromRadians(AngleBetween(pose.q_TC, upright.q_TC)), kRounding_deg);
    EXPECT_LT(DegreesFromRadians(AngleBetween(pose.q_CS, upright.q_CS)), kRounding_deg);
    const Vector3 direction = pose.q_TH() * Vector3(0, -1, 0);
    EXPECT_NEAR(direction.y, 1, 1e-14);
    EXPECT_NEAR(direction.x, 0, 1e-14);
    EXPECT_NEAR(direction.z, 0, 1e-14);
  }
}

// Where the rule ends: the postures of hanging and of straight up, as they are stated.
TEST(WholeRange, EndsInTheStatedPostures) {
  const auto angles_deg = [](const Quaternion& q) {
    return kDegreesPerRadian * EulerFromQuaternion(EulerSequence::kYXZ, q);
  };
  const auto near = [](const Vector3& a, const Vector3& b) {
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], kRounding_deg);
  };
  near(angles_deg(PoseAt_deg(0, 30).q_TC), {-21.5, -9.5, -2});
  near(angles_deg(PoseAt_deg(0, 30).q_CS), {55, -5, -6});
  near(angles_deg(PoseAt_deg(180, 30).q_TC), {-54, -21, 37});
  near(angles_deg(PoseAt_deg(180, 30).q_CS), {63, -23, 28});
}

// How far the bones turn in the thorax from one whole degree to the next.
TEST(WholeRange, TurnsNoBoneFast) {
  constexpr double kFastest = 3;
  // Where the planes fold into one, to the first degree of the table.
  constexpr double kFoldedTo_deg = 16;
  constexpr double kFastestFolding = 4.5;
  // The humerus turns with its plane, at elevation 15 by the sine of that, and hanging not at all:
  // what a plane is farther behind goes in 15 deg, midway 1.5 times as fast as in the mean.
  const auto behind = [](double plane_deg) {
    const double farther_deg = std::max(-60 - plane_deg, 0.0);
    return 1.5 * std::sin(RadiansFromDegrees(15)) * farther_deg / 15;
  };
  const auto bones = [](double elevation_deg, double plane_deg) {
    const ShoulderPose pose = PoseAt_deg(elevation_deg, plane_deg);
    return std::array{pose.q_TC, pose.q_TS(), pose.q_TH()};
  };
  ForEachReachable([&](double elevation_deg, double plane_deg) {
    const double fastest =
        (elevation_deg < kFoldedTo_deg ? kFastestFolding : kFastest) + behind(plane_deg);
    const auto here = bones(elevation_deg, plane_deg);
    const auto check = [&](double other_elevation_deg, double other_plane_deg) {
      if (other_elevation_deg > 180 || other_plane_deg > 135 ||
          !Reaches(other_elevation_deg, other_plane_deg)) {
        return;
      }
      const auto there = bones(other_elevation_deg, other_plane_deg);
      for (std::size_t bone = 0; bone < here.size(); ++bone) {
        EXPECT_LT(DegreesFromRadians(AngleBetween(here[bone], there[bone])), fastest)
            << "bone " << bone << ", elevation " << elevation_deg << ", plane " << plane_deg;
      }
    };
    check(elevation_deg + 1, plane_deg);
    check(elevation_deg, plane_deg + 1);
  });
}

const ShoulderRhythm& Bounded() {
  static const ShoulderRhythm kRhythm(TableOf(MeasuredRows()), {}, ShippedJointRanges());
  return kRhythm;
}

TEST(WholeRange, StaysInTheJointsRanges) {
  const JointRanges ranges = ShippedJointRanges();
  ForEachReachable([&](double elevation_deg, double plane_deg) {
    const JointAngles angles_rad = AnglesFromPose(PoseAt_deg(elevation_deg, plane_deg));
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      EXPECT_GE(angles_rad[k], ranges[k].lower_rad)
          << kCoordinateNames[k] << ", elevation " << elevation_deg << ", plane " << plane_deg;
      EXPECT_LE(angles_rad[k], ranges[k].upper_rad)
          << kCoordinateNames[k] << ", elevation " << elevation_deg << ", plane " << plane_deg;
    }
  });
}

RC_GTEST_PROP(WholeRange, GivesUnitQuaternions, ()) {
  for (const Quaternion& joint : Joints(Whole().SolvePose(*ReachableCommand()))) {
    RC_ASSERT(std::abs(glm::length(joint) - 1) < 1e-14);
  }
}

RC_GTEST_PROP(WholeRange, DoesNotClampWhatAnArmCanReach, ()) {
  const ArmCommand command = *ReachableCommand();
  const ShoulderSolution solution = Whole().Solve(command);
  RC_ASSERT(!solution.clamped);
  RC_ASSERT(solution.used == command);
}

RC_GTEST_PROP(WholeRange, SaysWhatIsModelled, ()) {
  const ArmCommand command = *ReachableCommand();
  const ShoulderSolution solution = Whole().Solve(command);
  const bool inside = command.elevation_rad >= RadiansFromDegrees(15) &&
                      command.elevation_rad <= RadiansFromDegrees(120) && command.plane_rad >= 0 &&
                      command.plane_rad <= RadiansFromDegrees(90);
  RC_ASSERT((solution.origin == Origin::kModelled) == !inside);
  RC_ASSERT((solution.distance_rad > 0) == !inside);
  RC_ASSERT(solution.distance_rad ==
            Whole().DistanceOutside(command.elevation_rad, command.plane_rad));
}

struct ClampedCase {
  const char* name;
  ArmCommand command;
  ArmCommand used;
};

void PrintTo(const ClampedCase& clamped, std::ostream* out) { *out << clamped.name; }

class BeyondReach : public testing::TestWithParam<ClampedCase> {};

TEST_P(BeyondReach, TheStatedDirectionIsUsed) {
  const ArmCommand used = Whole().Solve(GetParam().command).used;
  EXPECT_NEAR(used.elevation_rad, GetParam().used.elevation_rad, 1e-14);
  EXPECT_NEAR(used.plane_rad, GetParam().used.plane_rad, 1e-14);
}

TEST_P(BeyondReach, TurnsAndOffsetsThatAreNoNumbersAreNotUsed) {
  const ArmCommand used = Whole().Solve(GetParam().command).used;
  EXPECT_EQ(used.axial_rad, GetParam().used.axial_rad);
  EXPECT_EQ(used.shrug_rad, GetParam().used.shrug_rad);
  EXPECT_EQ(used.protraction_rad, GetParam().used.protraction_rad);
}

TEST_P(BeyondReach, TheResultSaysSo) { EXPECT_TRUE(Whole().Solve(GetParam().command).clamped); }

TEST_P(BeyondReach, ThePoseIsThatOfTheCommandUsed) {
  EXPECT_LT(Apart_rad(Whole().Solve(GetParam().command).pose, Whole().Solve(GetParam().used).pose),
            1e-13);
}

// Beside a plane, the nearest direction of it: a right triangle of the direction, its foot and
// hanging, whose tangents are in the ratio of the cosine of how far beyond the plane it is.
ArmCommand OnPlane_deg(double elevation_deg, double beyond_deg, double plane_deg) {
  const double theta_rad = RadiansFromDegrees(elevation_deg);
  return {std::atan2(std::sin(theta_rad) * std::cos(RadiansFromDegrees(beyond_deg)),
                     std::cos(theta_rad)),
          RadiansFromDegrees(plane_deg)};
}

// The circle of 45 deg about an elevation of 107.5 touches plane -30: a right triangle again, of
// the centre, the point of touch and straight up. Directly below the centre it lets 62.5 through.
ArmCommand BelowTheCentre_deg(double elevation_deg) {
  const double beyond_rad =
      std::asin(std::sin(RadiansFromDegrees(45)) / std::sin(RadiansFromDegrees(107.5)));
  return {RadiansFromDegrees(elevation_deg), RadiansFromDegrees(-30) - beyond_rad};
}

INSTANTIATE_TEST_SUITE_P(
    Commands, BeyondReach,
    testing::Values(
        ClampedCase{"below hanging", Command_deg(-5, 40), Command_deg(0, 40)},
        ClampedCase{"beyond straight up", Command_deg(185, 40), Command_deg(180, 40)},
        ClampedCase{"below hanging, a turn on", Command_deg(-5, 400), Command_deg(0, 40)},
        ClampedCase{"across the chest", Command_deg(60, 140), OnPlane_deg(60, 5, 135)},
        ClampedCase{"across the chest, a turn back", Command_deg(60, -220),
                    OnPlane_deg(60, 5, 135)},
        ClampedCase{"behind, low", Command_deg(30, -105), OnPlane_deg(30, 10, -95)},
        ClampedCase{"behind, a turn on", Command_deg(30, 255), OnPlane_deg(30, 10, -95)},
        ClampedCase{"behind, towards the circle", BelowTheCentre_deg(80), BelowTheCentre_deg(62.5)},
        ClampedCase{"behind, high", Command_deg(150, -50), OnPlane_deg(150, 20, -30)},
        ClampedCase{"beyond straight up, behind", Command_deg(185, -45), Command_deg(180, -30)},
        // 65 deg and more from all that is reached: in the middle of the planes.
        ClampedCase{"level, opposite to the middle", Command_deg(90, 200),
                    Command_deg(90 * std::cos(RadiansFromDegrees(65)), 20)},
        ClampedCase{"an elevation that is no number", {kNan, 0.5}, {0, 0.5}},
        ClampedCase{"an axial turn that is no number", {1, 0.5, kNan}, {1, 0.5, 0}},
        ClampedCase{"an infinite shrug", {1, 0.5, 0, kInfinity}, {1, 0.5, 0}},
        ClampedCase{"a protraction that is no number", {1, 0.5, 0, 0, kNan}, {1, 0.5, 0}},
        ClampedCase{"an infinite elevation", {kInfinity, 0.5}, {kPi, 0.5}}));

// "A NaN counts as the lowest elevation or plane."
TEST(WholeRange, TakesANanForTheLowestPlane) {
  for (const double plane_rad : {kNan, kInfinity, -kInfinity}) {
    const ShoulderSolution solution = Whole().Solve({1, plane_rad});
    EXPECT_NEAR(DegreesFromRadians(solution.used.plane_rad), -95, kRounding_deg) << plane_rad;
    EXPECT_TRUE(solution.clamped) << plane_rad;
    EXPECT_EQ(Apart_rad(solution.pose, Whole().SolvePose({1, solution.used.plane_rad})), 0);
  }
}

TEST(WholeRange, HasItsOutermostElevationsAndPlanes) {
  const ArmRectangle& domain = Whole().domain();
  EXPECT_EQ(domain.lowest_elevation_rad, 0);
  EXPECT_EQ(domain.highest_elevation_rad, kPi);
  EXPECT_NEAR(DegreesFromRadians(domain.first_plane_rad), -95, kRounding_deg);
  EXPECT_NEAR(DegreesFromRadians(domain.last_plane_rad), 135, kRounding_deg);
}

// A plane is an angle: whole turns do not matter, with any range and interpolation.
RC_GTEST_PROP(WholeRange, TakesPlanesAWholeTurnApartForOne, ()) {
  static const ShoulderRhythm kSquad(TableOf(MeasuredRows()),
                                     {Interpolation::kSquad, Closure::kTable, std::nullopt});
  static const ShoulderRhythm kClamped(TableOf(MeasuredRows()),
                                       {Interpolation::kSmooth, Closure::kExact, Range::kClamp});
  const ArmCommand command = Command_deg(*NumberWithin(-10, 190), *NumberWithin(-180, 180));
  for (const ShoulderRhythm* rhythm : {&Whole(), &kClamped, &kSquad}) {
    // The table's edges answer as far as half a turn from their middle, and jump there.
    const double cut_deg = rhythm == &Whole() ? -160 : -135;
    RC_PRE(std::abs(DegreesFromRadians(command.plane_rad) - cut_deg) > kRounding_deg);
    const ShoulderSolution solution = rhythm->Solve(command);
    for (const int turns : {-2, -1, 1, 3}) {
      ArmCommand turned = command;
      turned.plane_rad += 2 * kPi * turns;
      const ShoulderSolution other = rhythm->Solve(turned);
      RC_ASSERT(Apart_rad(other.pose, solution.pose) < 1e-12);
      RC_ASSERT(std::abs(other.used.plane_rad - solution.used.plane_rad) < 1e-12);
      RC_ASSERT(std::abs(other.used.elevation_rad - solution.used.elevation_rad) < 1e-12);
      RC_ASSERT(other.origin == solution.origin);
    }
  }
}

RC_GTEST_PROP(WholeRange, DoesNotCallAPlaneAWholeTurnOnClamped, ()) {
  const double elevation_deg = *NumberWithin(0, 180);
  // Not so near to a limit that the turn's rounding takes it over it.
  const double plane_deg =
      *NumberWithin(LowestPlane_deg(elevation_deg) + kRounding_deg, 135 - kRounding_deg);
  for (const double turns_deg : {-720, -360, 360, 1080}) {
    const ArmCommand command = Command_deg(elevation_deg, plane_deg + turns_deg);
    const ShoulderSolution solution = Whole().Solve(command);
    RC_ASSERT(!solution.clamped);
    RC_ASSERT(!Whole().IsClamped(command, solution.used));
    RC_ASSERT(std::abs(DegreesFromRadians(solution.used.plane_rad) - plane_deg) < kRounding_deg);
  }
}

TEST(WholeRange, TakesTheWayRoundForTheSamePlane) {
  for (const double elevation_deg : {30.0, 90.0, 150.0}) {
    EXPECT_LT(Apart_rad(PoseAt_deg(elevation_deg, 181), PoseAt_deg(elevation_deg, -179)), 1e-12);
    EXPECT_LT(Apart_rad(PoseAt_deg(elevation_deg, 350), PoseAt_deg(elevation_deg, -10)), 1e-12);
    EXPECT_LT(Apart_rad(PoseAt_deg(elevation_deg, 225), PoseAt_deg(elevation_deg, -135)), 1e-12);
  }
}

// Hanging, every plane is one and the same direction.
TEST(WholeRange, ClampsNoPlaneOfAHangingArm) {
  const ShoulderPose hanging = PoseAt_deg(0, 40);
  for (const double plane_deg : Steps(-360, 360, 144)) {
    const ShoulderSolution solution = Whole().Solve(Command_deg(0, plane_deg));
    EXPECT_FALSE(solution.clamped) << plane_deg;
    EXPECT_LT(Apart_rad(solution.pose, hanging), 1e-12) << plane_deg;
  }
  EXPECT_TRUE(Whole().Solve({0, kNan}).clamped);
  EXPECT_TRUE(Whole().Solve(Command_deg(1, -150)).clamped);
}

// What answers a direction is answered by itself.
RC_GTEST_PROP(WholeRange, AnswersWithWhatIsReached, ()) {
  const Vector3 v = *UnitVector();
  const ArmCommand command{std::acos(std::clamp(-v.y, -1.0, 1.0)), std::atan2(v.x, v.z)};
  const ShoulderSolution solution = Whole().Solve(command);
  const double plane_deg = DegreesFromRadians(solution.used.plane_rad);
  const double elevation_deg = DegreesFromRadians(solution.used.elevation_rad);
  RC_ASSERT(plane_deg >= LowestPlane_deg(elevation_deg) - kRounding_deg);
  RC_ASSERT(plane_deg <= 135 + kRounding_deg);
  RC_ASSERT(elevation_deg >= 0 && elevation_deg <= 180);
  RC_ASSERT(Apart_rad(Whole().SolvePose(solution.used), solution.pose) < 1e-9);
  const ArmAngles arm = ArmAnglesFromRotation(solution.pose.q_TH());
  RC_ASSERT(std::abs(arm.elevation_rad - solution.used.elevation_rad) < 1e-9);
}

// Neither over straight up nor over hanging, nor round behind the body, does the arm jump.
TEST(WholeRange, TurnsTheHumerusWithoutAJumpAllTheWayRound) {
  // The answer moves by up to 11 deg a degree. Straight up the humerus alone turns, from one limit
  // to the other: by 165 deg between planes 225 and 240, and 15 / 8 of that rate midway.
  constexpr double kFastest = 3 * 11;
  constexpr double kStep_deg = 0.01;
  for (const double elevation_deg :
       {0.0, 1e-9, 0.5, 20.0, 60.0, 90.0, 110.0, 130.0, 160.0, 179.0, 179.99, 180 - 1e-9, 180.0}) {
    double fastest_deg = 0;
    double at_deg = 0;
    ShoulderPose before = PoseAt_deg(elevation_deg, -180);
    for (int i = 1; i <= 36000; ++i) {
      const ShoulderPose pose = PoseAt_deg(elevation_deg, -180 + kStep_deg * i);
      const double turned_deg = DegreesFromRadians(
          std::max({AngleBetween(before.q_TC, pose.q_TC), AngleBetween(before.q_CS, pose.q_CS),
                    AngleBetween(before.q_TH(), pose.q_TH())}));
      if (!(turned_deg <= fastest_deg)) {
        fastest_deg = turned_deg;
        at_deg = -180 + kStep_deg * i;
      }
      before = pose;
    }
    EXPECT_LT(fastest_deg, kFastest * kStep_deg)
        << "elevation " << elevation_deg << ", plane " << at_deg;
  }
}

// Along every plane the arm comes to straight up and to hanging without a jump.
TEST(WholeRange, ComesToItsEndsWithoutAJumpAlongEveryPlane) {
  for (const double plane_deg : Steps(-180, 180, 360)) {
    for (const double end_deg : {0.0, 180.0}) {
      const double near_deg = end_deg == 0 ? 1e-6 : 180 - 1e-6;
      const ShoulderPose end = PoseAt_deg(end_deg, plane_deg);
      const ShoulderPose near = PoseAt_deg(near_deg, plane_deg);
      EXPECT_LT(DegreesFromRadians(AngleBetween(end.q_TH(), near.q_TH())), 1e-4) << plane_deg;
      EXPECT_LT(DegreesFromRadians(Apart_rad(end, near)), 1e-4) << plane_deg;
    }
  }
}

// A table with the planes of another one, moved and stretched.
std::vector<MeasuredRow> RowsOfPlanes(double first_deg, double last_deg) {
  std::vector<MeasuredRow> rows = MeasuredRows();
  for (MeasuredRow& row : rows) {
    row.plane_deg = first_deg + row.plane_deg * (last_deg - first_deg) / 90;
  }
  return rows;
}

TEST(WholeRange, IsRefusedForATableOfPlanesThatNoArmReaches) {
  const auto whole = [](double first_deg, double last_deg) {
    return ShoulderRhythm(TableOf(RowsOfPlanes(first_deg, last_deg)),
                          {Interpolation::kSmooth, Closure::kExact, Range::kWhole});
  };
  for (const auto& [first_deg, last_deg, wrong_deg] :
       {std::array{-96.0, 90.0, -96.0}, std::array{0.0, 136.0, 136.0}}) {
    try {
      const ShoulderRhythm rhythm = whole(first_deg, last_deg);
      ADD_FAILURE() << first_deg << " to " << last_deg << " accepted";
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(std::string(error.what()),
                "the table's plane " + std::to_string(wrong_deg) +
                    " deg is beyond what an arm reaches, -95 to 135 deg. Choose the range clamp");
    }
    // The range clamp takes it.
    const ShoulderRhythm clamped(TableOf(RowsOfPlanes(first_deg, last_deg)),
                                 {Interpolation::kSmooth, Closure::kExact, Range::kClamp});
    EXPECT_FALSE(clamped.Solve(Command_deg(60, wrong_deg)).clamped);
  }
  EXPECT_FALSE(whole(0, 135).Solve(Command_deg(60, 135)).clamped);
}

// A table's own planes are reached at every elevation.
TEST(WholeRange, ReachesThePlanesOfATableBehindTheBody) {
  const ShoulderRhythm rhythm(TableOf(RowsOfPlanes(-45, 90)),
                              {Interpolation::kSmooth, Closure::kExact, Range::kWhole});
  for (const double elevation_deg : Steps(0, 180, 36)) {
    EXPECT_FALSE(rhythm.Solve(Command_deg(elevation_deg, -44.999)).clamped) << elevation_deg;
  }
}

TEST(ClampedRange, HasTheTablesElevationsAndPlanes) {
  const ShoulderRhythm rhythm(TableOf(MeasuredRows()),
                              {Interpolation::kSmooth, Closure::kExact, Range::kClamp});
  const ArmRectangle& domain = rhythm.domain();
  EXPECT_NEAR(DegreesFromRadians(domain.lowest_elevation_rad), 15, kRounding_deg);
  EXPECT_NEAR(DegreesFromRadians(domain.highest_elevation_rad), 120, kRounding_deg);
  EXPECT_NEAR(DegreesFromRadians(domain.first_plane_rad), 0, kRounding_deg);
  EXPECT_NEAR(DegreesFromRadians(domain.last_plane_rad), 90, kRounding_deg);
  const ShoulderSolution solution = rhythm.Solve(Command_deg(150, -20));
  EXPECT_TRUE(solution.clamped);
  EXPECT_EQ(Apart_rad(solution.pose, rhythm.Solve(Command_deg(120, 0)).pose), 0);
}

TEST(WholeRange, IsRefusedWhereThereIsNoRule) {
  for (const Interpolation interpolation :
       {Interpolation::kSmooth, Interpolation::kSquad, Interpolation::kSlerp}) {
    for (const Closure closure : {Closure::kExact, Closure::kTable}) {
      if (interpolation == Interpolation::kSmooth && closure == Closure::kExact) continue;
      try {
        const ShoulderRhythm rhythm(TableOf(MeasuredRows()),
                                    {interpolation, closure, Range::kWhole});
        ADD_FAILURE() << Name(interpolation) << " " << Name(closure) << " accepted";
      } catch (const std::invalid_argument& error) {
        EXPECT_EQ(std::string(error.what()),
                  "the range whole needs the interpolation smooth and the closure exact: with "
                  "others nothing is known outside the table. Choose the range clamp");
      }
    }
  }
}

TEST(SmoothInterpolation, NeedsThreePlanes) {
  std::vector<MeasuredRow> rows = MeasuredRows();
  rows.resize(44);
  try {
    const ShoulderRhythm rhythm(TableOf(rows));
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("2 planes, the smooth interpolation needs at least 3"),
              std::string::npos)
        << error.what();
  }
}

// SC and AC are the table's; the humerus is not.
TEST(ExactClosure, PassesThroughEveryMeasuredGirdle) {
  constexpr double kRounding_rad = 1e-12;
  for (const Interpolation interpolation :
       {Interpolation::kSmooth, Interpolation::kSquad, Interpolation::kSlerp}) {
    const ShoulderRhythm rhythm(TableOf(MeasuredRows()),
                                {interpolation, Closure::kExact, std::nullopt});
    for (const MeasuredRow& row : MeasuredRows()) {
      const ArmCommand command = Command_deg(row.elevation_deg, row.plane_deg);
      const ShoulderPose measured = PoseFromAngles(Radians(row.angles_deg));
      const ShoulderPose pose = rhythm.SolvePose(command);
      EXPECT_LT(AngleBetween(pose.q_TC, measured.q_TC), kRounding_rad) << command;
      EXPECT_LT(AngleBetween(pose.q_CS, measured.q_CS), kRounding_rad) << command;
    }
  }
}

TEST(TableClosure, PassesThroughEveryMeasuredPosition) {
  constexpr double kRounding_rad = 1e-12;
  const ShoulderRhythm rhythm(TableOf(MeasuredRows()),
                              {Interpolation::kSmooth, Closure::kTable, std::nullopt});
  for (const MeasuredRow& row : MeasuredRows()) {
    const ArmCommand command = Command_deg(row.elevation_deg, row.plane_deg);
    EXPECT_LT(Apart_rad(rhythm.SolvePose(command), PoseFromAngles(Radians(row.angles_deg))),
              kRounding_rad)
        << command;
  }
}

// With squad and slerp, too, the girdle is that of the table and the humerus points exactly.
RC_GTEST_PROP(ExactClosure, PointsExactlyWithEveryInterpolation, ()) {
  const Interpolation interpolation =
      *rc::gen::element(Interpolation::kSmooth, Interpolation::kSquad, Interpolation::kSlerp);
  static const RhythmTable kTable = TableOf(MeasuredRows());
  const ShoulderRhythm exact(kTable, {interpolation, Closure::kExact, std::nullopt});
  const ShoulderRhythm table(kTable, {interpolation, Closure::kTable, std::nullopt});
  const ArmCommand command = *InnerCommand();
  const ShoulderPose pose = exact.SolvePose(command);
  const ShoulderPose of_table = table.SolvePose(command);
  const ArmAngles arm = ArmAnglesFromRotation(pose.q_TH());
  RC_ASSERT(std::abs(arm.elevation_rad - command.elevation_rad) < 1e-12);
  RC_ASSERT(std::abs(arm.plane_rad - command.plane_rad) < 1e-12);
  RC_ASSERT(AngleBetween(pose.q_TC, of_table.q_TC) < 1e-14);
  RC_ASSERT(AngleBetween(pose.q_CS, of_table.q_CS) < 1e-14);
}

RC_GTEST_PROP(WholeRange, GivesTheSamePoseWithAndWithoutTheRest, ()) {
  ArmCommand command = *ReachableCommand();
  if (*rc::gen::arbitrary<bool>()) {
    command.axial_rad = *NumberWithin(-1, 1);
    command.shrug_rad = *NumberWithin(-0.3, 0.3);
    command.protraction_rad = *NumberWithin(-0.3, 0.3);
  }
  for (const ShoulderRhythm* rhythm : {&Whole(), &Bounded()}) {
    RC_ASSERT(SameBits(rhythm->Solve(command).pose, rhythm->SolvePose(command)));
  }
}

// What is known of where solutions come from.
TEST(Origin, IsDerivedBesideADerivedPosition) {
  const RhythmTable shipped = TableOf(MeasuredRows());
  std::vector<RhythmPosition> positions;
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t i = 0; i < 22; ++i) {
      positions.push_back(shipped.position(j, i));
      positions.back().measured = i >= 3;
    }
  }
  const ShoulderRhythm rhythm(
      RhythmTable(shipped.planes_rad(), shipped.elevations_rad(), positions));
  const auto origin = [&](double elevation_deg, double plane_deg) {
    return rhythm.Solve(Command_deg(elevation_deg, plane_deg)).origin;
  };
  EXPECT_EQ(origin(20, 10), Origin::kDerived);
  EXPECT_EQ(origin(29.9, 40), Origin::kDerived);
  EXPECT_EQ(origin(30, 40), Origin::kMeasured);
  EXPECT_EQ(origin(30.1, 50), Origin::kMeasured);
  EXPECT_EQ(origin(15, 0), Origin::kDerived);
  EXPECT_EQ(origin(14.9, 0), Origin::kModelled);
  EXPECT_EQ(origin(120.1, 0), Origin::kModelled);
}

double Coordinate_deg(const ShoulderPose& pose, std::size_t k) {
  return DegreesFromRadians(AnglesFromPose(pose).at(k));
}

RC_GTEST_PROP(Offsets, TurnTheClaviclesAnglesAndKeepTheScapulaOnIt, ()) {
  ArmCommand command = *ReachableCommand();
  const ShoulderPose plain = Whole().SolvePose(command);
  command.shrug_rad = *NumberWithin(-0.5, 0.5);
  command.protraction_rad = *NumberWithin(-0.5, 0.5);
  const ShoulderSolution solution = Whole().Solve(command);
  const JointAngles before_rad = AnglesFromPose(plain);
  const JointAngles after_rad = AnglesFromPose(solution.pose);
  RC_ASSERT(!solution.clamped);
  RC_ASSERT(std::abs(after_rad[0] - before_rad[0] - command.protraction_rad) < 1e-13);
  RC_ASSERT(std::abs(after_rad[1] - before_rad[1] + command.shrug_rad) < 1e-13);
  RC_ASSERT(std::abs(after_rad[2] - before_rad[2]) < 1e-13);
  RC_ASSERT(AngleBetween(solution.pose.q_CS, plain.q_CS) < 1e-14);
  // The arm keeps its direction and its turn.
  RC_ASSERT(AngleBetween(solution.pose.q_TH(), plain.q_TH()) < 1e-13);
}

TEST(Offsets, RaiseTheClaviclesOuterEndByAShrugAndBringItForwardByAProtraction) {
  const Vector3 outward(0, 0, 1);
  const Vector3 plain = PoseAt_deg(30, 40).q_TC * outward;
  const Vector3 shrugged = Whole().SolvePose(Command_deg(30, 40, 0, 10)).q_TC * outward;
  const Vector3 protracted = Whole().SolvePose(Command_deg(30, 40, 0, 0, 10)).q_TC * outward;
  EXPECT_GT(shrugged.y, plain.y + 0.1);
  EXPECT_GT(protracted.x, plain.x + 0.1);
}

RC_GTEST_PROP(AxialTurn, AddsToTheGhAxialAngleAlone, ()) {
  ArmCommand command = *ReachableCommand();
  const JointAngles before_rad = AnglesFromPose(Whole().SolvePose(command));
  command.axial_rad = *NumberWithin(-1, 1);
  const JointAngles after_rad = AnglesFromPose(Whole().SolvePose(command));
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    const double added_rad = k == kGhAxialIndex ? command.axial_rad : 0;
    RC_ASSERT(std::abs(std::remainder(after_rad[k] - before_rad[k] - added_rad, 2 * kPi)) < 1e-12);
  }
}

struct BoundedCoordinate {
  std::size_t k;
  double ArmCommand::*asked;
  double sign;  ///< of the coordinate by the command
};

void PrintTo(const BoundedCoordinate& bounded, std::ostream* out) {
  *out << kCoordinateNames.at(bounded.k);
}

class BoundedBy : public testing::TestWithParam<BoundedCoordinate> {};

// What is used ends at the range; the rest of the command is used whole.
TEST_P(BoundedBy, TheJointsRangeSaysHowMuchIsUsed) {
  const auto& [k, asked, sign] = GetParam();
  const CoordinateRange range = ShippedJointRanges().at(k);
  JointRanges ranges = ShoulderRhythm::Unbounded();
  ranges.at(k) = range;
  const ShoulderRhythm bounded(TableOf(MeasuredRows()), {}, ranges);
  for (const auto& [elevation_deg, plane_deg] :
       {std::array{5.0, 20.0}, std::array{60.0, 40.0}, std::array{90.0, -20.0},
        std::array{100.0, 120.0}, std::array{150.0, 40.0}}) {
    const ArmCommand plain = Command_deg(elevation_deg, plane_deg);
    const double plain_rad = AnglesFromPose(bounded.SolvePose(plain)).at(k);
    for (const double added_deg :
         {-1000.0, -300.0, -170.0, -100.0, -20.0, -5.0, 5.0, 20.0, 100.0, 170.0, 300.0}) {
      ArmCommand command = plain;
      command.*asked = sign * RadiansFromDegrees(added_deg);
      const ShoulderSolution solution = bounded.Solve(command);
      const double wanted_rad = plain_rad + RadiansFromDegrees(added_deg);
      const double reached_rad = std::clamp(wanted_rad, range.lower_rad, range.upper_rad);
      EXPECT_NEAR(Coordinate_deg(solution.pose, k), DegreesFromRadians(reached_rad), kRounding_deg)
          << command;
      EXPECT_NEAR(sign * (solution.used.*asked), reached_rad - plain_rad, 1e-12) << command;
      EXPECT_EQ(solution.clamped, reached_rad != wanted_rad) << command;
      ArmCommand rest = solution.used;
      rest.*asked = command.*asked;
      EXPECT_EQ(rest, command);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Coordinates, BoundedBy,
    testing::Values(BoundedCoordinate{0, &ArmCommand::protraction_rad, 1},
                    BoundedCoordinate{1, &ArmCommand::shrug_rad, -1},
                    BoundedCoordinate{kGhAxialIndex, &ArmCommand::axial_rad, 1}),
    [](const auto& tested) { return std::string(kCoordinateNames.at(tested.param.k)); });

// A NaN is no way around what an arm can reach.
TEST(ShoulderRhythm, TakesANanForTheLowestPlaneThatAnArmReaches) {
  for (const double elevation_deg : {30.0, 70.0, 90.0, 170.0}) {
    ArmCommand command = Command_deg(elevation_deg, 0);
    command.plane_rad = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(Bounded().Solve(command).used.plane_rad,
              Whole().LowestPlaneAt(command.elevation_rad));
  }
}

// GH that is outside its range already is not pushed further by offsets.
TEST(ShoulderRhythm, OffsetsDoNotTakeGhFartherOutOfItsRange) {
  const ArmCommand plain = Command_deg(60, 40);
  const double own_rad = AnglesFromPose(Whole().SolvePose(plain)).at(6);
  JointRanges ranges = ShoulderRhythm::Unbounded();
  ranges.at(6) = {own_rad + 0.1, own_rad + 0.5};
  const ShoulderRhythm rhythm(TableOf(MeasuredRows()), {}, ranges);
  for (const double shrug_deg : {-10.0, 10.0}) {
    ArmCommand command = plain;
    command.shrug_rad = RadiansFromDegrees(shrug_deg);
    const double free_rad = AnglesFromPose(Whole().SolvePose(command)).at(6);
    const double bounded_rad = AnglesFromPose(rhythm.SolvePose(command)).at(6);
    EXPECT_NEAR(bounded_rad, std::max(free_rad, own_rad), 1e-9) << shrug_deg;
  }
}

// GH makes up for the girdle, so that its ranges bound the offsets too; the arm stays where it was
// told to be.
TEST(ShoulderRhythm, OffsetsTakeNoJointOutOfItsRange) {
  int stopped = 0;
  for (const double elevation_deg : Steps(0, 180, 12)) {
    for (const double plane_deg : Steps(-30, 135, 11)) {
      for (const double shrug_deg : {-15.0, 0.0, 20.0, 35.0}) {
        for (const double protraction_deg : {-25.0, 0.0, 30.0}) {
          ArmCommand command = Command_deg(elevation_deg, plane_deg);
          command.shrug_rad = RadiansFromDegrees(shrug_deg);
          command.protraction_rad = RadiansFromDegrees(protraction_deg);
          const ShoulderSolution solution = Bounded().Solve(command);
          const JointAngles angles_rad = AnglesFromPose(solution.pose);
          for (std::size_t k = 0; k < kCoordinateCount; ++k) {
            EXPECT_GE(angles_rad.at(k), ShippedJointRanges().at(k).lower_rad - 1e-9) << command;
            EXPECT_LE(angles_rad.at(k), ShippedJointRanges().at(k).upper_rad + 1e-9) << command;
          }
          EXPECT_NEAR(ArmAnglesFromRotation(solution.pose.q_TH()).elevation_rad,
                      solution.used.elevation_rad, 1e-9);
          stopped += solution.used.protraction_rad != command.protraction_rad ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GT(stopped, 0);
}

// A rhythm outside its range may be brought back and is not pushed: 10 deg beyond a range 20 deg
// wide, above it and below it.
TEST_P(BoundedBy, ARhythmOutsideItsRangeIsOnlyBroughtBack) {
  const BoundedCoordinate& bounded = GetParam();
  const ArmCommand plain = Command_deg(60, 40);
  const double plain_rad = AnglesFromPose(Whole().SolvePose(plain)).at(bounded.k);
  const double near_rad = RadiansFromDegrees(10);
  const double far_rad = RadiansFromDegrees(30);
  for (const double side : {1.0, -1.0}) {
    JointRanges ranges = ShoulderRhythm::Unbounded();
    ranges.at(bounded.k) = {plain_rad - (side > 0 ? far_rad : -near_rad),
                            plain_rad - (side > 0 ? near_rad : -far_rad)};
    const ShoulderRhythm rhythm(TableOf(MeasuredRows()), {}, ranges);
    // What is added to the coordinate, outward +.
    const auto added_deg = [&](double asked_deg) {
      ArmCommand command = plain;
      command.*bounded.asked = bounded.sign * side * RadiansFromDegrees(asked_deg);
      const ShoulderSolution solution = rhythm.Solve(command);
      const double added_rad = AnglesFromPose(solution.pose).at(bounded.k) - plain_rad;
      EXPECT_NEAR(added_rad, bounded.sign * (solution.used.*bounded.asked), 1e-12);
      return side * DegreesFromRadians(added_rad);
    };
    EXPECT_EQ(Apart_rad(rhythm.SolvePose(plain), Whole().SolvePose(plain)), 0);
    EXPECT_NEAR(added_deg(5), 0, kRounding_deg);
    EXPECT_NEAR(added_deg(-5), -5, kRounding_deg);
    EXPECT_NEAR(added_deg(-20), -20, kRounding_deg);
    EXPECT_NEAR(added_deg(-40), -30, kRounding_deg);
  }
}

}  // namespace
}  // namespace girdle::shoulder_rhythm_range_test
