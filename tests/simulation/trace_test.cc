// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "simulation/trace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace girdle::trace_test {
namespace {

TEST(ReplayableCommand, ComesBackExactlyFromDegrees) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> angle(-4, 4);
  for (int sample = 0; sample < 100000; ++sample) {
    const double wanted_rad = angle(random);
    const double given_rad = ReplayableCommand({wanted_rad, 0, 0}).elevation_rad;
    EXPECT_EQ(RadiansFromDegrees(DegreesFromRadians(given_rad)), given_rad) << wanted_rad;
    // A few units in the last place.
    EXPECT_NEAR(given_rad, wanted_rad, 4e-15) << wanted_rad;
  }
}

TEST(Trace, EveryRowHasTheColumnsOfTheHeader) {
  const std::string header = TraceHeader(Assembly::kTree);
  std::string row;
  AppendTraceRow(row, ShoulderState{});
  EXPECT_EQ(std::count(row.begin(), row.end(), ','), std::count(header.begin(), header.end(), ','));
  EXPECT_TRUE(
      header.starts_with("time_s,elevation_deg,plane_deg,axial_deg,shrug_deg,protraction_deg,"
                         "distance_deg,target_sc_protraction_deg"));
}

TEST(Trace, HasCommandsAndDistanceInDegrees) {
  ShoulderState state;
  state.time_s = 0.5;
  state.command =
      ReplayableCommand({RadiansFromDegrees(90), RadiansFromDegrees(45), RadiansFromDegrees(22.5),
                         RadiansFromDegrees(11.25), RadiansFromDegrees(-45)});
  state.distance_rad = RadiansFromDegrees(90);
  std::string row;
  AppendTraceRow(row, state);
  EXPECT_TRUE(row.starts_with("0.5,90,45,22.5,11.25,-45,90,0,")) << row;
}

TEST(ReplayableCommand, HasAllOfACommand) {
  const ArmCommand command{0.5, 0.25, -0.125, 0.0625, -0.03125};
  const ArmCommand given = ReplayableCommand(command);
  constexpr double kFewUnits = 1e-15;
  EXPECT_NEAR(given.elevation_rad, command.elevation_rad, kFewUnits);
  EXPECT_NEAR(given.plane_rad, command.plane_rad, kFewUnits);
  EXPECT_NEAR(given.axial_rad, command.axial_rad, kFewUnits);
  EXPECT_NEAR(given.shrug_rad, command.shrug_rad, kFewUnits);
  EXPECT_NEAR(given.protraction_rad, command.protraction_rad, kFewUnits);
}

}  // namespace
}  // namespace girdle::trace_test
