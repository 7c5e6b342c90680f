// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "motions/arm_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <vector>

#include "kinematics/rotation.h"

namespace girdle::arm_path_test {
namespace {

constexpr double kRounding_rad = 1e-12;

ArmCommand Command_deg(double elevation_deg, double plane_deg, double axial_deg = 0) {
  return {RadiansFromDegrees(elevation_deg), RadiansFromDegrees(plane_deg),
          RadiansFromDegrees(axial_deg)};
}

// Rows a second apart.
ArmPath PathThrough(const std::vector<ArmCommand>& commands) {
  std::vector<TimedCommand> rows;
  rows.reserve(commands.size());
  for (const ArmCommand& command : commands) {
    rows.push_back({static_cast<double>(rows.size()), command});
  }
  return ArmPath(rows);
}

double Elevation_deg(const ArmCommand& command) {
  return DegreesFromRadians(command.elevation_rad);
}
double Plane_deg(const ArmCommand& command) { return DegreesFromRadians(command.plane_rad); }

Vector3 DirectionOf(const ArmCommand& command) {
  const double sine = std::sin(command.elevation_rad);
  return {sine * std::sin(command.plane_rad), -std::cos(command.elevation_rad),
          sine * std::cos(command.plane_rad)};
}

double AngleBetween(const ArmCommand& a, const ArmCommand& b) {
  const Vector3 u = DirectionOf(a);
  const Vector3 v = DirectionOf(b);
  return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

TEST(ArmPath, MeetsItsRowsToTheLastBitAndHoldsTheEnds) {
  const std::vector<ArmCommand> rows = {Command_deg(20, 10, 5), Command_deg(80, -100, -170),
                                        Command_deg(33.3, 179, 12)};
  const ArmPath path = PathThrough(rows);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(path.At(static_cast<double>(i)), rows[i]) << i;
  }
  EXPECT_EQ(path.At(-1), rows.front());
  EXPECT_EQ(path.At(7), rows.back());
}

TEST(BridgeCommands, TakesEvenStepsOfThePath) {
  const ArmCommand before = Command_deg(20, 10, 5);
  const ArmCommand after = Command_deg(80, -100, -170);
  std::vector<ArmCommand> between(3);
  BridgeCommands(before, after, between);
  const ArmPath path = PathThrough({before, after});
  for (std::size_t i = 0; i < between.size(); ++i) {
    EXPECT_EQ(between[i], path.At(static_cast<double>(i + 1) / 4)) << i;
  }
}

TEST(ArmPath, OfOneRowStays) {
  EXPECT_EQ(PathThrough({Command_deg(20, 10)}).At(3), Command_deg(20, 10));
}

TEST(ArmPath, GoesAlongGreatCirclesWithConstantSpeed) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> elevation(0, kPi);
  std::uniform_real_distribution<double> plane(-kPi, kPi);
  for (int sample = 0; sample < 1000; ++sample) {
    const ArmCommand a = {elevation(random), plane(random)};
    const ArmCommand b = {elevation(random), plane(random)};
    const ArmPath path = PathThrough({a, b});
    const double whole_rad = AngleBetween(a, b);
    for (const double share : {0.1, 0.5, 0.75}) {
      const ArmCommand at = path.At(share);
      EXPECT_NEAR(AngleBetween(a, at), share * whole_rad, 1e-9) << sample;
      EXPECT_NEAR(AngleBetween(at, b), (1 - share) * whole_rad, 1e-9) << sample;
      EXPECT_LE(std::abs(at.plane_rad), kPi) << sample;
    }
  }
}

TEST(ArmPath, GoesOnFromPlaneToPlaneWhateverTheyAreCalled) {
  // As a file writes 1 and 359.6, which is -0.4.
  const ArmPath path = PathThrough({Command_deg(90, 1), Command_deg(90, -0.4)});
  EXPECT_NEAR(Plane_deg(path.At(0.5)), 0.3, kRounding_rad);
  EXPECT_NEAR(Elevation_deg(path.At(0.5)), 90, kRounding_rad);
}

TEST(ArmPath, GoesOnFrom180AsMinus180) {
  const ArmPath path = PathThrough({Command_deg(90, 170), Command_deg(90, -170)});
  EXPECT_NEAR(Plane_deg(path.At(0.25)), 175, 1e-9);
  EXPECT_NEAR(Plane_deg(path.At(0.75)), -175, 1e-9);
}

TEST(ArmPath, KeepsThePlaneOfARaiseExactly) {
  const ArmPath path = PathThrough({Command_deg(10, 40), Command_deg(170, 40)});
  EXPECT_EQ(path.At(0.3).plane_rad, RadiansFromDegrees(40));
  EXPECT_NEAR(Elevation_deg(path.At(0.25)), 50, kRounding_rad);
}

TEST(ArmPath, SwingsPastHanging) {
  const ArmPath path = PathThrough({Command_deg(20, -90), Command_deg(10, 90)});
  EXPECT_NEAR(Elevation_deg(path.At(1.0 / 3)), 10, 1e-9);
  EXPECT_NEAR(Plane_deg(path.At(1.0 / 3)), -90, 1e-6);
  EXPECT_NEAR(Elevation_deg(path.At(5.0 / 6)), 5, 1e-9);
  EXPECT_NEAR(Plane_deg(path.At(5.0 / 6)), 90, 1e-6);
}

TEST(ArmPath, HasThePlaneOfTheNearerEndRightAtHanging) {
  const ArmPath path = PathThrough({Command_deg(30, 40), Command_deg(30, -140)});
  EXPECT_NEAR(Elevation_deg(path.At(0.5)), 0, 1e-9);
  EXPECT_NEAR(Plane_deg(path.At(0.5)), -140, 1e-9);
}

TEST(ArmPath, LeavesHangingInThePlaneOfTheWay) {
  const ArmPath path = PathThrough({Command_deg(30, 10), Command_deg(0, 0), Command_deg(30, 90)});
  EXPECT_NEAR(Plane_deg(path.At(0.999)), 10, 1e-9);
  EXPECT_NEAR(Plane_deg(path.At(1)), 90, 1e-9);
  EXPECT_NEAR(Plane_deg(path.At(1.001)), 90, 1e-9);
  EXPECT_NEAR(Elevation_deg(path.At(1.5)), 15, 1e-9);
}

TEST(ArmPath, TakesThePlaneOfTheWayWhereTheArmHangs) {
  const ArmPath path = PathThrough({Command_deg(0, 0), Command_deg(60, 40), Command_deg(0, -100)});
  for (const double time_s : {0.0, 0.001, 0.5, 1.0, 1.5, 2.0, 3.0}) {
    EXPECT_NEAR(Plane_deg(path.At(time_s)), 40, kRounding_rad) << time_s;
  }
}

TEST(ArmPath, TurnsThePlaneWhileTheArmHangs) {
  const ArmPath path = PathThrough({Command_deg(30, 170), Command_deg(0, 0), Command_deg(0, 5),
                                    Command_deg(0, 7), Command_deg(30, -150)});
  EXPECT_NEAR(Plane_deg(path.At(1)), 170, 1e-9);
  EXPECT_NEAR(Plane_deg(path.At(1.25)), 175, 1e-9);
  EXPECT_NEAR(Plane_deg(path.At(2)), -170, 1e-9);
  EXPECT_NEAR(Plane_deg(path.At(3)), -150, 1e-9);
  EXPECT_EQ(path.At(2).elevation_rad, 0);
}

TEST(ArmPath, KeepsThePlanesOfAnArmThatOnlyHangs) {
  const ArmPath path = PathThrough({Command_deg(0, 10), Command_deg(0, 30)});
  EXPECT_NEAR(Plane_deg(path.At(0.5)), 20, kRounding_rad);
}

TEST(ArmPath, PassesHangingBetweenOppositeDirections) {
  const ArmPath path = PathThrough({Command_deg(120, 40), Command_deg(60, -140)});
  EXPECT_NEAR(Elevation_deg(path.At(0.5)), 30, 1e-9);
  EXPECT_NEAR(Plane_deg(path.At(0.5)), 40, 1e-9);
  EXPECT_NEAR(Elevation_deg(path.At(0.75)), 15, 1e-9);
  EXPECT_NEAR(Plane_deg(path.At(0.75)), -140, 1e-9);
}

TEST(ArmPath, GoesUpInThePlaneOfTheRowThatIsStraightUp) {
  for (const bool falls : {false, true}) {
    const ArmCommand down = Command_deg(0, 0);
    const ArmCommand up = Command_deg(180, 40);
    const ArmPath path = falls ? PathThrough({up, down}) : PathThrough({down, up});
    EXPECT_NEAR(Elevation_deg(path.At(0.5)), 90, 1e-9) << falls;
    EXPECT_NEAR(Plane_deg(path.At(0.5)), 40, 1e-9) << falls;
  }
}

TEST(ArmPath, TurnsAnArmThatIsStraightUp) {
  const ArmPath path = PathThrough({Command_deg(180, 0), Command_deg(180, 90)});
  EXPECT_NEAR(Plane_deg(path.At(0.25)), 22.5, 1e-9);
  EXPECT_EQ(path.At(0.25).elevation_rad, RadiansFromDegrees(180));
}

TEST(ArmPath, TurnsAxiallyTheShortWay) {
  const ArmPath path = PathThrough({Command_deg(60, 40, 170), Command_deg(60, 40, -170)});
  EXPECT_NEAR(DegreesFromRadians(path.At(0.5).axial_rad), 180, 1e-9);
}

// No instant has a jump, where neither hanging nor straight up is passed and 180 is not.
TEST(ArmPath, CommandsThePlaneContinuously) {
  const ArmPath path = PathThrough({Command_deg(0, 77), Command_deg(20, -90), Command_deg(45, -60),
                                    Command_deg(100, 30), Command_deg(30, 120), Command_deg(0, 0),
                                    Command_deg(0, 0), Command_deg(90, 10)});
  constexpr double kStep_s = 1e-4;
  for (double time_s = 0; time_s < 7; time_s += kStep_s) {
    const double moved_rad = path.At(time_s + kStep_s).plane_rad - path.At(time_s).plane_rad;
    ASSERT_LT(std::abs(moved_rad), 50 * kStep_s) << time_s;
  }
}

TEST(ShortWay, IsWithinHalfATurn) {
  EXPECT_NEAR(ShortWay_rad(RadiansFromDegrees(170), RadiansFromDegrees(-170)),
              RadiansFromDegrees(20), kRounding_rad);
  EXPECT_NEAR(ShortWay_rad(RadiansFromDegrees(-170), RadiansFromDegrees(170)),
              RadiansFromDegrees(-20), kRounding_rad);
  EXPECT_EQ(ShortWay_rad(1, 1.5), 0.5);
}

// An arm that swings past hanging without turning about its long axis: ISB's plane jumps by half a
// turn there and ISB's axial rotation against it.
TEST(ArmPath, KeepsTheHumerusOfIsbsAxialRotation) {
  ArmCommand front = Command_deg(20, 90, -70);
  ArmCommand behind = Command_deg(30, -90, 114);
  front.axial_from = behind.axial_from = AxialFrom::kIsb;
  const ArmPath path = PathThrough({front, behind});
  // Whole turns: 20 deg in front, 24 behind.
  for (const double share : {0.0, 0.1, 0.39, 0.41, 0.75, 1.0}) {
    const ArmCommand command = path.At(share);
    EXPECT_EQ(command.axial_from, AxialFrom::kIsb);
    EXPECT_NEAR(
        ShortWay_rad(RadiansFromDegrees(20 + 4 * share), command.plane_rad + command.axial_rad), 0,
        kRounding_rad)
        << share;
    EXPECT_EQ(Plane_deg(command) > 0, share < 0.4) << share;
    EXPECT_LE(std::abs(command.axial_rad), kPi);
  }
}

TEST(ArmPath, KeepsTheTurnOfIsbsAxialRotationWhereTheArmHangs) {
  ArmCommand hanging = Command_deg(0, 50, -20);
  ArmCommand raised = Command_deg(40, 90, -60);
  hanging.axial_from = raised.axial_from = AxialFrom::kIsb;
  const ArmCommand start = PathThrough({hanging, raised}).At(0);
  // The plane of the way, and the humerus of the row.
  EXPECT_NEAR(Plane_deg(start), 90, 1e-9);
  EXPECT_NEAR(DegreesFromRadians(start.axial_rad), -60, 1e-9);
}

}  // namespace
}  // namespace girdle::arm_path_test
