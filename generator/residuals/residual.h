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

/// Group of the lines that fail if a model's bones differ from those of the given anatomy.
inline constexpr const char* kBonesGroup = "bones";

/// One line of the report.
struct Residual {
  std::string group;  ///< the kind of check: "joint constraint"
  std::string item;   ///< the part that is checked: "SC"
  double value = 0;   ///< worst case, or rms where `item` says so
  std::string unit;
  /// Largest value that passes, or the value that it must exceed. Nothing if the value is only
  /// stated.
  std::optional<double> tolerance;
  std::string where;  ///< the pose of the worst case
  Bound bound = Bound::kAtMost;
  /// Whether the value can only be off if another line with a tolerance is off too. Such a line is
  /// no check of its own and has no tolerance.
  bool follows = false;

  /// Returns whether the value is within its tolerance. NaN does not pass.
  [[nodiscard]] bool passed() const noexcept {
    return !tolerance || (bound == Bound::kAtMost ? value <= *tolerance : value > *tolerance);
  }
};

struct ResidualReport {
  std::string model;   ///< path
  std::string kind;    ///< sides, assembly, what moves the joints
  std::string rhythm;  ///< rhythm that the model was compared with: interpolation, closure, table
  std::string engine;  ///< MuJoCo's version
  std::string remark;  ///< a sentence about the whole report; may be empty
  std::vector<Residual> residuals;

  [[nodiscard]] bool passed() const noexcept;
};

}  // namespace girdle
