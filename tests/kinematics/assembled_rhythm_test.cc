// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/assembled_rhythm.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/arm_commands.h"
#include "kinematics/random_rotations.h"
#include "kinematics/shipped_data.h"

namespace girdle::assembled_rhythm_test {
namespace {

// A few dozen roundings of angles of some radians, through quaternions.
constexpr double kRounding_rad = 1e-12;

// The shipped rows with the published scapula beside the joints.
RhythmTable TableWithScapula() {
  const std::vector<MeasuredRow> rows = MeasuredRows();
  const RhythmTable plain = TableOf(rows);
  std::vector<RhythmPosition> positions;
  for (const MeasuredRow& row : rows) {
    RhythmPosition position;
    position.angles_rad = Radians(row.angles_deg);
    position.scapulothoracic_rad =
        kRadiansPerDegree *
        Vector3(row.scapulothoracic_deg[0], row.scapulothoracic_deg[1], row.scapulothoracic_deg[2]);
    positions.push_back(position);
  }
  return {plain.planes_rad(), plain.elevations_rad(), positions};
}

constexpr std::array<RhythmOptions, 5> kAllOptions = {{
    {Interpolation::kSmooth, Closure::kExact},
    {Interpolation::kSmooth, Closure::kTable},
    {Interpolation::kSmooth, Closure::kExact, Range::kClamp},
    {Interpolation::kSquad, Closure::kTable},
    {Interpolation::kSlerp, Closure::kExact},
}};

AssembledRhythm Assembled(Assembly assembly, const RhythmOptions& options = {}) {
  return {ShoulderRhythm(TableWithScapula(), options, ShippedJointRanges()), assembly};
}

const AssembledRhythm& Loop() {
  static const AssembledRhythm kLoop = Assembled(Assembly::kLoop);
  return kLoop;
}

// Inside the ranges, outside them, and with all that can be added.
rc::Gen<ArmCommand> AnyCommand() {
  return rc::gen::exec([] {
    return Command_deg(*NumberWithin(-20, 200), *NumberWithin(-90, 160), *NumberWithin(-60, 60),
                       *NumberWithin(-20, 40), *NumberWithin(-30, 40));
  });
}

// How far the scapula of a loop is turned from where SC and AC take it, in its own axes [rad].
Vector3 Correction(const AssembledRhythm& loop, const ArmCommand& command) {
  return Log(glm::conjugate(loop.rhythm().SolvePose(command).q_TS()) *
             loop.SolvePose(command).q_TS());
}

TEST(LoopRhythm, HasThePublishedScapulaAndClavicleAtEveryMeasuredPosition) {
  const std::vector<MeasuredRow> rows = MeasuredRows();
  ASSERT_EQ(rows.size(), 66U);
  for (const RhythmOptions& options : kAllOptions) {
    const AssembledRhythm loop = Assembled(Assembly::kLoop, options);
    for (const MeasuredRow& row : rows) {
      const ShoulderPose pose = loop.SolvePose(Command_deg(row.elevation_deg, row.plane_deg));
      const JointAngles angles_rad = Radians(row.angles_deg);
      const Vector3 st_rad =
          kRadiansPerDegree * Vector3(row.scapulothoracic_deg[0], row.scapulothoracic_deg[1],
                                      row.scapulothoracic_deg[2]);
      EXPECT_LT(AngleBetween(pose.q_TS(), QuaternionFromEuler(EulerSequence::kYXZ, st_rad)),
                kRounding_rad)
          << "elevation " << row.elevation_deg << ", plane " << row.plane_deg;
      EXPECT_LT(AngleBetween(pose.q_TC, PoseFromAngles(angles_rad).q_TC), kRounding_rad)
          << "elevation " << row.elevation_deg << ", plane " << row.plane_deg;
    }
  }
}

// What a loop is for: the tree's scapula is two degrees from the published one.
TEST(TreeRhythm, HasAnotherScapulaThanThePublishedOne) {
  const AssembledRhythm tree = Assembled(Assembly::kTree);
  double largest_rad = 0;
  for (const MeasuredRow& row : MeasuredRows()) {
    const ArmCommand command = Command_deg(row.elevation_deg, row.plane_deg);
    largest_rad = std::max(largest_rad, AngleBetween(tree.SolvePose(command).q_TS(),
                                                     Loop().SolvePose(command).q_TS()));
  }
  EXPECT_GT(largest_rad, RadiansFromDegrees(2));
  EXPECT_LT(largest_rad, RadiansFromDegrees(3));
}

RC_GTEST_PROP(TreeRhythm, IsThePlainOneToTheLastBit, ()) {
  const RhythmOptions options =
      kAllOptions.at(*rc::gen::inRange<std::size_t>(0, kAllOptions.size()));
  const AssembledRhythm tree = Assembled(Assembly::kTree, options);
  const ArmCommand command = *AnyCommand();
  ArmCommand used;
  ArmCommand plain_used;
  RC_ASSERT(
      SameBits(tree.SolvePose(command, &used), tree.rhythm().SolvePose(command, &plain_used)));
  RC_ASSERT(used == plain_used);
  RC_ASSERT(tree.SolveAngles(command) == AnglesFromPose(tree.rhythm().SolvePose(command)));
}

// GH's last hinge, which has another angle in a loop, may reach its end before the plain one's
// does.
RC_GTEST_PROP(LoopRhythm, AnswersTheCommandThatThePlainOneDoesButForABoundedAxialTurn, ()) {
  const ArmCommand command = *AnyCommand();
  ArmCommand used;
  ArmCommand plain_used;
  const ShoulderPose pose = Loop().SolvePose(command, &used);
  static_cast<void>(Loop().rhythm().SolvePose(command, &plain_used));
  RC_ASSERT(SameBits(pose, Loop().SolvePose(command)));
  const double axial_rad = used.axial_rad;
  used.axial_rad = plain_used.axial_rad;
  RC_ASSERT(used == plain_used);
  if (axial_rad != plain_used.axial_rad) {
    RC_ASSERT(std::abs(axial_rad) < std::abs(plain_used.axial_rad));
    RC_ASSERT(axial_rad * plain_used.axial_rad >= 0);
    const JointAngles angles_rad = AnglesFromPose(pose);
    const CoordinateRange& range = Loop().rhythm().ranges()[kGhAxialIndex];
    const double end_rad = plain_used.axial_rad > 0 ? range.upper_rad : range.lower_rad;
    // Rounding turns the last hinge the more the closer the second is to 90 degrees.
    RC_ASSERT(std::abs((angles_rad[kGhAxialIndex] - end_rad) *
                       std::cos(angles_rad[kGhAxialIndex - 1])) < kRounding_rad);
  }
}

// As the plain one does: what is past the end of its range by itself stays there.
RC_GTEST_PROP(LoopRhythm, TurnsTheHumerusNeitherFurtherNorTheOtherWayThanItIsTold, ()) {
  JointRanges ranges = ShippedJointRanges();
  ranges[kGhAxialIndex] = {RadiansFromDegrees(-70), RadiansFromDegrees(-40)};
  static const AssembledRhythm kLoop(ShoulderRhythm(TableWithScapula(), {}, ranges),
                                     Assembly::kLoop);
  const ArmCommand command = *AnyCommand();
  ArmCommand used;
  static_cast<void>(kLoop.SolvePose(command, &used));
  RC_ASSERT(std::abs(used.axial_rad) <= std::abs(command.axial_rad));
  RC_ASSERT(used.axial_rad * command.axial_rad >= 0);
}

RC_GTEST_PROP(LoopRhythm, OfAClampedRangeIsWhereItsNearestPointIs, ()) {
  static const AssembledRhythm kLoop =
      Assembled(Assembly::kLoop, {Interpolation::kSmooth, Closure::kExact, Range::kClamp});
  const ArmCommand command = *AnyCommand();
  ArmCommand used;
  const ShoulderPose pose = kLoop.SolvePose(command, &used);
  // The offsets of the command used are within their bounds already, but for rounding.
  RC_ASSERT(Apart_rad(pose, kLoop.SolvePose(used)) < kRounding_rad);
}

RC_GTEST_PROP(LoopRhythm, OfClosureExactPointsTheHumerusWhereItIsTold, ()) {
  const ArmCommand command = *AnyCommand();
  ArmCommand used;
  const ShoulderPose pose = Loop().SolvePose(command, &used);
  const Vector3 arm = pose.q_TH() * Vector3{0, -1, 0};
  const Vector3 wanted{std::sin(used.elevation_rad) * std::sin(used.plane_rad),
                       -std::cos(used.elevation_rad),
                       std::sin(used.elevation_rad) * std::cos(used.plane_rad)};
  RC_ASSERT(glm::distance(arm, wanted) < kRounding_rad);
  // And turned about its long axis as without the loop, but for what GH's last hinge has no room
  // for.
  ArmCommand plain_used;
  const Quaternion plain_q_TH = Loop().rhythm().SolvePose(command, &plain_used).q_TH();
  const Quaternion turn = Exp({0, plain_used.axial_rad - used.axial_rad, 0});
  RC_ASSERT(AngleBetween(pose.q_TH() * turn, plain_q_TH) < kRounding_rad);
}

RC_GTEST_PROP(LoopRhythm, LeavesTheClavicleWhereThePlainOneHasIt, ()) {
  const ArmCommand command = *AnyCommand();
  RC_ASSERT(Difference(Loop().SolvePose(command).q_TC, Loop().rhythm().SolvePose(command).q_TC) ==
            0);
}

RC_GTEST_PROP(LoopRhythm, OfClosureTableLeavesGhAsMeasured, ()) {
  static const AssembledRhythm kLoop =
      Assembled(Assembly::kLoop, {Interpolation::kSquad, Closure::kTable});
  const ArmCommand command = *AnyCommand();
  RC_ASSERT(Difference(kLoop.SolvePose(command).q_SH, kLoop.rhythm().SolvePose(command).q_SH) == 0);
}

// Places where the correction is nothing: hanging, thirty degrees past the table and beyond.
TEST(LoopRhythm, IsThePlainOneWhereItsCorrectionHasFaded) {
  for (const auto& [elevation_deg, plane_deg] :
       {std::pair(0.0, 40.0), std::pair(0.0, -20.0), std::pair(150.0, 40.0), std::pair(180.0, 40.0),
        std::pair(60.0, -30.0), std::pair(60.0, -60.0), std::pair(60.0, 120.0),
        std::pair(60.0, 135.0)}) {
    const ArmCommand command = Command_deg(elevation_deg, plane_deg, 5, 3, -2);
    EXPECT_LT(Apart_rad(Loop().SolvePose(command), Loop().rhythm().SolvePose(command)),
              kRounding_rad)
        << command;
  }
}

TEST(LoopRhythm, HasItsWholeCorrectionUpToTheTablesEdges) {
  for (const auto& [inner, outer] : {std::pair(Command_deg(60, 0), Command_deg(60, -0.1)),
                                     std::pair(Command_deg(60, 90), Command_deg(60, 90.1)),
                                     std::pair(Command_deg(120, 40), Command_deg(120.1, 40)),
                                     std::pair(Command_deg(15, 40), Command_deg(14.9, 40))}) {
    const double inside_rad = glm::length(Correction(Loop(), inner));
    EXPECT_GT(inside_rad, RadiansFromDegrees(0.5)) << inner;
    // Fades with the cube of how far it is past the edge, beside what the spline changes by.
    EXPECT_NEAR(glm::length(Correction(Loop(), outer)), inside_rad, RadiansFromDegrees(0.05))
        << outer;
  }
}

TEST(LoopRhythm, HalvesItsCorrectionInTheMiddleOfAFade) {
  // Across the fade the spline goes on with its slope at the edge; a table with the same correction
  // everywhere has none. So this one turns every scapula by the same.
  const Vector3 turn{0.01, -0.02, 0.03};
  std::vector<RhythmPosition> positions;
  const RhythmTable table = TableWithScapula();
  for (std::size_t plane = 0; plane < table.planes_rad().size(); ++plane) {
    for (std::size_t elevation = 0; elevation < table.elevations_rad().size(); ++elevation) {
      RhythmPosition position = table.position(plane, elevation);
      position.scapulothoracic_rad = EulerFromQuaternion(
          EulerSequence::kYXZ, PoseFromAngles(position.angles_rad).q_TS() * Exp(turn));
      positions.push_back(position);
    }
  }
  const AssembledRhythm loop(
      ShoulderRhythm({table.planes_rad(), table.elevations_rad(), positions}), Assembly::kLoop);
  for (const auto& [command, share] :
       {std::pair(Command_deg(60, 40), 1.0), std::pair(Command_deg(7.5, 40), 0.5),
        std::pair(Command_deg(135, 40), 0.5), std::pair(Command_deg(60, -15), 0.5),
        std::pair(Command_deg(60, 105), 0.5), std::pair(Command_deg(135, 105), 0.25)}) {
    EXPECT_LT(glm::distance(Correction(loop, command), share * turn), kRounding_rad) << command;
  }
}

// A curve's first or second derivative from one side, exact for cubics: differences over steps of
// `h` to the side of its sign.
struct OneSided {
  Vector3 first;
  Vector3 second;
};

OneSided Derivatives(const std::function<Vector3(double)>& curve, double h) {
  const std::array<Vector3, 4> f = {curve(0), curve(h), curve(2 * h), curve(3 * h)};
  return {(-11.0 * f[0] + 18.0 * f[1] - 9.0 * f[2] + 2.0 * f[3]) / (6 * h),
          (2.0 * f[0] - 5.0 * f[1] + 4.0 * f[2] - f[3]) / (h * h)};
}

void ExpectSmoothAcross(const std::function<Vector3(double)>& curve, const std::string& where) {
  // Steps so small that fourth derivatives, some thousands in the fade below the table, leave less
  // than the tolerance, and rounding does too: 1e-15 / h^2.
  constexpr double kStep_rad = 1e-4;
  constexpr double kFirst = 1e-7;
  constexpr double kSecond = 1e-3;
  const OneSided after = Derivatives(curve, kStep_rad);
  const OneSided before = Derivatives(curve, -kStep_rad);
  EXPECT_LT(glm::distance(after.first, before.first), kFirst) << where;
  EXPECT_LT(glm::distance(after.second, before.second), kSecond) << where;
}

// With the plain rhythm's own smoothness, which its tests look at, the scapula's follows.
TEST(LoopRhythm, CorrectsTwiceContinuouslyDifferentiablyOverKnotsBordersAndFades) {
  const std::array<double, 10> borders_of_elevation_deg = {0.1, 15,  20,  60,  115,
                                                           120, 135, 150, 165, 179};
  const std::array<double, 7> borders_of_plane_deg = {-30, -15, 0, 40, 90, 105, 120};
  double largest = 0;
  for (const double elevation_deg : borders_of_elevation_deg) {
    for (const double plane_deg : {-25.0, -10.0, 0.0, 17.0, 40.0, 77.0, 90.0, 111.0}) {
      const ArmCommand at = Command_deg(elevation_deg, plane_deg);
      const auto along = [&at](double step_rad) {
        return Correction(Loop(), {at.elevation_rad + step_rad, at.plane_rad});
      };
      ExpectSmoothAcross(along, "along elevation at " + std::to_string(elevation_deg) + ", plane " +
                                    std::to_string(plane_deg));
      largest = std::max(largest, glm::length(Derivatives(along, 1e-4).second));
    }
  }
  // Steps behind the body keep to where every arm reaches.
  for (const double plane_deg : borders_of_plane_deg) {
    for (const double elevation_deg : {3.0, 15.0, 33.0, 60.0, 77.0, 120.0, 141.0}) {
      if (plane_deg <
          DegreesFromRadians(Loop().rhythm().LowestPlaneAt(RadiansFromDegrees(elevation_deg))) +
              1) {
        continue;
      }
      const ArmCommand at = Command_deg(elevation_deg, plane_deg);
      ExpectSmoothAcross(
          [&at](double step_rad) {
            return Correction(Loop(), {at.elevation_rad, at.plane_rad + step_rad});
          },
          "along plane at " + std::to_string(plane_deg) + ", elevation " +
              std::to_string(elevation_deg));
    }
  }
  // A fade that is only once differentiable would jump by as much.
  EXPECT_GT(largest, 1) << "nothing bends here";
}

TEST(LoopRhythm, IsSingleValuedWhereThePlaneHasNoMeaning) {
  const ShoulderPose hanging = Loop().SolvePose(Command_deg(0, 0));
  const ShoulderPose upright = Loop().SolvePose(Command_deg(180, 0));
  for (const double plane_deg : Steps(-95, 135, 46)) {
    EXPECT_LT(Apart_rad(Loop().SolvePose(Command_deg(0, plane_deg)), hanging), kRounding_rad)
        << "plane " << plane_deg;
    // Straight up the humerus has one direction, and its turn about it is the plane's.
    const ShoulderPose pose = Loop().SolvePose(Command_deg(180, plane_deg));
    EXPECT_LT(AngleBetween(pose.q_TC, upright.q_TC), kRounding_rad) << "plane " << plane_deg;
    EXPECT_LT(AngleBetween(pose.q_TS(), upright.q_TS()), kRounding_rad) << "plane " << plane_deg;
    const Vector3 arm = pose.q_TH() * Vector3{0, -1, 0};
    EXPECT_LT(glm::distance(arm, Vector3{0, 1, 0}), kRounding_rad) << "plane " << plane_deg;
  }
}

// Near hanging, however near, neighbouring planes are neighbouring poses.
TEST(LoopRhythm, BecomesSingleValuedSmoothlyTowardsHanging) {
  for (const double elevation_deg : {1.0, 0.1, 0.01}) {
    const Vector3 front = Correction(Loop(), Command_deg(elevation_deg, 90));
    const Vector3 side = Correction(Loop(), Command_deg(elevation_deg, 0));
    // The fade begins with the cube of the elevation: 10 (e / 15)^3 of at most 3 degrees.
    const double cube = 10 * std::pow(elevation_deg / 15, 3) * RadiansFromDegrees(3);
    EXPECT_LT(glm::distance(front, side), 2 * cube + kRounding_rad) << elevation_deg;
  }
}

TEST(LoopRhythm, OfATableWithoutThePublishedScapulaIsThePlainOne) {
  const AssembledRhythm loop(ShoulderRhythm(TableOf(MeasuredRows())), Assembly::kLoop);
  for (const double elevation_deg : Steps(0, 180, 12)) {
    for (const double plane_deg : {-20.0, 0.0, 55.0, 130.0}) {
      const ArmCommand command = Command_deg(elevation_deg, plane_deg, 5, 4, 3);
      EXPECT_TRUE(SameBits(loop.SolvePose(command), loop.rhythm().SolvePose(command))) << command;
    }
  }
}

// The first `planes` planes and `elevations` elevations of the shipped table.
RhythmTable Part(std::size_t planes, std::size_t elevations) {
  const RhythmTable table = TableWithScapula();
  std::vector<RhythmPosition> positions;
  for (std::size_t plane = 0; plane < planes; ++plane) {
    for (std::size_t elevation = 0; elevation < elevations; ++elevation) {
      positions.push_back(table.position(plane, elevation));
    }
  }
  return {{table.planes_rad().begin(), table.planes_rad().begin() + static_cast<long>(planes)},
          {table.elevations_rad().begin(),
           table.elevations_rad().begin() + static_cast<long>(elevations)},
          positions};
}

TEST(LoopRhythm, RefusesATableOfTwoPlanesOrTwoElevations) {
  constexpr RhythmOptions kSlerp = {Interpolation::kSlerp, Closure::kTable};
  for (const auto& [planes, elevations] : {std::pair<std::size_t, std::size_t>(2, 22), {3, 2}}) {
    const ShoulderRhythm rhythm(Part(planes, elevations), kSlerp);
    std::string message;
    try {
      AssembledRhythm(rhythm, Assembly::kLoop);
    } catch (const std::invalid_argument& error) {
      message = error.what();
    }
    EXPECT_EQ(message,
              "the assembly loop needs a table of at least 3 planes and 3 elevations, this one "
              "has " +
                  std::to_string(planes) + " and " + std::to_string(elevations));
    EXPECT_NO_THROW(AssembledRhythm(rhythm, Assembly::kTree));
  }
  EXPECT_NO_THROW(AssembledRhythm(ShoulderRhythm(Part(3, 3), kSlerp), Assembly::kLoop));
}

TEST(Assembly, DrivesTheCoordinatesThatItsNameSays) {
  EXPECT_EQ(DrivenCoordinates(Assembly::kTree), kCoordinateNames);
  const std::array<std::string_view, kCoordinateCount> loop = {
      "sc_protraction",       "sc_elevation",       "sc_rotation",
      "st_internal_rotation", "st_upward_rotation", "st_tilt",
      "gh_elevation",         "gh_flexion",         "gh_axial"};
  EXPECT_EQ(DrivenCoordinates(Assembly::kLoop), loop);
  EXPECT_EQ(DrivenJoints(Assembly::kTree), kJointNames);
  EXPECT_EQ(DrivenJoints(Assembly::kLoop)[1], "ST");
}

RC_GTEST_PROP(DrivenAngles, AreThoseOfTheScapulaOnTheThoraxInALoop, ()) {
  const ArmCommand command = *AnyCommand();
  const ShoulderPose pose = Loop().SolvePose(command);
  const JointAngles angles_rad = DrivenAngles(Assembly::kLoop, pose);
  const JointAngles tree_rad = DrivenAngles(Assembly::kTree, pose);
  RC_ASSERT(tree_rad == AnglesFromPose(pose));
  RC_ASSERT(angles_rad == Loop().SolveAngles(command));
  const Quaternion q_TS =
      QuaternionFromEuler(EulerSequence::kYXZ, {angles_rad[3], angles_rad[4], angles_rad[5]});
  RC_ASSERT(AngleBetween(q_TS, pose.q_TC * pose.q_CS) < kRounding_rad);
  for (const std::size_t k : {0U, 1U, 2U, 6U, 7U, 8U}) {
    RC_ASSERT(angles_rad[k] == tree_rad[k]);
  }
}

}  // namespace
}  // namespace girdle::assembled_rhythm_test
