// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The choice whether a girdle moves as measured or does not move.
#pragma once

#include <array>
#include <string_view>

namespace girdle {

/// How a girdle moves with its arm.
enum class GirdleMotion {
  kMeasured,
  kFrozen,  ///< the girdle does not move; the arm turns in GH alone
};
/// Words for the enumerators, in their order.
inline constexpr std::array<std::string_view, 2> kGirdleMotionNames = {"measured", "frozen"};
constexpr const auto& WordsOf(GirdleMotion /*which*/) noexcept { return kGirdleMotionNames; }

}  // namespace girdle
