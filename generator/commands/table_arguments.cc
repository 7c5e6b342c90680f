// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/table_arguments.h"

#include <cmath>
#include <string_view>

#include "commands/word_argument.h"
#include "text/input_error.h"
#include "text/number_text.h"

namespace girdle {

void AddTableArguments(CLI::App& verb, TableArguments& arguments, GapRule rule) {
  verb.add_option("--columns", arguments.columns,
                  "Columns of --in with other names than the known ones, such as "
                  "elevation_deg=theta,plane_deg=psi")
      ->type_name("KNOWN=NAME,...");
  verb.add_option("--gaps", arguments.gaps,
                  "Rows of --in with a missing angle (empty, NaN, NA): keep or refuse (default " +
                      std::string(Name(rule)) +
                      (rule == GapRule::kKeep ? "; their answer is empty)"
                                              : "); the motion passes over kept ones"))
      ->type_name("WORD");
  verb.add_option("--bridge-gaps", arguments.bridged_rows,
                  "Bridge gaps of at most so many rows, 0 to " + std::to_string(kMostBridged) +
                      " (default 0), as a motion goes from row to row")
      ->type_name("ROWS");
}

std::vector<NamedColumn> ChosenColumns(const TableArguments& arguments, bool has_time) {
  if (!arguments.columns) {
    return {};
  }
  std::vector<std::string_view> known = {kElevationColumn, kPlaneColumn, kAxialColumn, kShrugColumn,
                                         kProtractionColumn};
  if (has_time) {
    known.insert(known.begin(), kTimeColumn);
  }
  return ReadNamedColumns(*arguments.columns, known);
}

GapReading ChosenGaps(const TableArguments& arguments, GapRule rule) {
  GapReading gaps = {rule};
  ChooseWord("--gaps", arguments.gaps, gaps.rule);
  if (arguments.bridged_rows) {
    const std::string& text = *arguments.bridged_rows;
    const std::optional<double> number = FiniteNumber(text);
    if (!number || *number < 0 || *number > static_cast<double>(kMostBridged) ||
        *number != std::floor(*number)) {
      throw InputError("--bridge-gaps '" + text + "': not a whole number from 0 to " +
                       std::to_string(kMostBridged) + ". Give one such as --bridge-gaps 5");
    }
    gaps.bridged_rows = static_cast<std::size_t>(*number);
  }
  return gaps;
}

void ExpectNoTable(const TableArguments& arguments) {
  const char* option = nullptr;
  if (arguments.columns) {
    option = "--columns";
  } else if (!arguments.gaps.empty()) {
    option = "--gaps";
  } else if (arguments.bridged_rows) {
    option = "--bridge-gaps";
  }
  if (option != nullptr) {
    throw InputError(std::string(option) +
                     " is about the table of --in. Give --in FILE, or omit it");
  }
}

}  // namespace girdle
