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
#include "text/number_text.h"
#include "text/shown_text.h"

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

// Returns the known names of the columns of commands, then further ones.
std::vector<std::string_view> KnownNames(const std::vector<std::string_view>& further) {
  std::vector<std::string_view> known(kCommandColumns.begin(), kCommandColumns.end());
  known.insert(known.end(), further.begin(), further.end());
  return known;
}

}  // namespace

CommandColumns::CommandColumns(const CsvReader& csv, const AngleReading& reading,
                               const std::vector<NamedColumn>& given,
                               const std::vector<std::string_view>& further)
    : reading_(reading), names_(csv, KnownNames(further), given) {
  names_.ExpectNoneNearly(reading.unit.has_value(), reading.unit == AngleUnit::kRadian);
  elevation_ = names_.Column(kElevationColumn);
  plane_ = names_.Column(kPlaneColumn);
  FindAxial(csv);
  const auto add_offset = [&](const char* name, double ArmCommand::*angle_rad,
                              const CoordinateRange& range) {
    if (const std::optional<std::size_t> column = names_.Find(name)) {
      offsets_.push_back(
          {*column, angle_rad, TypedDegrees(range.lower_rad), TypedDegrees(range.upper_rad)});
    }
  };
  add_offset(kShrugColumn, &ArmCommand::shrug_rad, kShrugRange);
  add_offset(kProtractionColumn, &ArmCommand::protraction_rad, kProtractionRange);
}

void CommandColumns::FindAxial(const CsvReader& csv) {
  axial_ = names_.Find(kAxialColumn);
  if (axial_) {
    if (names_.axial() != AxialMeaning::kAsRead) {
      if (reading_.must_have_axial && reading_.axial_from != AxialFrom::kIsb) {
        csv.Fail("--axial-from " + std::string(Name(reading_.axial_from)) + ": '" +
                 csv.columns()[*axial_] + "' counts from isb. Omit --axial-from");
      }
      reading_.axial_from = AxialFrom::kIsb;
    }
    return;
  }
  const std::vector<std::string>& names = csv.columns();
  const auto meant = std::find_if(names.begin(), names.end(), MeansAxialTurn);
  if (meant != names.end()) {
    csv.Fail(
        "column '" + ShortText(*meant) + "' is not known. Did you mean '" + kAxialColumn +
        "', in which internal rotation is positive? Correct its name or give " +
        ColumnsOption(kAxialColumn, *meant) +
        ", and give --axial-from isb if it is ISB's third angle. If it is something else, give "
        "it a name that is less alike");
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

std::optional<double> CommandColumns::OffsetRead_deg(const CsvRows& row,
                                                     const Offset& offset) const {
  const std::optional<double> number = row.NumberOrGap(offset.index);
  if (!number) {
    return std::nullopt;
  }
  const bool is_radians = reading_.unit == AngleUnit::kRadian;
  // In degrees as typed, so that the bounds themselves are accepted in radians.
  const double offset_deg = is_radians ? TypedDegrees(*number) : *number;
  if (offset_deg < offset.lower_deg || offset_deg > offset.upper_deg) {
    row.Fail(row.ColumnName(offset.index) + " is " + NumberText(*number) + ", expected " +
             NumberText(offset.lower_deg) + " to " + NumberText(offset.upper_deg) +
             (is_radians ? " degrees" : ""));
  }
  return offset_deg;
}

std::optional<ArmCommand> CommandColumns::Read(const CsvRows& row, const ArmCommand& otherwise,
                                               AngleSpan& span) const {
  ArmCommand command = otherwise;
  // All fields of a row with a gap are read: another field may have an error.
  const std::optional<double> elevation = row.NumberOrGap(elevation_);
  const std::optional<double> plane = row.NumberOrGap(plane_);
  if (elevation) {
    command.elevation_rad = AngleOf(row, elevation_, *elevation, [&] {
      return ElevationRead_deg(Degrees(*elevation), reading_.convention,
                               axial_.has_value() || reading_.has_axial_option);
    });
  }
  if (plane) {
    command.plane_rad =
        AngleOf(row, plane_, *plane, [&] { return PlaneRead_deg(Degrees(*plane)); });
  }
  bool has_gap = !elevation || !plane;
  if (axial_) {
    const std::optional<double> axial = row.NumberOrGap(*axial_);
    has_gap |= !axial;
    if (axial) {
      command.axial_rad =
          AngleOf(row, *axial_, *axial, [&] { return AxialRead_deg(Degrees(*axial)); });
      command.axial_rad -= names_.axial() == AxialMeaning::kIsbWithPlane ? command.plane_rad : 0;
    }
    command.axial_from = reading_.axial_from;
  }
  for (const Offset& offset : offsets_) {
    const std::optional<double> offset_deg = OffsetRead_deg(row, offset);
    has_gap |= !offset_deg;
    if (offset_deg) {
      command.*offset.angle_rad = RadiansFromDegrees(*offset_deg);
    }
  }
  if (has_gap) {
    return std::nullopt;
  }
  if (!reading_.unit) {
    span.Add(*elevation, *plane);
  }
  return command;
}

std::string CommandColumns::GapText(const CsvRows& row) const {
  std::vector<std::size_t> columns = {elevation_, plane_};
  if (axial_) {
    columns.push_back(*axial_);
  }
  for (const Offset& offset : offsets_) {
    columns.push_back(offset.index);
  }
  const auto gap = std::find_if(columns.begin(), columns.end(),
                                [&row](std::size_t column) { return row.IsGap(column); });
  const std::string_view field = row.Field(*gap);
  return ShortText(row.ColumnName(*gap)) + " is " +
         (field.empty() ? "empty" : "'" + std::string(field) + "'") + ", a gap";
}

}  // namespace girdle
