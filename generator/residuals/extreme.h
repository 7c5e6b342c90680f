// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The worst case of a quantity over poses, for lines of the residual report.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "kinematics/shoulder_rhythm.h"
#include "kinematics/worst_case.h"
#include "residuals/residual.h"

namespace girdle {

/// Returns text for a place in the report: `abduction, elevation 31.5, plane 0`.
[[nodiscard]] std::string PlaceOf(std::string_view motion, const ArmCommand& command);

/// The pose of a value in the report.
struct ReportPlace {
  ReportPlace() = default;
  ReportPlace(std::string_view name, const ArmCommand& at) : motion(name), command(at) {}

  std::string motion;
  ArmCommand command;
};

/// Report lines that are made from a worst case. Their values are magnitudes. A worst case without
/// any value is NaN and does not pass.
class Extreme {
 public:
  void Add(double value, std::string_view motion, const ArmCommand& command) {
    worst_case_.Add(value, motion, command);
  }

  [[nodiscard]] bool empty() const noexcept { return worst_case_.empty(); }
  [[nodiscard]] double worst() const noexcept { return worst_case_.magnitude(); }

  [[nodiscard]] Residual Worst(std::string group, std::string item, std::string unit,
                               std::optional<double> tolerance) const;
  [[nodiscard]] Residual RootMeanSquare(std::string group, std::string item, std::string unit,
                                        std::optional<double> tolerance) const;

 private:
  WorstCase<ReportPlace> worst_case_;
};

/// One extreme for each joint: SC, AC, GH.
using JointExtremes = std::array<Extreme, kJointCount>;

}  // namespace girdle
