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
#include <glm/gtx/quaternion.hpp>
#include <iterator>
#include <limits>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "kinematics/arm_commands.h"
#include "kinematics/shipped_data.h"
#include "kinematics/shoulder_rhythm.h"
#include "kinematics/worst_case.h"

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

// The humerus that a command asks for, and what its answer is beside it, from formulas of these
// tests.
struct Asked {
  double gh_axial_deg;  // GH's axial coordinate of the humerus that is asked for, (-225, 135]
  double own_deg;       // that of the rhythm's own
  double share;         // of the turn from the rhythm's own that counts
};

Vector3 ArmOf(const Quaternion& q_TH) { return q_TH * Vector3(0, -1, 0); }

// By the smallest rotation from where an axial turn is counted to where the arm is.
Asked AskedOf(const ArmCommand& command, const ShoulderSolution& solution) {
  const double axial_deg = DegreesFromRadians(command.axial_rad);
  const Quaternion counted =
      command.axial_from == AxialFrom::kIsb
          ? FromIsb_deg(std::clamp(DegreesFromRadians(command.elevation_rad), 0.0, 180.0),
                        DegreesFromRadians(command.plane_rad), axial_deg)
          : FromIsb_deg(90, 20, axial_deg);
  const ShoulderPose own = Whole().SolvePose(
      {.elevation_rad = solution.used.elevation_rad, .plane_rad = solution.used.plane_rad});
  const Vector3 before = ArmOf(counted);
  const Vector3 after = ArmOf(own.q_TH());
  const double cosine = glm::dot(before, after);
  const Quaternion carry = glm::normalize(Quaternion(1 + cosine, glm::cross(before, after)));
  ShoulderPose asked = own;
  asked.q_SH = glm::conjugate(own.q_TS()) * (carry * counted);
  const double x = std::max((0.5 - cosine) / 1.5, 0.0);
  return {DegreesFromRadians(AnglesFromPose(asked)[kGhAxialIndex]),
          DegreesFromRadians(AnglesFromPose(own)[kGhAxialIndex]),
          command.axial_from == AxialFrom::kIsb ? 1 - x * x * x * (10 - 15 * x + 6 * x * x) : 1};
}

// On plane -160 the answer of this elevation, and of no other, is opposite.
constexpr double kOpposite_deg = 118;

struct WalkCase {
  const char* name;
  AxialFrom zero;
  const ShoulderRhythm& (*rhythm)();
  double fastest;  // deg of a joint or of the humerus per degree of the command
};

void PrintTo(const WalkCase& walk, std::ostream* out) { *out << walk.name; }

// Follows commands step by step. Where GH's axial coordinate that is asked for passes half a turn
// from its middle the humerus's turn passes from one end to the other; nothing else jumps there,
// and nothing at all elsewhere.
class Walk {
 public:
  Walk(AxialFrom zero, const ShoulderRhythm& rhythm) : zero_(zero), rhythm_(rhythm) {}

  void Begin() { before_.reset(); }
  void To(const ArmCommand& command) {
    Step step{From(zero_, command), {}, 0};
    step.solution = rhythm_.Solve(step.command);
    step.gh_axial_deg =
        zero_ == AxialFrom::kRhythm ? 0 : AskedOf(step.command, step.solution).gh_axial_deg;
    if (before_) Add(*before_, step);
    before_ = step;
  }

  [[nodiscard]] double fastest() const { return fastest_; }
  [[nodiscard]] const ArmCommand& at() const { return at_; }
  [[nodiscard]] int passed() const { return passed_; }

 private:
  struct Step {
    ArmCommand command;
    ShoulderSolution solution;
    double gh_axial_deg;
  };

  static double Moved_rad(const ShoulderPose& a, const ShoulderPose& b) {
    return WorseOf(Apart_rad(a, b), AngleBetween(a.q_TH(), b.q_TH()));
  }

  // By how much the girdle and the arm's direction move, whatever its turn about itself does.
  static double MovedBesideTheTurn_rad(const ShoulderPose& a, const ShoulderPose& b) {
    const Quaternion arm = glm::rotation(ArmOf(a.q_TH()), ArmOf(b.q_TH()));
    return WorseOf(WorseOf(AngleBetween(a.q_TC, b.q_TC), AngleBetween(a.q_TS(), b.q_TS())),
                   AngleBetween(arm, Quaternion(1, 0, 0, 0)));
  }

  void Add(const Step& a, const Step& b) {
    const bool passes = std::abs(a.gh_axial_deg - b.gh_axial_deg) > 180;
    passed_ += passes ? 1 : 0;
    const double step_deg =
        DegreesFromRadians(std::max({std::abs(a.command.elevation_rad - b.command.elevation_rad),
                                     std::abs(a.command.plane_rad - b.command.plane_rad),
                                     std::abs(a.command.axial_rad - b.command.axial_rad)}));
    const double turned_deg =
        DegreesFromRadians(passes ? MovedBesideTheTurn_rad(a.solution.pose, b.solution.pose)
                                  : Moved_rad(a.solution.pose, b.solution.pose));
    if (IsWorse(turned_deg / step_deg, fastest_)) {
      fastest_ = turned_deg / step_deg;
      at_ = b.command;
    }
  }

