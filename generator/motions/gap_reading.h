// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Reading rows in which an angle is missing, for example because a marker was hidden.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "kinematics/words.h"

namespace girdle {

enum class GapRule {
  kKeep,    ///< the row stays, without an answer
  kRefuse,  ///< the row is an error
};
inline constexpr std::array<std::string_view, 2> kGapRuleNames = {"keep", "refuse"};
constexpr const auto& WordsOf(GapRule /*which*/) noexcept { return kGapRuleNames; }

/// Most rows of a gap that may be bridged.
inline constexpr std::size_t kMostBridged = 1000;

/// How gaps are read. A gap is a number of successive rows with a missing angle.
struct GapReading {
  GapRule rule = GapRule::kKeep;  ///< for gaps that are not bridged
  /// Gaps of at most this many rows are bridged if rows without gaps are before and after them. At
  /// most kMostBridged.
  std::size_t bridged_rows = 0;
};

/// Returns the fix for a gap of `rows` rows that is refused. `is_between` tells whether there are
/// rows without gaps before and after it.
[[nodiscard]] inline std::string GapMend(std::size_t rows, bool is_between) {
  return is_between && rows <= kMostBridged
             ? "Fill it, or give --bridge-gaps " + std::to_string(rows) + " or --gaps keep"
             : "Fill it, remove the row, or give --gaps keep";
}

}  // namespace girdle
