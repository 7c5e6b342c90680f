// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "simulation/trace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace girdle {
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
  const std::string header = TraceHeader();
  std::string row;
  AppendTraceRow(row, ShoulderState{});
  EXPECT_EQ(std::count(row.begin(), row.end(), ','), std::count(header.begin(), header.end(), ','));
  EXPECT_TRUE(
      header.starts_with("time_s,elevation_deg,plane_deg,axial_deg,target_sc_protraction_deg"));
}

}  // namespace
}  // namespace girdle
