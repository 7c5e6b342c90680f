// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Lines of the residual report.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kinematics/words.h"

namespace girdle {

/// Which values of a line pass.
enum class Bound {
  kAtMost,    ///< up to the tolerance
  kMoreThan,  ///< above it
};
/// Words for them, in the order of the enumerators.
inline constexpr std::array<std::string_view, 2> kBoundNames = {"at most", "more than"};
constexpr const auto& WordsOf(Bound /*which*/) noexcept { return kBoundNames; }

/// Group of the lines that fail where a model has other bones than the anatomy that was said.
inline constexpr const char* kBonesGroup = "bones";

/// One line of the report.
struct Residual {
  std::string group;  ///< what is checked: "joint constraint"
  std::string item;   ///< on what: "SC"
  double value = 0;   ///< worst case, or rms where `item` says so
  std::string unit;
  /// Largest value that passes, or what it must be more than; nothing where the value is stated
  /// only.
  std::optional<double> tolerance;
  std::string where;  ///< the pose of the worst case
  Bound bound = Bound::kAtMost;
  /// The value cannot be off unless a line that is checked is off too. Such a line is no check of
  /// its own: it has no tolerance.
  bool follows = false;

  /// A value that is not a number does not pass.
  [[nodiscard]] bool passed() const noexcept {
    return !tolerance || (bound == Bound::kAtMost ? value <= *tolerance : value > *tolerance);
  }
};

struct ResidualReport {
  std::string model;   ///< path
  std::string kind;    ///< sides, assembly, what moves the joints
  std::string rhythm;  ///< what the model was held against: interpolation, closure, table
  std::string engine;  ///< MuJoCo's version
  std::string remark;  ///< a sentence about the whole report; empty if there is nothing to say
  std::vector<Residual> residuals;

  [[nodiscard]] bool passed() const noexcept;
};

}  // namespace girdle
