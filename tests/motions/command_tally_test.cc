// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "motions/command_tally.h"

#include <gtest/gtest.h>

namespace girdle::command_tally_test {
namespace {

TEST(TallyText, CountsRowsAndSaysWhyTheyWereClamped) {
  EXPECT_EQ(TallyText({}, {}), "0 rows, 0 clamped, 0 modelled");
  const CommandTally tally{9, 3, 2, 1, 4, RadiansFromDegrees(37.25)};
  EXPECT_EQ(TallyText(tally, {Range::kWhole}),
            "9 rows, 3 clamped (2 beyond what an arm reaches, 1 beyond the range of a joint or "
            "control; see the columns used_*), 1 derived, 4 modelled (up to 37.2 deg from measured "
            "directions)");
  EXPECT_EQ(TallyText({9, 2, 2, 0, 0, 0}, {Range::kClamp}),
            "9 rows, 2 clamped (2 beyond the table; see the columns used_*), 0 modelled");
  EXPECT_EQ(
      TallyText({9, 1, 0, 0, 0, 0}, {Range::kWhole}),
      "9 rows, 1 clamped (1 beyond the range of a joint or control; see the columns used_*), 0 "
      "modelled");
}

TEST(TallyText, NamesWhatIsCountedAndPointsToColumnsThatAreThere) {
  EXPECT_EQ(TallyText({1, 0, 0, 0, 0, 0}, {}), "1 row, 0 clamped, 0 modelled");
  EXPECT_EQ(TallyText({1, 1, 1, 0, 0, 0}, {Range::kWhole, "simulated state", false}),
            "1 simulated state, 1 clamped (1 beyond what an arm reaches), 0 modelled");
  EXPECT_EQ(TallyText({2, 0, 0, 0, 0, 0}, {Range::kWhole, "simulated state"}),
            "2 simulated states, 0 clamped, 0 modelled");
}

TEST(TallyText, CountsGapsAndBridgedRowsWhereThereAreSome) {
  EXPECT_EQ(TallyText({9, 0, 0, 0, 0, 0, 1, 3}, {.axial_from = AxialFrom::kIsb}),
            "9 rows, 0 clamped, 0 modelled, 1 gap, 3 bridged, axial from isb");
  EXPECT_EQ(TallyText({9, 0, 0, 0, 0, 0, 2, 0}, {}), "9 rows, 0 clamped, 0 modelled, 2 gaps");
}

TEST(TallyText, SaysWhatAxialTurnsCountFrom) {
  EXPECT_EQ(TallyText({2, 0, 0, 0, 0, 0}, {.axial_from = AxialFrom::kIsb}),
            "2 rows, 0 clamped, 0 modelled, axial from isb");
}

TEST(TallyText, SaysWhereTheHangingArmComesFromThatRotationsCountFrom) {
  EXPECT_EQ(TallyText({2, 0, 0, 0, 0, 0}, {.hanging = Origin::kModelled}),
            "2 rows, 0 clamped, 0 modelled, relative to hanging (modelled)");
}

TEST(CommandTally, AddsUpParts) {
  CommandTally tally{9, 3, 2, 2, 4, 0.25, 1, 2};
  tally.Add({1, 1, 1, 1, 1, 0.5, 2, 3});
  tally.Add({0, 0, 0, 0, 0, 0.125, 0, 0});
  EXPECT_EQ(tally.rows, 10U);
  EXPECT_EQ(tally.clamped, 4U);
  EXPECT_EQ(tally.beyond, 3U);
  EXPECT_EQ(tally.derived, 3U);
  EXPECT_EQ(tally.modelled, 5U);
  EXPECT_EQ(tally.farthest_rad, 0.5);
  EXPECT_EQ(tally.gaps, 3U);
  EXPECT_EQ(tally.bridged, 5U);
}

}  // namespace
}  // namespace girdle::command_tally_test
