// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "rhythm_tables/rhythm_choice.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "rhythm_tables/rhythm_table_csv.h"
#include "text/csv_text.h"
#include "text/input_error.h"

namespace girdle::rhythm_choice_test {
namespace {

// Two planes of two elevations.
RhythmTable SmallTable() { return {{0, 1}, {0.5, 1}, std::vector<RhythmPosition>(4)}; }

// A table of a model, and one of a file.
const TableChoice kOwn = ReadTable{SmallTable()};
const TableChoice kOfFile = ReadTable{SmallTable(), "mine.csv"};

// The four things that can be said; each bit of a number says whether one is.
constexpr unsigned kInterpolationBit = 1;
constexpr unsigned kClosureBit = 2;
constexpr unsigned kRangeBit = 4;
constexpr unsigned kTableBit = 8;
constexpr unsigned kAllBits = 15;

// What is said differs from each other and, where it can, from the defaults.
const RhythmChoice kAllOfFirst = {Interpolation::kSquad, Closure::kTable, Range::kClamp, kOfFile};
const RhythmChoice kAllOfSecond = {Interpolation::kSlerp, Closure::kExact, Range::kWhole, kOwn};

RhythmChoice Said(const RhythmChoice& all, unsigned bits) {
  RhythmChoice said;
  if ((bits & kInterpolationBit) != 0) said.interpolation = all.interpolation;
  if ((bits & kClosureBit) != 0) said.closure = all.closure;
  if ((bits & kRangeBit) != 0) said.range = all.range;
  if ((bits & kTableBit) != 0) said.table = all.table;
  return said;
}

std::optional<std::string> TableName(const RhythmChoice& choice) {
  return choice.table ? std::optional(TableName(*choice.table)) : std::nullopt;
}

TEST(Over, TakesWhatTheFirstSaysAndElseWhatTheSecondSays) {
  for (unsigned first = 0; first <= kAllBits; ++first) {
    for (unsigned second = 0; second <= kAllBits; ++second) {
      const auto chosen = [&](unsigned bit, const auto& of_first, const auto& of_second) {
        using Value = std::decay_t<decltype(of_first)>;
        return (first & bit) != 0 ? of_first : (second & bit) != 0 ? of_second : Value{};
      };
      const RhythmChoice both = Over(Said(kAllOfFirst, first), Said(kAllOfSecond, second));
      const std::string which = std::to_string(first) + " over " + std::to_string(second);
      EXPECT_EQ(both.interpolation,
                chosen(kInterpolationBit, kAllOfFirst.interpolation, kAllOfSecond.interpolation))
          << which;
      EXPECT_EQ(both.closure, chosen(kClosureBit, kAllOfFirst.closure, kAllOfSecond.closure))
          << which;
      EXPECT_EQ(TableName(both), chosen(kTableBit, TableName(kAllOfFirst), TableName(kAllOfSecond)))
          << which;
    }
  }
}

// A model that says "range whole" says it of its own interpolation and closure.
TEST(Over, DropsTheSecondsRangeWhereTheFirstSaysWhatItDependsOn) {
  for (unsigned first = 0; first <= kAllBits; ++first) {
    for (unsigned second = 0; second <= kAllBits; ++second) {
      std::optional<Range> expected;
      if ((first & kRangeBit) != 0) {
        expected = kAllOfFirst.range;
      } else if ((first & (kInterpolationBit | kClosureBit)) == 0 && (second & kRangeBit) != 0) {
        expected = kAllOfSecond.range;
      }
      EXPECT_EQ(Over(Said(kAllOfFirst, first), Said(kAllOfSecond, second)).range, expected)
          << first << " over " << second;
    }
  }
}

TEST(Resolve, HasWhatWasSaid) {
  const ResolvedRhythm resolved = Resolve(kAllOfFirst);
  EXPECT_EQ(resolved.options.interpolation, Interpolation::kSquad);
  EXPECT_EQ(resolved.options.closure, Closure::kTable);
  EXPECT_EQ(resolved.options.range, Range::kClamp);
  EXPECT_EQ(RhythmTableToLine(resolved.table), RhythmTableToLine(SmallTable()));
  EXPECT_EQ(resolved.table_name(), "mine.csv");
  EXPECT_EQ(resolved.text(), "interpolation squad, closure table, range clamp, table mine.csv");
}

// The default of each is that of what was said of the others.
TEST(Resolve, FillsInTheDefaultsOfEveryCombination) {
  for (const std::optional<Interpolation> interpolation :
       {std::optional<Interpolation>(), std::optional(Interpolation::kSmooth),
        std::optional(Interpolation::kSquad), std::optional(Interpolation::kSlerp)}) {
    for (const std::optional<Closure> closure :
         {std::optional<Closure>(), std::optional(Closure::kExact),
          std::optional(Closure::kTable)}) {
      for (const std::optional<Range> range :
           {std::optional<Range>(), std::optional(Range::kWhole), std::optional(Range::kClamp)}) {
        for (const std::optional<TableChoice>& table :
             {std::optional<TableChoice>(), std::optional<TableChoice>(BuiltInTable::kMeasured),
              std::optional<TableChoice>(BuiltInTable::kSmoothed),
              std::optional<TableChoice>(kOwn)}) {
          const ResolvedRhythm resolved = Resolve({interpolation, closure, range, table});
          const bool is_smooth =
              interpolation.value_or(Interpolation::kSmooth) == Interpolation::kSmooth;
          const bool is_exact = closure.value_or(Closure::kExact) == Closure::kExact;
          SCOPED_TRACE(resolved.text());
          EXPECT_EQ(resolved.options.interpolation, interpolation.value_or(Interpolation::kSmooth));
          EXPECT_EQ(resolved.options.closure, closure.value_or(Closure::kExact));
          EXPECT_EQ(resolved.options.range,
                    range.value_or(is_smooth && is_exact ? Range::kWhole : Range::kClamp));
          const std::string name = table       ? TableName(*table)
                                   : is_smooth ? std::string("smoothed")
                                               : std::string("measured");
          EXPECT_EQ(resolved.table_name(), name);
          // The table that is named is the one that is used.
          const RhythmTable expected =
              name == "measured"   ? BuiltInRhythmTable(BuiltInTable::kMeasured)
              : name == "smoothed" ? BuiltInRhythmTable(BuiltInTable::kSmoothed)
                                   : SmallTable();
          EXPECT_EQ(RhythmTableToLine(resolved.table), RhythmTableToLine(expected));
          EXPECT_EQ(resolved.built_in().has_value(), name != "the model's own");
        }
      }
    }
  }
}

// What a model without a table means changes with the interpolation that is said over it.
TEST(Resolve, NamesTheTableOfTheInterpolationThatCounts) {
  const RhythmChoice model_says = {Interpolation::kSmooth, Closure::kExact, Range::kWhole};
  EXPECT_EQ(Resolve(model_says).table_name(), "smoothed");
  const ResolvedRhythm squad = Resolve(Over({.interpolation = Interpolation::kSquad}, model_says));
  EXPECT_EQ(squad.table_name(), "measured");
  EXPECT_EQ(RhythmTableToLine(squad.table),
            RhythmTableToLine(BuiltInRhythmTable(BuiltInTable::kMeasured)));
  EXPECT_EQ(squad.text(), "interpolation squad, closure exact, range clamp, table measured");
}

TEST(MakeRhythm, HasTheOptionsTheTableAndTheJointRanges) {
  JointRanges ranges = ShoulderRhythm::Unbounded();
  ranges[kGhAxialIndex] = {-1.25, 0.75};
  const ShoulderRhythm rhythm = MakeRhythm(Resolve(kAllOfFirst), ranges);
  EXPECT_EQ(rhythm.options().interpolation, Interpolation::kSquad);
  EXPECT_EQ(rhythm.options().closure, Closure::kTable);
  EXPECT_EQ(RhythmTableToLine(rhythm.table()), RhythmTableToLine(SmallTable()));
  EXPECT_EQ(rhythm.ranges()[kGhAxialIndex].lower_rad, -1.25);
  EXPECT_EQ(rhythm.ranges()[kGhAxialIndex].upper_rad, 0.75);
}

std::string Refusal(const RhythmChoice& choice, const std::string& otherwise) {
  return MessageOf<InputError>([&] {
    static_cast<void>(MakeRhythm(Resolve(choice), ShoulderRhythm::Unbounded(), otherwise));
  });
}

constexpr const char* kNoRule =
    "the range whole needs the interpolation smooth and the closure exact: with others nothing is "
    "known outside the table. Choose the range clamp";

TEST(MakeRhythm, SaysWhichOptionsDoNotGoTogether) {
  const RhythmChoice choice = {Interpolation::kSquad, Closure::kExact, Range::kWhole};
  EXPECT_EQ(Refusal(choice, "m.xml: "), std::string("m.xml: ") + kNoRule);
  EXPECT_EQ(MessageOf<InputError>([&] {
              static_cast<void>(MakeRhythm(Resolve(choice), ShoulderRhythm::Unbounded()));
            }),
            std::string("these options do not go together: ") + kNoRule);
}

TEST(MakeRhythm, NamesTheFileOfATableAndNoFileOfAModelsOwn) {
  RhythmChoice choice = {Interpolation::kSquad, Closure::kExact, Range::kWhole, kOfFile};
  EXPECT_EQ(Refusal(choice, "m.xml: "), std::string("mine.csv: ") + kNoRule);
  choice.table = kOwn;
  EXPECT_EQ(Refusal(choice, "m.xml: "), std::string("m.xml: ") + kNoRule);
}

TEST(TableFromWordOrLine, IsTheBuiltInTableOfAWordAndElseTheLine) {
  EXPECT_EQ(std::get<BuiltInTable>(TableFromWordOrLine("measured", "place")),
            BuiltInTable::kMeasured);
  const TableChoice own = TableFromWordOrLine(RhythmTableToLine(SmallTable()), "place");
  EXPECT_EQ(TableName(own), "the model's own");
  EXPECT_EQ(RhythmTableToLine(std::get<ReadTable>(own).table), RhythmTableToLine(SmallTable()));
}

TEST(TableFromWordOrFile, IsTheBuiltInTableOfAWordAndElseThatOfTheFile) {
  EXPECT_EQ(std::get<BuiltInTable>(TableFromWordOrFile("smoothed")), BuiltInTable::kSmoothed);
  const std::string path = std::string(GIRDLE_SOURCE_DIR) + "/data/ludewig2009.csv";
  const TableChoice read = TableFromWordOrFile(path);
  EXPECT_EQ(TableName(read), path);
  EXPECT_EQ(RhythmTableToLine(std::get<ReadTable>(read).table),
            RhythmTableToLine(BuiltInRhythmTable(BuiltInTable::kMeasured)));
}

}  // namespace
}  // namespace girdle::rhythm_choice_test
