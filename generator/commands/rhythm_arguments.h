// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Options that all verbs share, and strict reading of numbers on the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "kinematics/shoulder_rhythm.h"
#include "rhythm_tables/built_in_tables.h"

namespace girdle {

/// `--table`, `--interpolation`, `--closure`, `--range` as given; empty where not given.
struct RhythmArguments {
  std::string table;
  std::string interpolation;
  std::string closure;
  std::string range;
};

void AddRhythmArguments(CLI::App& verb, RhythmArguments& arguments);

/// `--table` alone, for verbs that need no rhythm, and the table that it names, the default
/// rhythm's if it is empty. Throws InputError if it is neither a word nor a table.
void AddTableArgument(CLI::App& verb, std::string& table);
[[nodiscard]] RhythmTable ChosenTable(const std::string& table);

/// Returns the options chosen, defaults where nothing was given. Throws InputError for an unknown
/// word, naming the known ones.
[[nodiscard]] RhythmOptions ChosenOptions(const RhythmArguments& arguments);

/// Returns the built-in table chosen, by its word or by default; nothing if it is a file.
[[nodiscard]] std::optional<BuiltInTable> ChosenBuiltInTable(const RhythmArguments& arguments);

/// Returns the rhythm chosen, in the joint ranges of the built-in anatomy.
[[nodiscard]] ShoulderRhythm ChosenRhythm(const RhythmArguments& arguments);

/// Throws InputError, which says how to mend it, if the interpolation chosen cannot give `--rates`.
void ExpectRates(const RhythmArguments& arguments);

/// Returns the number that `text` is. Throws InputError that names the option and gives an example.
[[nodiscard]] double NumberArgument(const std::string& option, const std::string& text);

}  // namespace girdle
