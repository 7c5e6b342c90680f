// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// What a quantity comes to over poses, for lines of the residual report.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "kinematics/shoulder_rhythm.h"
#include "residuals/residuals.h"

namespace girdle {

/// Returns text for a place in the report: `abduction, elevation 31.5, plane 0`.
[[nodiscard]] std::string PlaceOf(std::string_view motion, const ArmCommand& command);

/// Largest magnitude and root mean square of a quantity over poses.
class Extreme {
 public:
  /// A NaN becomes the worst and stays it.
  void Add(double value, std::string_view motion, const ArmCommand& command);

  [[nodiscard]] bool empty() const noexcept { return count_ == 0; }
  /// Not a number of what was never added.
  [[nodiscard]] double worst() const noexcept { return worst_; }

  [[nodiscard]] Residual Worst(std::string group, std::string item, std::string unit,
                               std::optional<double> tolerance) const;
  [[nodiscard]] Residual RootMeanSquare(std::string group, std::string item, std::string unit,
                                        std::optional<double> tolerance) const;

 private:
  // What was never measured does not pass.
  double worst_ = std::numeric_limits<double>::quiet_NaN();
  double square_sum_ = 0;
  std::size_t count_ = 0;
  std::string motion_;
  ArmCommand command_;
};

}  // namespace girdle
