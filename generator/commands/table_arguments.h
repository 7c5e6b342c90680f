// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Options that say how a table of arm commands is read: names of its columns, and gaps.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "motions/column_names.h"
#include "motions/gap_reading.h"

namespace girdle {

/// `--columns`, `--gaps` and `--bridge-gaps` as given; empty where not given.
struct TableArguments {
  std::optional<std::string> columns;
  std::string gaps;
  std::optional<std::string> bridged_rows;
};

/// Adds the options. `rule` is the rule of gaps if `--gaps` is not given.
void AddTableArguments(CLI::App& verb, TableArguments& arguments, GapRule rule);

/// Returns the names that `--columns` gives to columns of commands, and to times if `has_time`.
/// Throws InputError as ReadNamedColumns does.
[[nodiscard]] std::vector<NamedColumn> ChosenColumns(const TableArguments& arguments,
                                                     bool has_time);

/// Returns how gaps are read. `rule` is the rule if `--gaps` is not given. Throws InputError for an
/// unknown word and for a wrong number.
[[nodiscard]] GapReading ChosenGaps(const TableArguments& arguments, GapRule rule);

/// Throws InputError if one of the options is given where no table is read.
void ExpectNoTable(const TableArguments& arguments);

}  // namespace girdle
