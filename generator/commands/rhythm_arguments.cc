// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/rhythm_arguments.h"

#include <fstream>
#include <optional>
#include <stdexcept>

#include "anatomy/built_in_anatomy.h"
#include "commands/word_argument.h"
#include "rhythm_tables/rhythm_table_csv.h"
#include "text/input_error.h"
#include "text/number_text.h"
#include "text/text_file.h"

namespace girdle {

void AddTableArgument(CLI::App& verb, std::string& table) {
  verb.add_option("--table", table,
                  "Table: measured (Ludewig et al. 2009), destepped (the same without the steps "
                  "where people dropped out; default with smooth), or a CSV of your own")
      ->type_name("WORD|FILE");
}

RhythmTable ChosenTable(const std::string& table) {
  if (table.empty()) {
    return BuiltInRhythmTable(DefaultTable(RhythmOptions{}.interpolation));
  }
  if (const std::optional<BuiltInTable> built_in = BuiltInTableFromName(table)) {
    return BuiltInRhythmTable(*built_in);
  }
  std::ifstream file = OpenTextFile(table);
  return ReadRhythmTable(file, table);
}

void AddRhythmArguments(CLI::App& verb, RhythmArguments& arguments) {
  AddTableArgument(verb, arguments.table);
  verb.add_option("--interpolation", arguments.interpolation,
                  "smooth (default), squad (as published) or slerp")
      ->type_name("WORD");
  verb.add_option("--closure", arguments.closure,
                  "exact (default: the arm points where it is told to) or table (as published)")
      ->type_name("WORD");
  verb.add_option("--range", arguments.range,
                  "Outside the table: whole (default with smooth and exact: all that an arm can "
                  "reach) or clamp (the table's nearest point)")
      ->type_name("WORD");
}

RhythmOptions ChosenOptions(const RhythmArguments& arguments) {
  RhythmOptions options;
  ChooseWord("--interpolation", arguments.interpolation, kInterpolationNames,
             options.interpolation);
  ChooseWord("--closure", arguments.closure, kClosureNames, options.closure);
  if (!arguments.range.empty()) {
    ChooseWord("--range", arguments.range, kRangeNames, options.range.emplace());
  }
  return options;
}

std::optional<BuiltInTable> ChosenBuiltInTable(const RhythmArguments& arguments) {
  return arguments.table.empty() ? DefaultTable(ChosenOptions(arguments).interpolation)
                                 : BuiltInTableFromName(arguments.table);
}

ShoulderRhythm ChosenRhythm(const RhythmArguments& arguments) {
  const RhythmOptions options = ChosenOptions(arguments);
  const JointRanges ranges = BuiltInAnatomy().ranges;
  const std::optional<BuiltInTable> built_in = ChosenBuiltInTable(arguments);
  if (!built_in) {
    return ReadShoulderRhythm(arguments.table, options, ranges);
  }
  try {
    return ShoulderRhythm(BuiltInRhythmTable(*built_in), options, ranges);
  } catch (const std::invalid_argument& error) {
    throw InputError("these options do not go together: " + std::string(error.what()));
  }
}

void ExpectRates(const RhythmArguments& arguments) {
  const Interpolation interpolation = ChosenOptions(arguments).interpolation;
  if (interpolation != Interpolation::kSmooth) {
    throw InputError("--rates: the interpolation " + std::string(Name(interpolation)) +
                     " has no derivatives. Choose --interpolation smooth");
  }
}

double NumberArgument(const std::string& option, const std::string& text) {
  const std::optional<double> number = FiniteNumber(text);
  if (!number) {
    throw InputError(option + " '" + text + "': not a finite number. Give one such as " + option +
                     " 22.5");
  }
  return *number;
}

}  // namespace girdle
