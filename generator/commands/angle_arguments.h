// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Angles of the arm given on the command line, and options for the unit and the convention of
/// angles.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "motions/arm_angles.h"

namespace girdle {

/// `--convention` and `--angles` as given; empty where not given.
struct AngleArguments {
  std::string convention{};
  std::string unit{};
};

void AddConventionArgument(CLI::App& verb, AngleArguments& arguments);
/// `--angles`, for verbs that read files.
void AddUnitArgument(CLI::App& verb, AngleArguments& arguments);

/// Returns the unit and the convention that the options choose. Throws InputError for an unknown
/// word.
[[nodiscard]] AngleReading ReadingFrom(const AngleArguments& arguments);

/// Returns the zero that axial turns are counted from: the one of `--axial-from`, else ISB's zero
/// with `--convention isb`, else nothing. Throws InputError for an unknown word.
[[nodiscard]] std::optional<AxialFrom> AxialFromOf(const std::string& axial_from,
                                                   const AngleArguments& arguments);

/// Throws InputError if `--angles` is given where no file is read.
void ExpectNoUnit(const AngleArguments& arguments);

/// Return an angle of an option as ElevationRead_deg, PlaneRead_deg and AxialRead_deg do; `text` is
/// what was typed. Throw InputError that names option and text.
[[nodiscard]] double ElevationArgument_deg(const std::string& option, const std::string& text,
                                           AngleConvention convention, bool has_axial = false);
[[nodiscard]] double PlaneArgument_deg(const std::string& option, const std::string& text);
[[nodiscard]] double AxialArgument_deg(const std::string& option, const std::string& text);

}  // namespace girdle
