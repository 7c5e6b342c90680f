// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// A number limited to an interval, with a rule for NaN.
#pragma once

#include <algorithm>

namespace girdle {

/// Returns the value of [lower, upper] that is nearest to `value`. Returns `lower` for a NaN,
/// unlike std::clamp, which returns the NaN.
[[nodiscard]] inline double Clamped(double value, double lower, double upper) noexcept {
  return value > lower ? std::min(value, upper) : lower;
}

}  // namespace girdle
