// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "residuals/extreme.h"

#include <utility>

#include "text/number_text.h"

namespace girdle {

std::string PlaceOf(std::string_view motion, const ArmCommand& command) {
  const auto degrees = [](double angle_rad) {
    return RoundedText(DegreesFromRadians(angle_rad), 1);
  };
  return std::string(motion) + ", elevation " + degrees(command.elevation_rad) + ", plane " +
         degrees(command.plane_rad);
}

// The text of the place is made here, because only the worst case needs it.
Residual Extreme::Worst(std::string group, std::string item, std::string unit,
                        std::optional<double> tolerance) const {
  const ReportPlace& place = worst_case_.place();
  return {std::move(group), std::move(item), worst(),
          std::move(unit),  tolerance,       PlaceOf(place.motion, place.command)};
}

Residual Extreme::RootMeanSquare(std::string group, std::string item, std::string unit,
                                 std::optional<double> tolerance) const {
  return {std::move(group), std::move(item), worst_case_.rms(),
          std::move(unit),  tolerance,       CountText(worst_case_.count(), "value")};
}

}  // namespace girdle
