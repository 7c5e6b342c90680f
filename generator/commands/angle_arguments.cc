// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/angle_arguments.h"

#include <stdexcept>

#include "commands/rhythm_arguments.h"
#include "commands/word_argument.h"
#include "text/input_error.h"

namespace girdle {
namespace {

// Returns the angle that `read` gives for the typed number. An error of `read` names the option.
template <typename Reading>
double AngleOf(const std::string& option, const std::string& text, const Reading& read) {
  const double typed_deg = NumberArgument(option, text);
  try {
    return read(typed_deg);
  } catch (const std::invalid_argument& error) {
    throw InputError(option + " " + text + ": " + error.what());
  }
}

}  // namespace

void AddConventionArgument(CLI::App& verb, AngleArguments& arguments) {
  verb.add_option("--convention", arguments.convention,
                  "How the angles are written: girdle (default; the elevation of a raised arm is "
                  "positive) or isb (negative, as ISB's Y-X'-Y'' has it, and --axial-from isb)")
      ->type_name("WORD");
}

void AddUnitArgument(CLI::App& verb, AngleArguments& arguments) {
  verb.add_option("--angles", arguments.unit,
                  "Unit of the angles of the file: deg (default) or rad; required if the numbers "
                  "look like radians")
      ->type_name("WORD");
}

AngleReading ReadingFrom(const AngleArguments& arguments) {
  AngleReading reading;
  ChooseWord("--convention", arguments.convention, reading.convention);
  reading.unit = ChosenWord<AngleUnit>("--angles", arguments.unit);
  return reading;
}

std::optional<AxialFrom> AxialFromOf(const std::string& axial_from,
                                     const AngleArguments& arguments) {
  const std::optional<AxialFrom> said = ChosenWord<AxialFrom>("--axial-from", axial_from);
  if (!said && ReadingFrom(arguments).convention == AngleConvention::kIsb) {
    return AxialFrom::kIsb;
  }
  return said;
}

void ExpectNoUnit(const AngleArguments& arguments) {
  if (!arguments.unit.empty()) {
    throw InputError("--angles " + arguments.unit +
                     ": says the unit of a file; angles of options are degrees. Omit it");
  }
}

double ElevationArgument_deg(const std::string& option, const std::string& text,
                             AngleConvention convention, bool has_axial) {
  return AngleOf(option, text, [convention, has_axial](double elevation_deg) {
    return ElevationRead_deg(elevation_deg, convention, has_axial);
  });
}

double PlaneArgument_deg(const std::string& option, const std::string& text) {
  return AngleOf(option, text, PlaneRead_deg);
}

double AxialArgument_deg(const std::string& option, const std::string& text) {
  return AngleOf(option, text, AxialRead_deg);
}

}  // namespace girdle
