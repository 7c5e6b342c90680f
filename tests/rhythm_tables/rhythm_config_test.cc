// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "rhythm_tables/rhythm_config.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "rhythm_tables/built_in_tables.h"
#include "rhythm_tables/rhythm_table_csv.h"
#include "text/csv_text.h"
#include "text/input_error.h"
#include "text/shown_text.h"

namespace girdle::rhythm_config_test {
namespace {

// All five keys, with values that no other key would take.
RhythmConfigText ValidText() {
  return {"slerp", "table", "clamp", RhythmTableToLine(BuiltInRhythmTable(BuiltInTable::kMeasured)),
          "1 2 3 4 5 6 7 8 9"};
}

ShoulderRhythm RhythmOf(const RhythmConfigText& text) {
  return MakeRhythm(Resolve(ParseRhythmConfig(text).rhythm), ShoulderRhythm::Unbounded(),
                    "config: ");
}

// Two planes of two elevations.
RhythmTable SmallTable() { return {{0, 1}, {0.5, 1}, std::vector<RhythmPosition>(4)}; }

TEST(RhythmConfig, IsSmoothAndExactOverTheWholeRangeIfNothingIsSaid) {
  const RhythmOptions options = RhythmOf({}).options();
  EXPECT_EQ(options.interpolation, Interpolation::kSmooth);
  EXPECT_EQ(options.closure, Closure::kExact);
  EXPECT_EQ(options.range, Range::kWhole);
}

// Where there is no rule for the whole range, the table's nearest point answers.
TEST(RhythmConfig, ClampsToTheTableWhereNothingElseIsKnown) {
  for (const auto& [interpolation, closure] :
       {std::pair("squad", "table"), std::pair("squad", "exact"), std::pair("smooth", "table")}) {
    EXPECT_EQ(RhythmOf({interpolation, closure, "", "", ""}).options().range, Range::kClamp)
        << interpolation << ", " << closure;
  }
}

struct TableChoice {
  const char* interpolation;
  const char* table;
  BuiltInTable expected;
};

void PrintTo(const TableChoice& choice, std::ostream* out) {
  *out << choice.interpolation << " with table '" << choice.table << "'";
}

class ChosenTable : public testing::TestWithParam<TableChoice> {};

TEST_P(ChosenTable, IsTheOneNamedOrTheInterpolationsOwn) {
  const RhythmConfig config =
      ParseRhythmConfig({GetParam().interpolation, "", "", GetParam().table, ""});
  EXPECT_EQ(RhythmTableToLine(Resolve(config.rhythm).table),
            RhythmTableToLine(BuiltInRhythmTable(GetParam().expected)));
}

INSTANTIATE_TEST_SUITE_P(Words, ChosenTable,
                         testing::Values(TableChoice{"", "", BuiltInTable::kSmoothed},
                                         TableChoice{"smooth", "", BuiltInTable::kSmoothed},
                                         TableChoice{"squad", "", BuiltInTable::kMeasured},
                                         TableChoice{"slerp", "", BuiltInTable::kMeasured},
                                         TableChoice{"smooth", "measured", BuiltInTable::kMeasured},
                                         TableChoice{"squad", "smoothed",
                                                     BuiltInTable::kSmoothed}));

TEST(RhythmConfig, HasOnePositiveStiffnessIfNoneIsGiven) {
  const auto stiffness = ParseRhythmConfig({}).stiffness_N_m_per_rad;
  EXPECT_GT(stiffness.front(), 0);
  EXPECT_EQ(std::count(stiffness.begin(), stiffness.end(), stiffness.front()),
            static_cast<std::ptrdiff_t>(kCoordinateCount));
}

TEST(RhythmConfig, TakesTheInterpolation) {
  for (const char* const name : {"smooth", "squad", "slerp"}) {
    RhythmConfigText text = ValidText();
    text.interpolation = name;
    EXPECT_EQ(Name(ParseRhythmConfig(text).rhythm.interpolation.value()), name);
  }
}

TEST(RhythmConfig, TakesTheClosure) {
  for (const char* const name : {"exact", "table"}) {
    RhythmConfigText text = ValidText();
    text.closure = name;
    EXPECT_EQ(Name(ParseRhythmConfig(text).rhythm.closure.value()), name);
  }
}

TEST(RhythmConfig, TakesTheRange) {
  for (const char* const name : {"whole", "clamp"}) {
    RhythmConfigText text = ValidText();
    text.range = name;
    EXPECT_EQ(Name(ParseRhythmConfig(text).rhythm.range.value()), name);
  }
}

TEST(RhythmConfig, TakesWhatAxialTurnsAreCountedFrom) {
  for (const char* const name : {"rhythm", "isb", "swing"}) {
    RhythmConfigText text = ValidText();
    text.axial_from = name;
    EXPECT_EQ(Name(ParseRhythmConfig(text).axial_from), name);
  }
  EXPECT_EQ(ParseRhythmConfig(ValidText()).axial_from, AxialFrom::kRhythm);
}

TEST(RhythmConfig, TakesATable) {
  RhythmConfigText text = ValidText();
  text.table = RhythmTableToLine(SmallTable());
  EXPECT_EQ(Resolve(ParseRhythmConfig(text).rhythm).table.elevations_rad(),
            SmallTable().elevations_rad());
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
  EXPECT_EQ(MessageOf<InputError>([&] { static_cast<void>(ParseRhythmConfig(text)); }),
            GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    OneKeyEach, FlawedConfig,
    testing::Values(
        ConfigFlaw{"interpolation", [](RhythmConfigText& text) { text.interpolation = "linear"; },
                   "interpolation is \"linear\", expected \"smooth\" or \"squad\" or \"slerp\""},
        ConfigFlaw{"closure", [](RhythmConfigText& text) { text.closure = "Table"; },
                   "closure is \"Table\", expected \"exact\" or \"table\""},
        ConfigFlaw{"range", [](RhythmConfigText& text) { text.range = "all"; },
                   "range is \"all\", expected \"whole\" or \"clamp\""},
        ConfigFlaw{"side", [](RhythmConfigText& text) { text.side = "Left"; },
                   "side is \"Left\", expected \"right\" or \"left\""},
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

TEST(RhythmConfig, ShowsTheBeginningOfALongValue) {
  constexpr std::size_t kLong = 5000;
  RhythmConfigText text = ValidText();
  text.closure = std::string(kLong, 't');
  EXPECT_EQ(MessageOf<InputError>([&] { static_cast<void>(ParseRhythmConfig(text)); }),
            "closure is \"" + ShortText(text.closure) + "\", expected \"exact\" or \"table\"");
}

TEST(RhythmConfig, SaysWhichKeyHoldsABrokenTable) {
  RhythmConfigText text = ValidText();
  text.table.replace(text.table.find(";0,20,") + 1, 5, "0,2O,");
  EXPECT_EQ(MessageOf<InputError>([&] { static_cast<void>(ParseRhythmConfig(text)); }),
            "config key \"table\":3: elevation_deg is '2O', expected a finite number such as 22.5");
}

TEST(RhythmConfig, TakesAWordThatNamesNoTableForATable) {
  RhythmConfigText text = ValidText();
  text.table = "Measured";
  const std::string message =
      MessageOf<InputError>([&] { static_cast<void>(ParseRhythmConfig(text)); });
  EXPECT_EQ(message.rfind("config key \"table\"", 0), 0U) << message;
}

// So that what is said over it does not meet a default that nobody said.
TEST(RhythmConfig, LeavesOpenWhatTheModelDoesNotSay) {
  const RhythmChoice rhythm = ParseRhythmConfig({}).rhythm;
  EXPECT_EQ(rhythm.interpolation, std::nullopt);
  EXPECT_EQ(rhythm.closure, std::nullopt);
  EXPECT_EQ(rhythm.range, std::nullopt);
  EXPECT_FALSE(rhythm.table.has_value());
}

TEST(RhythmConfig, TakesTheSide) {
  RhythmConfigText text = ValidText();
  EXPECT_EQ(ParseRhythmConfig(text).side, Side::kRight);
  text.side = "left";
  EXPECT_EQ(ParseRhythmConfig(text).side, Side::kLeft);
}

// What a configuration's words or its table do not go together for.
struct UnfitConfig {
  const char* name;
  std::function<void(RhythmConfigText&)> change;
  const char* message;
};

void PrintTo(const UnfitConfig& unfit, std::ostream* out) { *out << unfit.name; }

class ConfiguredRhythmRefusal : public testing::TestWithParam<UnfitConfig> {};

TEST_P(ConfiguredRhythmRefusal, SaysWhatDoesNotGoTogether) {
  RhythmConfigText text = ValidText();
  GetParam().change(text);
  std::string message;
  ASSERT_NO_THROW(message = MessageOf<InputError>([&] { static_cast<void>(RhythmOf(text)); }));
  EXPECT_EQ(message.rfind(GetParam().message, 0), 0U) << message;
}

INSTANTIATE_TEST_SUITE_P(
    OneKeyEach, ConfiguredRhythmRefusal,
    testing::Values(
        UnfitConfig{"the whole range with slerp",
                    [](RhythmConfigText& text) { text.range = "whole"; },
                    "config: the range whole needs the interpolation smooth and the closure exact: "
                    "with others nothing is known outside the table. Choose the range clamp"},
        UnfitConfig{"a table too small for smooth",
                    [](RhythmConfigText& text) {
                      text.interpolation = "smooth";
                      text.table = RhythmTableToLine(SmallTable());
                    },
                    "config: "},
        UnfitConfig{"a table whose ways between planes are not determined",
                    [](RhythmConfigText& text) {
                      std::vector<RhythmPosition> positions(6);
                      positions[4].angles_rad[0] = RadiansFromDegrees(100);
                      positions[5].angles_rad[0] = RadiansFromDegrees(-160);
                      text.table = RhythmTableToLine({{0, 1}, {0.5, 1, 1.5}, positions});
                    },
                    "config: SC turns by 180 deg or more between planes"}),
    [](const auto& parameter) { return "Config" + std::to_string(parameter.index); });

}  // namespace
}  // namespace girdle::rhythm_config_test
