// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "motions/command_columns.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "motions/axial_names.h"
#include "names/model_names.h"
#include "text/near_names.h"
#include "text/number_text.h"
#include "text/small_letters.h"

namespace girdle {
namespace {

// Returns the angle that `read` gives for a number of a row. An error of `read` names the row.
template <typename Reading>
double AngleOf(const CsvRows& row, std::size_t column, double number, const Reading& read) {
  try {
    return RadiansFromDegrees(read());
  } catch (const std::invalid_argument& error) {
    row.Fail(row.ColumnName(column) + " is " + NumberText(number) + ": " + error.what());
  }
}

bool IsInRadians(const std::string& column) {
  const std::string small = InSmallLetters(column);
  return small.find("rad") != std::string::npos && small.find("radi") != 0;
}

// Returns the fix for a known name with radians as its unit: only an option gives the unit.
std::string RadiansMend(const std::string& meant, bool has_degrees,
                        const std::optional<AngleUnit>& unit) {
  if (unit == AngleUnit::kRadian) {
    return "Name it '" + meant + "', whatever the unit" +
           (has_degrees ? ", if all angles of the file are in radians" : "");
  }
  return has_degrees || unit
             ? "All angles of a file have one unit: write these in degrees, too, as '" + meant +
                   "', or all in radians with --angles rad"
             : "Name it '" + meant + "', whatever the unit, and give --angles rad";
}

// Throws if a known name has radians as its unit.
void ExpectNoRadianNames(const CsvReader& csv, const std::vector<std::string_view>& known,
                         const std::optional<AngleUnit>& unit) {
  const auto has_column = [&](std::string_view name) { return csv.HasColumn(std::string(name)); };
  const bool has_degrees = std::any_of(known.begin(), known.end(), has_column);
  for (const std::string& column : csv.columns()) {
    const std::string stem = PlainStem(column);
    const auto meant = std::find_if(known.begin(), known.end(), [&](std::string_view name) {
      return name.ends_with("_deg") && PlainStem(name) == stem;
    });
    if (meant == known.end() || !IsInRadians(column)) {
      continue;
    }
    csv.Fail("column '" + column + "' is not known. " +
             (has_column(*meant)
                  ? "'" + std::string(*meant) + "' is there, too: leave one of them out"
                  : RadiansMend(std::string(*meant), has_degrees, unit)));
  }
}

}  // namespace

CommandColumns::CommandColumns(const CsvReader& csv, const AngleReading& reading,
                               const std::vector<std::string_view>& further)
    : reading_(reading) {
  std::vector<std::string_view> known = {kElevationColumn, kPlaneColumn, kAxialColumn, kShrugColumn,
                                         kProtractionColumn};
  known.insert(known.end(), further.begin(), further.end());
  ExpectNoRadianNames(csv, known, reading.unit);
  csv.ExpectNoneNearly(known);
  elevation_ = csv.Column(kElevationColumn);
  plane_ = csv.Column(kPlaneColumn);
  FindAxial(csv);
  const auto add_offset = [&](const char* name, double ArmCommand::*angle_rad,
                              const CoordinateRange& range) {
    if (csv.HasColumn(name)) {
      offsets_.push_back({csv.Column(name), angle_rad, TypedDegrees(range.lower_rad),
                          TypedDegrees(range.upper_rad)});
    }
  };
  add_offset(kShrugColumn, &ArmCommand::shrug_rad, kShrugRange);
  add_offset(kProtractionColumn, &ArmCommand::protraction_rad, kProtractionRange);
}

void CommandColumns::FindAxial(const CsvReader& csv) {
  if (csv.HasColumn(kAxialColumn)) {
    axial_ = csv.Column(kAxialColumn);
    return;
  }
  const std::vector<std::string>& names = csv.columns();
  const auto meant = std::find_if(names.begin(), names.end(), MeansAxialTurn);
  if (meant != names.end()) {
    csv.Fail("column '" + *meant + "' is not known. Did you mean '" + kAxialColumn +
             "', in which internal rotation is positive? Correct its name, and give --axial-from "
             "isb if it is ISB's third angle; or give it a name that is less alike");
  }
  if (reading_.must_have_axial) {
    csv.Fail("--axial-from " + std::string(Name(reading_.axial_from)) +
             ": no axial turn is given. Add the column " + kAxialColumn + ", or omit --axial-from");
  }
}

std::optional<AxialFrom> CommandColumns::axial_from() const noexcept {
  return axial_ ? std::optional(reading_.axial_from) : std::nullopt;
}

double CommandColumns::Degrees(double number) const noexcept {
  return reading_.unit == AngleUnit::kRadian ? DegreesFromRadians(number) : number;
}

double CommandColumns::OffsetRead_deg(const CsvRows& row, const Offset& offset) const {
  const double number = row.Number(offset.index);
  const bool is_radians = reading_.unit == AngleUnit::kRadian;
  // In degrees as typed, so that the bounds themselves are accepted in radians.
  const double offset_deg = is_radians ? TypedDegrees(number) : number;
  if (offset_deg < offset.lower_deg || offset_deg > offset.upper_deg) {
    row.Fail(row.ColumnName(offset.index) + " is " + NumberText(number) + ", expected " +
             NumberText(offset.lower_deg) + " to " + NumberText(offset.upper_deg) +
             (is_radians ? " degrees" : ""));
  }
  return offset_deg;
}

ArmCommand CommandColumns::Read(const CsvRows& row, const ArmCommand& otherwise,
                                AngleSpan& span) const {
  ArmCommand command = otherwise;
  const double elevation = row.Number(elevation_);
  const double plane = row.Number(plane_);
  command.elevation_rad = AngleOf(row, elevation_, elevation, [&] {
    return ElevationRead_deg(Degrees(elevation), reading_.convention,
                             axial_.has_value() || reading_.has_axial_option);
  });
  command.plane_rad = AngleOf(row, plane_, plane, [&] { return PlaneRead_deg(Degrees(plane)); });
  if (axial_) {
    const double axial = row.Number(*axial_);
    command.axial_rad = AngleOf(row, *axial_, axial, [&] { return AxialRead_deg(Degrees(axial)); });
    command.axial_from = reading_.axial_from;
  }
  for (const Offset& offset : offsets_) {
    command.*offset.angle_rad = RadiansFromDegrees(OffsetRead_deg(row, offset));
  }
  if (!reading_.unit) {
    span.Add(elevation, plane);
  }
  return command;
}

}  // namespace girdle
