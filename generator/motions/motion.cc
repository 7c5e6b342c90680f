// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "motions/motion.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "motions/angle_span.h"
#include "motions/arm_path.h"
#include "motions/command_columns.h"
#include "text/csv.h"
#include "text/input_error.h"
#include "text/number_text.h"

namespace girdle {
namespace {

// Returns the command at a share of the straight line between the numbers of two commands.
ArmCommand StraightBetween(const ArmCommand& a, const ArmCommand& b, double share) noexcept {
  return {Between(a.elevation_rad, b.elevation_rad, share),
          Between(a.plane_rad, b.plane_rad, share),
          Between(a.axial_rad, b.axial_rad, share),
          Between(a.shrug_rad, b.shrug_rad, share),
          Between(a.protraction_rad, b.protraction_rad, share),
          a.axial_from};
}

// The times of successive rows.
class RowTimes {
 public:
  RowTimes(const CsvReader& csv, std::size_t column, double longest_s)
      : csv_(csv), column_(column), longest_s_(longest_s) {}

  // Returns the time of the current row, counted from the first row.
  double Next() {
    const double stamp_s = csv_.Number(column_);
    if (previous_s_ && stamp_s <= *previous_s_) {
      csv_.Fail(csv_.columns()[column_] + " is " + NumberText(stamp_s) +
                ", which does not increase (previous " + NumberText(*previous_s_) + ")");
    }
    first_s_ = previous_s_ ? first_s_ : stamp_s;
    previous_s_ = stamp_s;
    const double time_s = stamp_s - first_s_;
    if (time_s > longest_s_) {
      csv_.Fail(csv_.columns()[column_] + " is " + NumberText(stamp_s) + ", " + NumberText(time_s) +
                " s after the first row, expected at most " + NumberText(longest_s_) +
                ". Check that it is in seconds; for a longer motion give --longest SECONDS");
    }
    return time_s;
  }

 private:
  const CsvReader& csv_;
  std::size_t column_;
  double longest_s_;
  double first_s_ = 0;
  std::optional<double> previous_s_;
};

// The gap that the rows of a motion are in, if they are in one.
class OpenGap {
 public:
  OpenGap(const CsvReader& csv, const CommandColumns& columns, const GapReading& reading)
      : csv_(csv), columns_(columns), reading_(reading) {}

  // Adds the current row, which has a gap.
  void Add() {
    if (rows_ == 0) {
      first_line_number_ = csv_.line_number();
      text_ = columns_.GapText(csv_.row());
    }
    ++rows_;
  }

  // Ends the gap. Throws InputError at its first row if it is neither bridged nor kept.
  void Close(bool is_between) {
    const bool is_bridged = is_between && rows_ <= reading_.bridged_rows;
    if (rows_ > 0 && !is_bridged && reading_.rule == GapRule::kRefuse) {
      throw InputError(
          csv_.name(), first_line_number_,
          text_ + " of " + CountText(rows_, "row") + ". " + GapMend(rows_, is_between));
    }
    (is_bridged ? bridged_ : left_) += rows_;
    rows_ = 0;
  }

  [[nodiscard]] std::size_t left() const noexcept { return left_; }
  [[nodiscard]] std::size_t bridged() const noexcept { return bridged_; }

 private:
  const CsvReader& csv_;
  const CommandColumns& columns_;
  GapReading reading_;
  std::size_t first_line_number_ = 0;
  std::string text_;  // about the first row
  std::size_t rows_ = 0;
  std::size_t left_ = 0;
  std::size_t bridged_ = 0;
};

// Rows of a recording are closer than this [s]. Rows of a motion made by hand are farther apart.
constexpr double kFarRows_s = 1;
constexpr std::size_t kFewRows = 10;

// Returns the median of the times from row to row [s]. Precondition: two or more rows.
double MedianStep_s(const std::vector<TimedCommand>& rows) {
  std::vector<double> steps_s;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    steps_s.push_back(rows[i].time_s - rows[i - 1].time_s);
  }
  const auto middle = steps_s.begin() + static_cast<std::ptrdiff_t>(steps_s.size() / 2);
  std::nth_element(steps_s.begin(), middle, steps_s.end());
  return *middle;
}

// Returns a hint at unlikely times: if a recording of some seconds has times in milliseconds, it is
// still within the longest motion.
std::string HintAbout(const std::vector<TimedCommand>& rows) {
  if (rows.size() <= kFewRows) {
    return "";
  }
  constexpr int kDecimals = 3;
  const double step_s = MedianStep_s(rows);
  return step_s < kFarRows_s
             ? ""
             : "its " + CountText(rows.size(), "row") + " are " + RoundedText(step_s, kDecimals) +
                   " s apart (median), " + RoundedText(rows.back().time_s, kDecimals) +
                   " s in all. If time_s is in milliseconds, divide it by 1000";
}

}  // namespace

CommandRate RateOf(const Motion& motion, double time_s, double step_s) {
  const ArmCommand now = motion.command(time_s);
  const ArmCommand next = motion.command(time_s + step_s);
  return {(next.elevation_rad - now.elevation_rad) / step_s,
          ShortWay_rad(now.plane_rad, next.plane_rad) / step_s,
          ShortWay_rad(now.axial_rad, next.axial_rad) / step_s};
}

Motion ReachingMotion(std::string name, const ArmCommand& from, const ArmCommand& to,
                      double duration_s) {
  // s = 10 t^3 - 15 t^4 + 6 t^5: velocity and acceleration are 0 at both ends.
  return {std::move(name), duration_s, [from, to, duration_s](double time_s) {
            const double t = std::clamp(time_s / duration_s, 0.0, 1.0);
            return StraightBetween(from, to, t * t * t * (10 + t * (-15 + 6 * t)));
          }};
}

Motion ReadMotion(std::istream& in, const std::string& name, const MotionReading& reading) {
  constexpr std::array<std::string_view, 3> kExample = {kTimeColumn, kElevationColumn,
                                                        kPlaneColumn};
  CsvReader csv(in, name, kExample);
  const CommandColumns columns(csv, reading.angles, reading.columns, {kTimeColumn});
  RowTimes times(csv, columns.names().Column(kTimeColumn), reading.longest_s);
  std::vector<TimedCommand> rows;
  AngleSpan span;
  OpenGap gap(csv, columns, reading.gaps);
  double duration_s = 0;
  while (csv.Next()) {
    duration_s = times.Next();
    if (const std::optional<ArmCommand> command = columns.Read(csv.row(), {}, span)) {
      gap.Close(!rows.empty());
      rows.push_back({duration_s, *command});
    } else {
      gap.Add();
    }
  }
  gap.Close(false);
  if (rows.empty()) {
    csv.Fail(gap.left() > 0 ? "no row of the motion has all angles" : "the motion has no rows");
  }
  span.ExpectKnownUnit(name);
  Motion motion = {name, duration_s,
                   [path = ArmPath(rows)](double time_s) { return path.At(time_s); },
                   columns.axial_from()};
  for (const std::string& note : {columns.names().Note(), HintAbout(rows)}) {
    if (!note.empty()) {
      motion.notes.push_back(name + ": " + note);
    }
  }
  motion.gaps = gap.left();
  motion.bridged = gap.bridged();
  return motion;
}

}  // namespace girdle
