// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "residuals/extreme.h"

#include <cmath>
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

void Extreme::Add(double value, std::string_view motion, const ArmCommand& command) {
  const double magnitude = std::abs(value);
  square_sum_ += value * value;
  ++count_;
  if (count_ == 1 || magnitude > worst_ || (std::isnan(magnitude) && !std::isnan(worst_))) {
    worst_ = magnitude;
    motion_ = motion;
    command_ = command;
  }
}

// The text of the place is made only when it is needed.
Residual Extreme::Worst(std::string group, std::string item, std::string unit,
                        std::optional<double> tolerance) const {
  return {std::move(group), std::move(item), worst_,
          std::move(unit),  tolerance,       PlaceOf(motion_, command_)};
}

Residual Extreme::RootMeanSquare(std::string group, std::string item, std::string unit,
                                 std::optional<double> tolerance) const {
  return {std::move(group), std::move(item), std::sqrt(square_sum_ / static_cast<double>(count_)),
          std::move(unit),  tolerance,       std::to_string(count_) + " values"};
}

}  // namespace girdle
