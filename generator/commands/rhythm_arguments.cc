// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/rhythm_arguments.h"

#include <cmath>
#include <optional>

#include "anatomy/built_in_anatomy.h"
#include "commands/option_group.h"
#include "commands/word_argument.h"
#include "text/input_error.h"
#include "text/number_text.h"
#include "text/shown_text.h"

namespace girdle {
namespace {

// Returns the parts of the rhythm that the user chose, without the table.
RhythmChoice ChoiceOfWords(const RhythmArguments& arguments) {
  return {ChosenWord<Interpolation>("--interpolation", arguments.interpolation),
          ChosenWord<Closure>("--closure", arguments.closure),
          ChosenWord<Range>("--range", arguments.range)};
}

}  // namespace

void AddTableArgument(CLI::App& verb, std::string& table) {
  verb.add_option("--table", table,
                  "Table: measured (Ludewig et al. 2009), smoothed (the same without the steps "
                  "where people dropped out; default with smooth), or a CSV of your own")
      ->type_name("WORD|FILE");
}

std::string TableFile(const std::string& table) {
  return FromName<BuiltInTable>(table) ? std::string() : table;
}

void AddAxialFromArgument(CLI::App& verb, std::string& axial_from, const std::string& what) {
  verb.add_option("--axial-from", axial_from,
                  what +
                      ": rhythm (its own turn), isb (third angle of Y-X'-Y'') or swing (one "
                      "humerus for a direction, straight up as well)")
      ->type_name("WORD");
}

void AddRhythmArguments(CLI::App& verb, RhythmArguments& arguments) {
  const OptionGroup group(verb, "The rhythm");
  AddTableArgument(verb, arguments.table);
  verb.add_option("--interpolation", arguments.interpolation,
                  "smooth (default), squad (as published) or slerp")
      ->type_name("WORD");
  verb.add_option("--closure", arguments.closure,
                  "exact (default: the arm points where it is told to) or table (as published)")
      ->type_name("WORD");
  verb.add_option("--range", arguments.range,
                  "Outside the table: whole (default with smooth and exact: all that an arm can "
                  "reach) or clamp (the table's nearest elevation and plane)")
      ->type_name("WORD");
}

void ExpectNoRhythm(const RhythmArguments& arguments, const std::string& reason) {
  for (const auto& [option, text] :
       {std::pair("--table", &arguments.table),
        std::pair("--interpolation", &arguments.interpolation),
        std::pair("--closure", &arguments.closure), std::pair("--range", &arguments.range)}) {
    if (!text->empty()) {
      throw InputError(std::string(option) + " " + *text + ": " + reason);
    }
  }
}

RhythmChoice ChoiceFrom(const RhythmArguments& arguments) {
  RhythmChoice choice = ChoiceOfWords(arguments);
  if (!arguments.table.empty()) {
    choice.table = TableFromWordOrFile(arguments.table);
  }
  return choice;
}

ShoulderRhythm ChosenRhythm(const RhythmArguments& arguments) {
  return ChosenRhythm(Resolve(ChoiceFrom(arguments)));
}

ShoulderRhythm ChosenRhythm(const ResolvedRhythm& resolved) {
  return MakeRhythm(resolved, BuiltInAnatomy().ranges);
}

void ExpectDerivatives(const std::string& option, const RhythmArguments& arguments) {
  const Interpolation interpolation = OptionsOf(ChoiceOfWords(arguments)).interpolation;
  if (interpolation != Interpolation::kSmooth) {
    throw InputError(option + ": the interpolation " + std::string(Name(interpolation)) +
                     " has no derivatives. Choose --interpolation smooth");
  }
}

double NumberArgument(const std::string& option, const std::string& text) {
  const std::optional<double> number = FiniteNumber(text);
  if (!number) {
    throw InputError(option + " '" + ShortText(text) + "': not a finite number. Give one such as " +
                     option + " 22.5");
  }
  return *number;
}

std::size_t WholeNumberArgument(const std::string& option, const std::string& text,
                                const WholeNumbers& numbers) {
  const std::optional<double> number = FiniteNumber(text);
  if (!number || *number < static_cast<double>(numbers.least) ||
      *number > static_cast<double>(numbers.most) || *number != std::floor(*number)) {
    throw InputError(option + " '" + text + "': not a whole number from " +
                     std::to_string(numbers.least) + " to " + std::to_string(numbers.most) +
                     ". Give one such as " + option + " " + std::to_string(numbers.example));
  }
  return static_cast<std::size_t>(*number);
}

}  // namespace girdle
