// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "text/output_columns.h"

#include <gtest/gtest.h>

#include "text/number_text.h"

namespace girdle::output_columns_test {
namespace {

struct Step {
  double time_s;
  std::array<double, 2> p_m;
  bool is_moving;
};

struct Options {
  bool has_places;
};

std::vector<std::string> PlaceStems(const Options& options) {
  return options.has_places ? std::vector<std::string>{"x", "y"} : std::vector<std::string>{};
}

constexpr std::array<OutputColumns<Step, Options>, 3> kColumns = {{
    {[](const Options&) { return std::vector<std::string>{"time"}; }, kSeconds,
     [](const Step& step, std::size_t) -> Cell { return step.time_s; }},
    {PlaceStems, kMeters, [](const Step& step, std::size_t k) -> Cell { return step.p_m.at(k); }},
    {[](const Options&) { return std::vector<std::string>{"state"}; }, kNoUnit,
     [](const Step& step, std::size_t) -> Cell {
       return step.is_moving ? std::string_view("moves") : std::string_view("rests");
     }},
}};

constexpr Step kStep = {0.25, {1.5, -2}, true};

TEST(ColumnName, HasTheUnitBehindTheStem) {
  EXPECT_EQ(ColumnName("distance", kDegrees), "distance_deg");
  EXPECT_EQ(ColumnName("origin", kNoUnit), "origin");
}

TEST(WrittenColumns, HaveNamesAndValuesInTheOrderOfTheTable) {
  const WrittenColumns<Step, ExactNumbers> columns(kColumns, Options{true});
  EXPECT_EQ(columns.names(), (std::vector<std::string>{"time_s", "x_m", "y_m", "state"}));
  EXPECT_EQ(columns.Header(), "time_s,x_m,y_m,state");
  std::string row = "before ";
  columns.Append(row, kStep);
  EXPECT_EQ(row, "before 0.25,1.5,-2,moves");
}

TEST(WrittenColumns, LeaveOutWhatTheOutputDoesNotHave) {
  const WrittenColumns<Step, ExactNumbers> columns(kColumns, Options{false});
  EXPECT_EQ(columns.Header(), "time_s,state");
  std::string row;
  columns.Append(row, kStep);
  EXPECT_EQ(row, "0.25,moves");
}

TEST(WrittenColumns, WriteNumbersAsTheyAreTold) {
  const WrittenColumns<Step, RoundedNumbers> columns(kColumns, Options{true}, {0});
  std::string row;
  columns.Append(row, {0.75, {1.2, -2.2}, false});
  EXPECT_EQ(row, "1,1,-2,rests");
}

}  // namespace
}  // namespace girdle::output_columns_test
