// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "simulation/trace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <sstream>
#include <string>

#include "text/csv.h"

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
                         "used_elevation_deg,used_plane_deg,distance_deg,used_axial_deg,"
                         "used_axial_isb_deg,used_shrug_deg,used_protraction_deg,"
                         "target_sc_protraction_deg"));
}

TEST(Trace, HasCommandsAndDistanceInDegrees) {
  ShoulderState state;
  state.time_s = 0.5;
  state.command =
      ReplayableCommand({RadiansFromDegrees(90), RadiansFromDegrees(45), RadiansFromDegrees(22.5),
                         RadiansFromDegrees(11.25), RadiansFromDegrees(-45)});
  state.used = ReplayableCommand({RadiansFromDegrees(22.5), RadiansFromDegrees(11.25),
                                  RadiansFromDegrees(5.625), RadiansFromDegrees(2.8125),
                                  RadiansFromDegrees(-22.5)});
  state.distance_rad = RadiansFromDegrees(90);
  state.used_axial_isb_rad = RadiansFromDegrees(-45);
  std::string row;
  AppendTraceRow(row, state);
  EXPECT_TRUE(row.starts_with("0.5,90,45,22.5,11.25,-45,22.5,11.25,90,5.625,-45,2.8125,-22.5,0,"))
      << row;
}

TEST(Trace, TakesNoMoreThanItsSizeSays) {
  ShoulderState state;
  for (Quaternion& q : state.q_WB) {
    q = Quaternion(-0.12345678901234567, 1.0 / 3, 2.0 / 3, 1.0 / 7);
  }
  state.site_m.fill(Vector3(-1.0 / 3, 1.0 / 7, -2.0 / 7));
  const std::string header = TraceHeader(Assembly::kTree);
  std::string row;
  AppendTraceRow(row, state);
  EXPECT_GE(SizeOfRows(header, 1000), header.size() + 1000 * row.size());
  EXPECT_LE(SizeOfRows(header, 1000), header.size() + 2000 * row.size());
}

// Of a state whose values are all different.
TEST(Trace, HasEachValueUnderItsName) {
  ShoulderState state;
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    state.target_rad[k] = RadiansFromDegrees(static_cast<double>(k + 1));
    state.position_rad[k] = RadiansFromDegrees(static_cast<double>(k + 101));
  }
  for (std::size_t i = 0; i < kSegmentCount; ++i) {
    const auto q = static_cast<double>(10 * i);
    state.q_WB[i] = Quaternion(q + 0.25, q + 1, q + 2, q + 3);
  }
  for (std::size_t i = 0; i < kSiteCount; ++i) {
    const auto p = static_cast<double>(1000 * i);
    state.site_m[i] = {p + 0.5, p + 1, p + 2};
  }
  std::string row;
  AppendTraceRow(row, state);
  std::istringstream in(TraceHeader(Assembly::kLoop) + row);
  CsvReader csv(in, "trace");
  ASSERT_TRUE(csv.Next());
  const auto value = [&csv](const std::string& column) { return csv.Number(csv.Column(column)); };
  // Through radians and back.
  constexpr double kRounding_deg = 1e-13;
  const auto driven = DrivenCoordinates(Assembly::kLoop);
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    const std::string name = std::string(driven[k]) + "_deg";
    EXPECT_NEAR(value("target_" + name), static_cast<double>(k + 1), kRounding_deg);
    EXPECT_NEAR(value(name), static_cast<double>(k + 101), kRounding_deg);
  }
  EXPECT_EQ(value("clavicle_qw"), 10.25);
  EXPECT_EQ(value("scapula_qx"), 21);
  EXPECT_EQ(value("humerus_qz"), 33);
  for (std::size_t i = 0; i < kSiteCount; ++i) {
    const std::string name(SiteStem(i));
    EXPECT_EQ(value(name + "_x_m"), static_cast<double>(1000 * i) + 0.5);
    EXPECT_EQ(value(name + "_z_m"), static_cast<double>(1000 * i) + 2);
  }
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
