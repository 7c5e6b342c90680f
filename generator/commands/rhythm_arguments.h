// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Options that all verbs share, and strict reading of numbers on the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "kinematics/shoulder_rhythm.h"
#include "rhythm_tables/rhythm_choice.h"

namespace girdle {

/// `--table`, `--interpolation`, `--closure`, `--range` as given; empty where not given.
struct RhythmArguments {
  std::string table{};
  std::string interpolation{};
  std::string closure{};
  std::string range{};
};

void AddRhythmArguments(CLI::App& verb, RhythmArguments& arguments);

/// `--axial-from`, for verbs that take an axial turn; `what` begins its help.
void AddAxialFromArgument(CLI::App& verb, std::string& axial_from, const std::string& what);

/// `--table` alone, for verbs that need no rhythm.
void AddTableArgument(CLI::App& verb, std::string& table);

/// Returns the file that a `--table` names; empty for a word, and where it is not given.
[[nodiscard]] std::string TableFile(const std::string& table);

/// Returns what the user said of the rhythm, and only that. Throws InputError for an unknown word,
/// naming the known ones, and for a table that is neither a word nor a file with a table.
[[nodiscard]] RhythmChoice ChoiceFrom(const RhythmArguments& arguments);

/// Returns the rhythm chosen, in the joint ranges of the built-in anatomy. Throws as ChoiceFrom, or
/// if the options do not go together.
[[nodiscard]] ShoulderRhythm ChosenRhythm(const RhythmArguments& arguments);
[[nodiscard]] ShoulderRhythm ChosenRhythm(const ResolvedRhythm& resolved);

/// Throws InputError that names `option`, which needs derivatives, if the chosen interpolation has
/// none.
void ExpectDerivatives(const std::string& option, const RhythmArguments& arguments);

/// Returns the number that `text` is. Throws InputError that names the option and gives an example.
[[nodiscard]] double NumberArgument(const std::string& option, const std::string& text);

}  // namespace girdle
