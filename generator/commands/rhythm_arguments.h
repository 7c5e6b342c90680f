// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Options that all verbs share, and strict reading of numbers on the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "kinematics/shoulder_rhythm.h"

namespace girdle {

/// `--table`, `--interpolation`, `--closure` as given; empty where not given.
struct RhythmArguments {
  std::string table;
  std::string interpolation;
  std::string closure;
};

void AddRhythmArguments(CLI::App& verb, RhythmArguments& arguments);

/// Returns the options chosen, defaults where nothing was given. Throws InputError for an unknown
/// word, naming the known ones.
[[nodiscard]] RhythmOptions ChosenOptions(const RhythmArguments& arguments);

/// Returns the rhythm chosen: the table of `--table`, else the built-in one.
[[nodiscard]] ShoulderRhythm ChosenRhythm(const RhythmArguments& arguments);

/// Returns the number that `text` is. Throws InputError that names the option and gives an example.
[[nodiscard]] double NumberArgument(const std::string& option, const std::string& text);

}  // namespace girdle
