// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Whether a girdle moves as measured or stays.
#pragma once

#include <array>
#include <string_view>

namespace girdle {

/// How a girdle goes with its arm.
enum class GirdleMotion {
  kMeasured,
  kFrozen,  ///< it stays, and the arm turns in GH alone
};
/// Words for them, in the order of the enumerators.
inline constexpr std::array<std::string_view, 2> kGirdleMotionNames = {"measured", "frozen"};
constexpr const auto& WordsOf(GirdleMotion /*which*/) noexcept { return kGirdleMotionNames; }

}  // namespace girdle
