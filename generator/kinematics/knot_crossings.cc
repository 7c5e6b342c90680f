// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/knot_crossings.h"

#include <algorithm>
#include <cmath>

namespace girdle {
namespace {

// Distance from the table's borders within which difference quotients have no room.
constexpr double kRoom_rad = 0.5 * kRadiansPerDegree;

Direction Other(Direction direction) noexcept {
  return direction == Direction::kElevation ? Direction::kPlane : Direction::kElevation;
}

std::vector<ArmCommand> OnInnerLines(const RhythmTable& table, Direction direction,
                                     const std::vector<double>& places_rad) {
  const std::vector<double>& lines_rad = KnotsAlong(table, direction);
  std::vector<ArmCommand> crossings;
  for (std::size_t i = 1; i + 1 < lines_rad.size(); ++i) {
    for (const double place_rad : places_rad) {
      crossings.push_back(direction == Direction::kElevation ? ArmCommand{lines_rad[i], place_rad}
                                                             : ArmCommand{place_rad, lines_rad[i]});
    }
  }
  return crossings;
}

}  // namespace

ArmCommand MovedAlong(Direction direction, const ArmCommand& command, double step_rad) noexcept {
  ArmCommand moved = command;
  (direction == Direction::kElevation ? moved.elevation_rad : moved.plane_rad) += step_rad;
  return moved;
}

std::vector<double> EvenSteps(double from_rad, double to_rad, double step_rad) {
  const int count = std::max(1, static_cast<int>(std::lround((to_rad - from_rad) / step_rad)));
  std::vector<double> values;
  for (int i = 0; i <= count; ++i) {
    values.push_back(from_rad + (to_rad - from_rad) * i / count);
  }
  return values;
}

const std::vector<double>& KnotsAlong(const RhythmTable& table, Direction direction) noexcept {
  return direction == Direction::kElevation ? table.elevations_rad() : table.planes_rad();
}

std::vector<ArmCommand> KnotCrossings(const RhythmTable& table, Direction direction) {
  const std::vector<double>& across_rad = KnotsAlong(table, Other(direction));
  return OnInnerLines(table, direction,
                      EvenSteps(across_rad.front() + kRoom_rad, across_rad.back() - kRoom_rad));
}

std::vector<ArmCommand> FewKnotCrossings(const RhythmTable& table, Direction direction) {
  const std::vector<double>& across_rad = KnotsAlong(table, Other(direction));
  std::vector<double> places_rad = {across_rad.front() + kRoom_rad};
  for (std::size_t i = 1; i < across_rad.size(); ++i) {
    places_rad.push_back((across_rad[i - 1] + across_rad[i]) / 2);
    places_rad.push_back(i + 1 < across_rad.size() ? across_rad[i] : across_rad[i] - kRoom_rad);
  }
  return OnInnerLines(table, direction, places_rad);
}

}  // namespace girdle
