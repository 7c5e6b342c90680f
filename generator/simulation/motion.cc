// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "simulation/motion.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "names/model_names.h"
#include "text/csv.h"
#include "text/number_text.h"

namespace girdle {
namespace {

ArmCommand Between(const ArmCommand& a, const ArmCommand& b, double t) {
  const auto mix = [t](double from, double to) { return from + t * (to - from); };
  return {mix(a.elevation_rad, b.elevation_rad),
          mix(a.plane_rad, b.plane_rad),
          mix(a.axial_rad, b.axial_rad),
          mix(a.shrug_rad, b.shrug_rad),
          mix(a.protraction_rad, b.protraction_rad),
          a.axial_from};
}

struct TimedCommand {
  double time_s;
  ArmCommand command;
};

ArmCommand AlongRows(const std::vector<TimedCommand>& rows, double time_s) {
  const auto next =
      std::upper_bound(rows.begin(), rows.end(), time_s,
                       [](double time, const TimedCommand& row) { return time < row.time_s; });
  if (next == rows.begin()) {
    return rows.front().command;
  }
  if (next == rows.end()) {
    return rows.back().command;
  }
  const TimedCommand& previous = *(next - 1);
  return Between(previous.command, next->command,
                 (time_s - previous.time_s) / (next->time_s - previous.time_s));
}

}  // namespace

CommandRate RateOf(const Motion& motion, double time_s, double step_s) {
  const ArmCommand now = motion.command(time_s);
  const ArmCommand next = motion.command(time_s + step_s);
  return {(next.elevation_rad - now.elevation_rad) / step_s,
          (next.plane_rad - now.plane_rad) / step_s, (next.axial_rad - now.axial_rad) / step_s};
}

Motion ReachingMotion(std::string name, const ArmCommand& from, const ArmCommand& to,
                      double duration_s) {
  // s = 10 t^3 - 15 t^4 + 6 t^5: velocity and acceleration are 0 at both ends.
  return {std::move(name), duration_s, [from, to, duration_s](double time_s) {
            const double t = std::clamp(time_s / duration_s, 0.0, 1.0);
            return Between(from, to, t * t * t * (10 + t * (-15 + 6 * t)));
          }};
}

Motion ReadMotion(std::istream& in, const std::string& name, AxialFrom axial_from) {
  CsvReader csv(in, name);
  csv.ExpectOnlyColumns(
      {"time_s", "elevation_deg", "plane_deg", "axial_deg", "shrug_deg", "protraction_deg"});
  const std::size_t time = csv.Column("time_s");
  const std::size_t elevation = csv.Column("elevation_deg");
  const std::size_t plane = csv.Column("plane_deg");
  const auto optional_column = [&csv](const char* name_of_column) {
    return csv.HasColumn(name_of_column) ? std::optional(csv.Column(name_of_column)) : std::nullopt;
  };
  const auto axial = optional_column("axial_deg");
  const auto shrug = optional_column("shrug_deg");
  const auto protraction = optional_column("protraction_deg");
  std::vector<TimedCommand> rows;
  while (csv.Next()) {
    const auto angle_rad = [&csv](std::size_t column) {
      return RadiansFromDegrees(csv.NumberWithin(column, -kFullCircle_deg, kFullCircle_deg));
    };
    const auto offset_rad = [&csv](const std::optional<std::size_t>& column,
                                   const CoordinateRange& range) {
      return column ? RadiansFromDegrees(csv.NumberWithin(*column, TypedDegrees(range.lower_rad),
                                                          TypedDegrees(range.upper_rad)))
                    : 0;
    };
    const double time_s = csv.NumberWithin(time, 0, kLongestMotion_s);
    if (!rows.empty() && time_s <= rows.back().time_s) {
      csv.Fail("time_s is " + NumberText(time_s) + ", which does not increase (previous " +
               NumberText(rows.back().time_s) + ")");
    }
    rows.push_back({time_s,
                    {angle_rad(elevation), angle_rad(plane), axial ? angle_rad(*axial) : 0,
                     offset_rad(shrug, kShrugRange), offset_rad(protraction, kProtractionRange),
                     axial ? axial_from : AxialFrom::kRhythm}});
  }
  if (rows.empty()) {
    csv.Fail("the motion has no rows");
  }
  const double duration_s = rows.back().time_s;
  return {name, duration_s,
          [rows = std::move(rows)](double time_s) { return AlongRows(rows, time_s); }};
}

}  // namespace girdle
