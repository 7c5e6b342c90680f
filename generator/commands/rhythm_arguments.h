// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Options that all verbs share, and strict reading of numbers on the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
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

/// Returns the file that `--table` names. Empty if `--table` is a word or is not given.
[[nodiscard]] std::string TableFile(const std::string& table);

/// Throws InputError for the first option of the rhythm that is given; `reason` ends the message.
void ExpectNoRhythm(const RhythmArguments& arguments, const std::string& reason);

/// Returns the parts of the rhythm that the user chose, and only those. Throws InputError for an
/// unknown word, with the known ones, and for a table that is neither a word nor a file with a
/// table.
[[nodiscard]] RhythmChoice ChoiceFrom(const RhythmArguments& arguments);

/// Returns the chosen rhythm, in the joint ranges of the built-in anatomy. Throws as ChoiceFrom,
/// and if the options exclude each other.
[[nodiscard]] ShoulderRhythm ChosenRhythm(const RhythmArguments& arguments);
[[nodiscard]] ShoulderRhythm ChosenRhythm(const ResolvedRhythm& resolved);

/// Throws InputError that names `option`, which needs derivatives, if the chosen interpolation has
/// none.
void ExpectDerivatives(const std::string& option, const RhythmArguments& arguments);

/// Returns the number that `text` is. Throws InputError that names the option and gives an example.
[[nodiscard]] double NumberArgument(const std::string& option, const std::string& text);

/// The whole numbers that an option takes, and one that a message shows.
struct WholeNumbers {
  std::size_t least;
  std::size_t most;
  std::size_t example;
};

/// Returns the number that `text` is. Throws InputError that names the option, the numbers that it
/// takes and the example.
[[nodiscard]] std::size_t WholeNumberArgument(const std::string& option, const std::string& text,
                                              const WholeNumbers& numbers);

}  // namespace girdle
