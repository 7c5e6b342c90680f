// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/rhythm_arguments.h"

#include "tables/built_in.h"
#include "tables/input_error.h"
#include "tables/number_text.h"
#include "tables/rhythm_table_csv.h"

namespace girdle {
namespace {

template <std::size_t N>
[[noreturn]] void FailUnknownWord(const std::string& option, const std::string& word,
                                  const std::array<std::string_view, N>& known) {
  std::string choices;
  for (const std::string_view name : known) {
    choices += (choices.empty() ? "" : ", ") + std::string(name);
  }
  throw InputError(option + " " + word + ": not known. Choose one of: " + choices);
}

}  // namespace

void AddRhythmArguments(CLI::App& verb, RhythmArguments& arguments) {
  verb.add_option("--table", arguments.table,
                  "Measured table as CSV instead of the built-in one (Ludewig et al. 2009)")
      ->type_name("FILE");
  verb.add_option("--interpolation", arguments.interpolation,
                  "How to interpolate: squad (default, as published) or slerp")
      ->type_name("WORD");
  verb.add_option("--closure", arguments.closure,
                  "Where GH comes from: table (default, as published)")
      ->type_name("WORD");
}

RhythmOptions ChosenOptions(const RhythmArguments& arguments) {
  RhythmOptions options;
  if (!arguments.interpolation.empty()) {
    const auto interpolation = InterpolationFromName(arguments.interpolation);
    if (!interpolation) {
      FailUnknownWord("--interpolation", arguments.interpolation, kInterpolationNames);
    }
    options.interpolation = *interpolation;
  }
  if (!arguments.closure.empty()) {
    const auto closure = ClosureFromName(arguments.closure);
    if (!closure) {
      FailUnknownWord("--closure", arguments.closure, kClosureNames);
    }
    options.closure = *closure;
  }
  return options;
}

ShoulderRhythm ChosenRhythm(const RhythmArguments& arguments) {
  const RhythmOptions options = ChosenOptions(arguments);
  return arguments.table.empty() ? ShoulderRhythm(BuiltInRhythmTable(), options)
                                 : ReadShoulderRhythm(arguments.table, options);
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
