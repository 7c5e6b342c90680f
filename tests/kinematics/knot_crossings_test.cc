// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/knot_crossings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace girdle::knot_crossings_test {
namespace {

constexpr double kRounding_deg = 1e-9;

std::vector<double> Radians(std::vector<double> angles_deg) {
  for (double& angle : angles_deg) {
    angle = RadiansFromDegrees(angle);
  }
  return angles_deg;
}

// Knots that are even in no direction.
RhythmTable Table() {
  return {Radians({0, 40, 90}), Radians({15, 20, 50, 60}), std::vector<RhythmPosition>(12)};
}

using PlaceInDegrees = std::pair<double, double>;  // elevation, plane

std::vector<PlaceInDegrees> Degrees(const std::vector<ArmCommand>& places) {
  std::vector<PlaceInDegrees> degrees;
  degrees.reserve(places.size());
  for (const ArmCommand& place : places) {
    degrees.emplace_back(DegreesFromRadians(place.elevation_rad),
                         DegreesFromRadians(place.plane_rad));
  }
  return degrees;
}

void ExpectNear(const std::vector<PlaceInDegrees>& found,
                const std::vector<PlaceInDegrees>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i].first, expected[i].first, kRounding_deg) << i;
    EXPECT_NEAR(found[i].second, expected[i].second, kRounding_deg) << i;
  }
}

TEST(FewKnotCrossings, OfElevationsAreOnEveryInnerLineAtThePlanesAndBetween) {
  std::vector<PlaceInDegrees> expected;
  for (const double elevation_deg : {20, 50}) {
    for (const double plane_deg : {0.5, 20.0, 40.0, 65.0, 89.5}) {
      expected.emplace_back(elevation_deg, plane_deg);
    }
  }
  ExpectNear(Degrees(FewKnotCrossings(Table(), Direction::kElevation)), expected);
}

TEST(FewKnotCrossings, OfPlanesAreOnEveryInnerLineAtTheElevationsAndBetween) {
  std::vector<PlaceInDegrees> expected;
  for (const double elevation_deg : {15.5, 17.5, 20.0, 35.0, 50.0, 55.0, 59.5}) {
    expected.emplace_back(elevation_deg, 40);
  }
  ExpectNear(Degrees(FewKnotCrossings(Table(), Direction::kPlane)), expected);
}

TEST(FewKnotCrossings, AreNoneWithoutAnInnerLine) {
  const RhythmTable table(Radians({0, 90}), Radians({15, 20, 50}), std::vector<RhythmPosition>(6));
  EXPECT_TRUE(FewKnotCrossings(table, Direction::kPlane).empty());
  EXPECT_EQ(FewKnotCrossings(table, Direction::kElevation).size(), 3U);
}

TEST(KnotCrossings, AreADegreeApartOnEveryInnerLineFromBorderToBorder) {
  const auto places = Degrees(KnotCrossings(Table(), Direction::kElevation));
  ASSERT_EQ(places.size(), 2U * 90U);
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_NEAR(places[i].first, i < 90 ? 20 : 50, kRounding_deg);
    EXPECT_NEAR(places[i].second, 0.5 + static_cast<double>(i % 90), kRounding_deg);
  }
}

TEST(KnotsAlong, AreTheTablesOwn) {
  const RhythmTable table = Table();
  EXPECT_EQ(KnotsAlong(table, Direction::kElevation), table.elevations_rad());
  EXPECT_EQ(KnotsAlong(table, Direction::kPlane), table.planes_rad());
}

}  // namespace
}  // namespace girdle::knot_crossings_test
