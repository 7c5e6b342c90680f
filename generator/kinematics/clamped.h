// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// A number kept within two others, whatever it is.
#pragma once

#include <algorithm>

namespace girdle {

/// Returns the value of [lower, upper] nearest to `value`, and `lower` for a NaN, which std::clamp
/// hands on.
[[nodiscard]] inline double Clamped(double value, double lower, double upper) noexcept {
  return value > lower ? std::min(value, upper) : lower;
}

}  // namespace girdle
