// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "motions/motion.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "motions/angle_span.h"
#include "motions/arm_path.h"
#include "motions/command_columns.h"
#include "text/csv.h"
#include "text/number_text.h"

namespace girdle {
namespace {

// On a straight line in the numbers of commands.
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
  RowTimes(const CsvReader& csv, double longest_s)
      : csv_(csv), column_(csv.Column(kTimeColumn)), longest_s_(longest_s) {}

  // The time of the current row, from the first one on.
  double Next() {
    const double stamp_s = csv_.Number(column_);
    if (previous_s_ && stamp_s <= *previous_s_) {
      csv_.Fail("time_s is " + NumberText(stamp_s) + ", which does not increase (previous " +
                NumberText(*previous_s_) + ")");
    }
    first_s_ = previous_s_ ? first_s_ : stamp_s;
    previous_s_ = stamp_s;
    const double time_s = stamp_s - first_s_;
    if (time_s > longest_s_) {
      csv_.Fail("time_s is " + NumberText(stamp_s) + ", " + NumberText(time_s) +
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
  CsvReader csv(in, name);
  const CommandColumns columns(csv, reading.angles, {kTimeColumn});
  RowTimes times(csv, reading.longest_s);
  std::vector<TimedCommand> rows;
  AngleSpan span;
  while (csv.Next()) {
    const double time_s = times.Next();
    rows.push_back({time_s, columns.Read(csv.row(), {}, span)});
  }
  if (rows.empty()) {
    csv.Fail("the motion has no rows");
  }
  span.ExpectKnownUnit(name);
  const double duration_s = rows.back().time_s;
  return {name, duration_s, [path = ArmPath(rows)](double time_s) { return path.At(time_s); }};
}

}  // namespace girdle
