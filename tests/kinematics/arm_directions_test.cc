// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/arm_directions.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <ostream>

#include "kinematics/random_rotations.h"
#include "kinematics/shoulder_pose.h"

namespace girdle::arm_directions_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

ArmRectangle Rectangle_deg(double lowest, double highest, double first, double last) {
  return {RadiansFromDegrees(lowest), RadiansFromDegrees(highest), RadiansFromDegrees(first),
          RadiansFromDegrees(last)};
}

TEST(ArmRectangle, HoldsItsEdges) {
  const ArmRectangle rectangle{0.25, 2, 0, 1.5};
  EXPECT_TRUE(rectangle.Holds(0.25, 0));
  EXPECT_TRUE(rectangle.Holds(2, 1.5));
  EXPECT_FALSE(rectangle.Holds(std::nextafter(0.25, 0), 0));
  EXPECT_FALSE(rectangle.Holds(2, std::nextafter(1.5, 2)));
  EXPECT_FALSE(rectangle.Holds(std::nextafter(2, 3), 1));
  EXPECT_FALSE(rectangle.Holds(1, -1e-300));
}

TEST(ArmRectangle, DoesNotHoldANan) {
  const ArmRectangle rectangle{0.25, 2, 0, 1.5};
  EXPECT_FALSE(rectangle.Holds(kNan, 1));
  EXPECT_FALSE(rectangle.Holds(1, kNan));
}

// Where the elbow lies, seen from GH.
Vector3 ArmDirection(double elevation_rad, double plane_rad) {
  return {std::sin(elevation_rad) * std::sin(plane_rad), -std::cos(elevation_rad),
          std::sin(elevation_rad) * std::cos(plane_rad)};
}

double AngleBetweenDirections(const Vector3& a, const Vector3& b) {
  return 2 * std::atan2(glm::length(a - b), glm::length(a + b));
}

// The nearest of many directions of the rectangle's border.
double NearestOfManyRad(const ArmRectangle& rectangle, const Vector3& direction) {
  constexpr int kCount = 3000;
  double nearest_rad = kPi;
  for (int i = 0; i <= kCount; ++i) {
    const auto within = [i](double first, double last) {
      return first + (last - first) * i / kCount;
    };
    const double elevation_rad =
        within(rectangle.lowest_elevation_rad, rectangle.highest_elevation_rad);
    const double plane_rad = within(rectangle.first_plane_rad, rectangle.last_plane_rad);
    for (const Vector3& other : {ArmDirection(elevation_rad, rectangle.first_plane_rad),
                                 ArmDirection(elevation_rad, rectangle.last_plane_rad),
                                 ArmDirection(rectangle.lowest_elevation_rad, plane_rad),
                                 ArmDirection(rectangle.highest_elevation_rad, plane_rad)}) {
      nearest_rad = std::min(nearest_rad, AngleBetweenDirections(direction, other));
    }
  }
  return nearest_rad;
}

RC_GTEST_PROP(AngleFromRectangle, IsThatOfTheNearestOfManyDirections, ()) {
  // Border directions are at most 180 / 3000 deg apart; the nearest is off by the square of half
  // of it, or by half of it where the distance is near zero.
  constexpr double kTolerance_rad = 0.5 * kPi / 3000;
  const double lowest = *NumberWithin(0, 80);
  const double first = *NumberWithin(-90, 90);
  const ArmRectangle rectangle =
      Rectangle_deg(lowest, *NumberWithin(lowest, 180), first, first + *NumberWithin(0, 170));
  const double elevation_rad = *NumberWithin(0, kPi);
  const double plane_rad = *NumberWithin(-kPi, kPi);
  const double distance_rad = AngleFromRectangle(rectangle, elevation_rad, plane_rad);
  const double middle_rad = (rectangle.first_plane_rad + rectangle.last_plane_rad) / 2;
  const double turned_rad = middle_rad + std::remainder(plane_rad - middle_rad, 2 * kPi);
  if (rectangle.Holds(elevation_rad, turned_rad)) {
    RC_ASSERT(distance_rad == 0);
    return;
  }
  const double nearest_rad = NearestOfManyRad(rectangle, ArmDirection(elevation_rad, plane_rad));
  RC_ASSERT(distance_rad < nearest_rad + 1e-9);
  RC_ASSERT(distance_rad > nearest_rad - kTolerance_rad);
}

struct DistanceCase {
  const char* name;
  double elevation_deg;
  double plane_deg;
  double distance_deg;
};

void PrintTo(const DistanceCase& distance, std::ostream* out) { *out << distance.name; }

class DistanceFromTheTable : public testing::TestWithParam<DistanceCase> {};

TEST_P(DistanceFromTheTable, IsTheAngleOfTheDirections) {
  const ArmRectangle table = Rectangle_deg(15, 120, 0, 90);
  EXPECT_NEAR(
      DegreesFromRadians(AngleFromRectangle(table, RadiansFromDegrees(GetParam().elevation_deg),
                                            RadiansFromDegrees(GetParam().plane_deg))),
      GetParam().distance_deg, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(
    Directions, DistanceFromTheTable,
    testing::Values(DistanceCase{"inside", 60, 40, 0}, DistanceCase{"on a corner", 120, 90, 0},
                    DistanceCase{"hanging, whatever the plane", 0, -170, 15},
                    DistanceCase{"straight up, whatever the plane", 180, -170, 60},
                    DistanceCase{"a level arm behind", 90, -20, 20},
                    DistanceCase{"a level arm across", 90, 135, 45},
                    DistanceCase{"a whole turn on", 90, 405, 0},
                    DistanceCase{"a whole turn back", 90, -380, 20},
                    DistanceCase{"an elevation below 0, inside in the opposite plane", -90, 220, 0},
                    DistanceCase{"an elevation above 180, inside in the opposite plane", 270, 220,
                                 0},
                    // acos(sin 15 cos 130): from (90, 220) the corner (15, 90) is nearest.
                    DistanceCase{"a level arm, written backwards", -90, 40, 99.57657851556995},
                    DistanceCase{"a hair beyond", 90, 90.000001, 0.000001}));

}  // namespace
}  // namespace girdle::arm_directions_test
