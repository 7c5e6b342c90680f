// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/table_arguments.h"

#include <string_view>

#include "commands/rhythm_arguments.h"
#include "commands/word_argument.h"
#include "text/input_error.h"

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
  std::vector<std::string_view> known(kCommandColumns.begin(), kCommandColumns.end());
  if (has_time) {
    known.insert(known.begin(), kTimeColumn);
  }
  return ReadNamedColumns(*arguments.columns, known);
}

GapReading ChosenGaps(const TableArguments& arguments, GapRule rule) {
  GapReading gaps = {rule};
  ChooseWord("--gaps", arguments.gaps, gaps.rule);
  if (arguments.bridged_rows) {
    gaps.bridged_rows = WholeNumberArgument("--bridge-gaps", *arguments.bridged_rows,
                                            {.least = 0, .most = kMostBridged, .example = 5});
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
