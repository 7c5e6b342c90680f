// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/knot_crossings.h"

#include <algorithm>
#include <cmath>

namespace girdle {

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

std::vector<ArmCommand> KnotCrossings(const RhythmTable& table, Direction direction) {
  constexpr double kRoom_rad = 0.5 * kRadiansPerDegree;
  const bool is_elevation = direction == Direction::kElevation;
  const auto& lines_rad = is_elevation ? table.elevations_rad() : table.planes_rad();
  const auto& along_rad = is_elevation ? table.planes_rad() : table.elevations_rad();
  std::vector<ArmCommand> places;
  for (std::size_t i = 1; i + 1 < lines_rad.size(); ++i) {
    for (const double place_rad :
         EvenSteps(along_rad.front() + kRoom_rad, along_rad.back() - kRoom_rad)) {
      places.push_back(is_elevation ? ArmCommand{lines_rad[i], place_rad}
                                    : ArmCommand{place_rad, lines_rad[i]});
    }
  }
  return places;
}

}  // namespace girdle