  AxialFrom zero_;
  const ShoulderRhythm& rhythm_;
  std::optional<Step> before_;
  double fastest_ = 0;
  ArmCommand at_;
  int passed_ = 0;
};

class WholeSphere : public testing::TestWithParam<WalkCase> {};

constexpr double kAxialTurns_deg[] = {-150, -40, 0, 100};

TEST_P(WholeSphere, IsAnsweredWithoutAJump) {
  Walk walk(GetParam().zero, GetParam().rhythm());
  int path = 0;
  const auto axial_deg = [&path] { return kAxialTurns_deg[path++ % std::size(kAxialTurns_deg)]; };
  for (const double elevation_deg : Steps(0, 180, 45)) {
    const double turn_deg = axial_deg();
    walk.Begin();
    for (const double plane_deg : Steps(-180, 180, 1440)) {
      walk.To(Command_deg(elevation_deg, plane_deg, turn_deg));
    }
  }
  for (const double plane_deg : Steps(-180, 175, 71)) {
    const double turn_deg = axial_deg();
    walk.Begin();
    for (const double elevation_deg : Steps(0, 180, 720)) {
      walk.To(Command_deg(elevation_deg, plane_deg, turn_deg));
    }
  }
  EXPECT_LT(walk.fastest(), GetParam().fastest) << walk.at();
  EXPECT_EQ(walk.passed() > 0, GetParam().zero != AxialFrom::kRhythm);
}

// Round the direction that is answered by its opposite, to which no smallest rotation leads, and
// through it.
TEST_P(WholeSphere, IsAnsweredWithoutAJumpWhereTheAnswerIsOpposite) {
  Walk walk(GetParam().zero, GetParam().rhythm());
  for (const double turn_deg : kAxialTurns_deg) {
    for (const double radius_deg : {1e-6, 1e-3, 0.1, 1.0, 2.0, 4.0, 7.0, 10.0, 15.0, 20.0}) {
      walk.Begin();
      for (const double round_rad : Steps(0, 2 * kPi, 720)) {
        walk.To(Command_deg(kOpposite_deg + radius_deg * std::cos(round_rad),
                            -160 + radius_deg * std::sin(round_rad), turn_deg));
      }
    }
    for (const double round_rad : Steps(0, kPi, 36)) {
      walk.Begin();
      for (const double from_deg : Steps(-20, 20, 400)) {
        walk.To(Command_deg(kOpposite_deg + from_deg * std::cos(round_rad),
                            -160 + from_deg * std::sin(round_rad), turn_deg));
      }
    }
  }
  EXPECT_LT(walk.fastest(), GetParam().fastest) << walk.at();
}

// The answer's direction moves by up to 11 deg per degree. Straight up the rhythm's own humerus
// turns with the plane; a turn that is carried loses its share on the way to the opposite.
constexpr double kFastestOwn = 30;
constexpr double kFastestCarried = 40;
constexpr double kFastestSwung = 12;

INSTANTIATE_TEST_SUITE_P(
    Zeros, WholeSphere,
    testing::Values(WalkCase{"rhythm", AxialFrom::kRhythm, Whole, kFastestOwn},
                    WalkCase{"rhythm_bounded", AxialFrom::kRhythm, Bounded, kFastestOwn},
                    WalkCase{"isb", AxialFrom::kIsb, Whole, kFastestCarried},
                    WalkCase{"isb_bounded", AxialFrom::kIsb, Bounded, kFastestCarried},
                    WalkCase{"swing", AxialFrom::kSwing, Whole, kFastestSwung},
                    WalkCase{"swing_bounded", AxialFrom::kSwing, Bounded, kFastestSwung}),
    [](const auto& tested) { return std::string(tested.param.name); });

// Any direction, reached or not, with any turn from ISB's zero or the swing's.
ArmCommand AnyCounted() {
  ArmCommand command =
      Command_deg(*NumberWithin(-10, 190), *NumberWithin(-400, 400), *NumberWithin(-360, 360));
  command.axial_from = *rc::gen::element(AxialFrom::kIsb, AxialFrom::kSwing);
  return command;
}

RC_GTEST_PROP(AxialFrom, UsesTheStatedShareOfTheTurnThatIsAskedFor, ()) {
  const ArmCommand command = AnyCounted();
  const ShoulderSolution solution = Whole().Solve(command);
  const Asked asked = AskedOf(command, solution);
  // Not so near to where it passes from one end to the other that rounding decides.
  RC_PRE(asked.gh_axial_deg > -225 + 1e-3 && asked.gh_axial_deg < 135 - 1e-3);
  // Nor so near to an opposite that the smallest rotation is not known.
  RC_PRE(asked.share > 1e-6);
  RC_ASSERT(std::abs(Whole().AxialShare(command) - asked.share) < 1e-12);
  RC_ASSERT(std::abs(DegreesFromRadians(solution.used.axial_rad) -
                     asked.share * (asked.gh_axial_deg - asked.own_deg)) < 1e-6);
}

