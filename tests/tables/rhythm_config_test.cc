// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "tables/rhythm_config.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "tables/built_in.h"
#include "tables/csv_text.h"
#include "tables/rhythm_table_csv.h"

namespace girdle {
namespace {

// All four keys, with values that no other key would take.
RhythmConfigText ValidText() {
  return {"slerp", "table", RhythmTableToLine(BuiltInRhythmTable()), "1 2 3 4 5 6 7 8 9"};
}

// Two planes of two elevations.
RhythmTable SmallTable() { return {{0, 1}, {0.5, 1}, std::vector<RhythmPosition>(4)}; }

TEST(RhythmConfig, IsAsPublishedIfNothingIsSaid) {
  const RhythmConfig config = ParseRhythmConfig({});
  EXPECT_EQ(config.rhythm.options().interpolation, Interpolation::kSquad);
  EXPECT_EQ(config.rhythm.options().closure, Closure::kTable);
}

TEST(RhythmConfig, HasTheBuiltInTableIfNoneIsGiven) {
  EXPECT_EQ(RhythmTableToLine(ParseRhythmConfig({}).rhythm.table()),
            RhythmTableToLine(BuiltInRhythmTable()));
}

TEST(RhythmConfig, HasOnePositiveStiffnessIfNoneIsGiven) {
  const auto stiffness = ParseRhythmConfig({}).stiffness_N_m_per_rad;
  EXPECT_GT(stiffness.front(), 0);
  EXPECT_EQ(std::count(stiffness.begin(), stiffness.end(), stiffness.front()),
            static_cast<std::ptrdiff_t>(kCoordinateCount));
}

TEST(RhythmConfig, TakesTheInterpolation) {
  for (const char* const name : {"squad", "slerp"}) {
    RhythmConfigText text = ValidText();
    text.interpolation = name;
    EXPECT_EQ(Name(ParseRhythmConfig(text).rhythm.options().interpolation), name);
  }
}

TEST(RhythmConfig, TakesTheClosure) {
  EXPECT_EQ(ParseRhythmConfig(ValidText()).rhythm.options().closure, Closure::kTable);
}

TEST(RhythmConfig, TakesATable) {
  RhythmConfigText text = ValidText();
  text.table = RhythmTableToLine(SmallTable());
  EXPECT_EQ(ParseRhythmConfig(text).rhythm.table().elevations_rad(), SmallTable().elevations_rad());
}

TEST(RhythmConfig, TakesNineStiffnessesInOrder) {
  EXPECT_EQ(ParseRhythmConfig(ValidText()).stiffness_N_m_per_rad,
            (std::array<double, kCoordinateCount>{1, 2, 3, 4, 5, 6, 7, 8, 9}));
}

TEST(RhythmConfig, TakesOneStiffnessForAll) {
  RhythmConfigText text = ValidText();
  text.stiffness = "12.5";
  std::array<double, kCoordinateCount> expected{};
  expected.fill(12.5);
  EXPECT_EQ(ParseRhythmConfig(text).stiffness_N_m_per_rad, expected);
}

TEST(RhythmConfig, TakesStiffnessesWithAnyBlanksBetween) {
  RhythmConfigText text = ValidText();
  text.stiffness = "  1 2\t3\n4 5  6 7 8 9 ";
  EXPECT_EQ(ParseRhythmConfig(text).stiffness_N_m_per_rad,
            (std::array<double, kCoordinateCount>{1, 2, 3, 4, 5, 6, 7, 8, 9}));
}

struct ConfigFlaw {
  const char* name;
  std::function<void(RhythmConfigText&)> change;
  const char* message;
};

void PrintTo(const ConfigFlaw& flaw, std::ostream* out) { *out << flaw.name; }

class FlawedConfig : public testing::TestWithParam<ConfigFlaw> {};

TEST_P(FlawedConfig, IsRefusedWithKeyValueAndFix) {
  RhythmConfigText text = ValidText();
  GetParam().change(text);
  EXPECT_EQ(MessageOf<std::runtime_error>([&] { static_cast<void>(ParseRhythmConfig(text)); }),
            GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    OneKeyEach, FlawedConfig,
    testing::Values(
        ConfigFlaw{"interpolation", [](RhythmConfigText& text) { text.interpolation = "linear"; },
                   "interpolation is \"linear\", expected \"squad\" or \"slerp\""},
        ConfigFlaw{"closure", [](RhythmConfigText& text) { text.closure = "Table"; },
                   "closure is \"Table\", expected \"table\""},
        ConfigFlaw{"two stiffnesses", [](RhythmConfigText& text) { text.stiffness = "1 2"; },
                   "kp is \"1 2\", expected one positive number of N m/rad, or nine in the order "
                   "sc, ac, gh"},
        ConfigFlaw{"ten stiffnesses",
                   [](RhythmConfigText& text) { text.stiffness = "1 2 3 4 5 6 7 8 9 10"; },
                   "kp is \"1 2 3 4 5 6 7 8 9 10\", expected one positive number of N m/rad, or "
                   "nine in the order sc, ac, gh"},
        ConfigFlaw{"blank stiffness", [](RhythmConfigText& text) { text.stiffness = " "; },
                   "kp is \" \", expected one positive number of N m/rad, or nine in the order sc, "
                   "ac, gh"},
        ConfigFlaw{"no stiffness at all", [](RhythmConfigText& text) { text.stiffness = "0"; },
                   "kp is \"0\", expected one positive number of N m/rad, or nine in the order sc, "
                   "ac, gh"},
        ConfigFlaw{"negative stiffness",
                   [](RhythmConfigText& text) { text.stiffness = "1 2 3 4 -5 6 7 8 9"; },
                   "kp is \"1 2 3 4 -5 6 7 8 9\", expected one positive number of N m/rad, or nine "
                   "in the order sc, ac, gh"},
        ConfigFlaw{"stiffness that is no number",
                   [](RhythmConfigText& text) { text.stiffness = "5OO"; },
                   "kp is \"5OO\", expected one positive number of N m/rad, or nine in the order "
                   "sc, ac, gh"},
        ConfigFlaw{"infinite stiffness", [](RhythmConfigText& text) { text.stiffness = "inf"; },
                   "kp is \"inf\", expected one positive number of N m/rad, or nine in the order "
                   "sc, ac, gh"},
        ConfigFlaw{"stiffnesses with commas",
                   [](RhythmConfigText& text) { text.stiffness = "1,2,3,4,5,6,7,8,9"; },
                   "kp is \"1,2,3,4,5,6,7,8,9\", expected one positive number of N m/rad, or nine "
                   "in the order sc, ac, gh"}));

TEST(RhythmConfig, SaysWhichKeyHoldsABrokenTable) {
  RhythmConfigText text = ValidText();
  text.table.replace(text.table.find(";0,20,") + 1, 5, "0,2O,");
  EXPECT_EQ(MessageOf<std::runtime_error>([&] { static_cast<void>(ParseRhythmConfig(text)); }),
            "config key \"table\":3: elevation_deg is '2O', expected a finite number such as 22.5");
}

// The header promises a std::runtime_error that names the key.
TEST(RhythmConfig, SaysWhichKeyHoldsATableWithUndeterminedWays) {
  std::vector<RhythmPosition> positions(6);
  positions[4].angles_rad[0] = RadiansFromDegrees(100);
  positions[5].angles_rad[0] = RadiansFromDegrees(-160);
  RhythmConfigText text = ValidText();
  text.table = RhythmTableToLine({{0, 1}, {0.5, 1, 1.5}, positions});
  std::string message;
  ASSERT_NO_THROW(
      message = MessageOf<std::runtime_error>([&] { static_cast<void>(ParseRhythmConfig(text)); }));
  EXPECT_EQ(message.rfind("config key \"table\": SC turns by 180 deg or more", 0), 0U) << message;
}

}  // namespace
}  // namespace girdle