TEST(AxialFromIsb, IsTheRhythmsOwnWhereTheAnswerIsOpposite) {
  const Quaternion own = Humerus(Whole(), Command_deg(kOpposite_deg, -160));
  const Vector3 asked = ArmOf(FromIsb_deg(kOpposite_deg, -160, 0));
  ASSERT_LT(glm::dot(asked, ArmOf(own)), -0.995);
  for (const double axial_deg : Steps(-180, 180, 36)) {
    EXPECT_LT(Apart_deg(Humerus(Whole(),
                                From(AxialFrom::kIsb, Command_deg(kOpposite_deg, -160, axial_deg))),
                        own),
              0.01)
        << axial_deg;
  }
}

// One place of each circle of turns is passed with a jump, the one half a turn from the middle of
// GH's axial coordinate; the jump is as wide as the joint's range, or as what counts of a turn that
// is carried far.
TEST(AxialFrom, JumpsHalfATurnFromTheMiddleOfTheRangeAlone) {
  constexpr double kStep_deg = 0.25;
  const CoordinateRange range = ShippedJointRanges()[kGhAxialIndex];
  for (const AxialFrom zero : {AxialFrom::kRhythm, AxialFrom::kIsb, AxialFrom::kSwing}) {
    for (const ArmCommand& direction :
         {Command_deg(0, 20), Command_deg(60, 40), Command_deg(60, -90), Command_deg(90, 130),
          Command_deg(120, 0), Command_deg(180, 60), Command_deg(60, 180), Command_deg(75, -160),
          Command_deg(85, -177.5)}) {
      int passed = 0;
      double before_deg = 0;
      for (const double axial_deg : Steps(-540, 540, 4320)) {
        ArmCommand command = From(zero, direction);
        command.axial_rad = RadiansFromDegrees(axial_deg);
        const ShoulderSolution solution = Bounded().Solve(command);
        const double gh_deg = DegreesFromRadians(AnglesFromPose(solution.pose)[kGhAxialIndex]);
        const double moved_deg = gh_deg - before_deg;
        if (axial_deg > -540 && std::abs(moved_deg) > kStep_deg + kRounding_deg) {
          ++passed;
          const Asked asked = AskedOf(command, solution);
          EXPECT_LT(asked.gh_axial_deg, -225 + kStep_deg) << command;
          const auto answer_deg = [&](double asked_deg) {
            return std::clamp(asked.own_deg + asked.share * (asked_deg - asked.own_deg),
                              DegreesFromRadians(range.lower_rad),
                              DegreesFromRadians(range.upper_rad));
          };
          EXPECT_NEAR(moved_deg, answer_deg(-225) - answer_deg(135), kStep_deg) << command;
        }
        before_deg = gh_deg;
      }
      EXPECT_EQ(passed, zero == AxialFrom::kRhythm ? 0 : 3) << From(zero, direction);
    }
  }
}

RC_GTEST_PROP(AxialFrom, CountsTurnsFromOtherZerosBeyondTheReachToo, ()) {
  ArmCommand command = Command_deg(*NumberWithin(-10, 190), *NumberWithin(-400, 400));
  command.axial_rad = *NumberWithin(-0.3, 0.3);
  const ShoulderSolution solution = Whole().Solve(command);
  ArmCommand counted = command;
  counted.axial_from = *rc::gen::element(AxialFrom::kIsb, AxialFrom::kSwing);
  // Of more of the turn that counts there is enough.
  RC_PRE(AskedOf(counted, solution).share > 0.3);
  counted.axial_rad = Whole().AxialCountedFrom(counted.axial_from, command);
  RC_ASSERT(Apart_rad(Whole().SolvePose(counted), solution.pose) < 1e-9);
}

// Near the opposite direction ISB's turns count so little that they give no more than this.
TEST(AxialFrom, CountsTheMostThatThereIsWhereTheTurnIsTooLarge) {
  const ArmCommand far = Command_deg(110, -150);
  ArmCommand most = From(AxialFrom::kIsb, far);
  double most_rad = 0;
  for (const double axial_deg : Steps(-180, 180, 3600)) {
    most.axial_rad = RadiansFromDegrees(axial_deg);
    most_rad = std::max(most_rad, Whole().Solve(most).used.axial_rad);
  }
  ArmCommand asked = far;
  asked.axial_rad = kPi / 2;
  ASSERT_LT(most_rad, asked.axial_rad / 2);
  ArmCommand counted = From(AxialFrom::kIsb, far);
  counted.axial_rad = Whole().AxialCountedFrom(AxialFrom::kIsb, asked);
  const double used_rad = Whole().Solve(counted).used.axial_rad;
  EXPECT_GE(used_rad, most_rad);
  EXPECT_LT(used_rad, most_rad + RadiansFromDegrees(0.1));
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
  const ArmCommand command = AnyCounted();
  const ShoulderSolution solution = Bounded().Solve(command);
  // The command used, in the rhythm's terms, has the same pose.
  RC_ASSERT(Apart_rad(Bounded().SolvePose(solution.used), solution.pose) < 1e-10);
}

}  // namespace
}  // namespace girdle::axial_zero_test
