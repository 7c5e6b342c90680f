// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// A weight that falls smoothly from 1 to 0.
#pragma once

#include <array>

#include "kinematics/jet.h"

namespace girdle {

/// Returns 1 for x <= 0 and 0 for x >= 1. Between them the result is twice continuously
/// differentiable:
///
///     1 - 10 x^3 + 15 x^4 - 6 x^5
template <typename T>
[[nodiscard]] T Bump(const T& x) noexcept {
  if (!(ValueOf(x) > 0)) {
    return T(1.0);
  }
  if (ValueOf(x) >= 1) {
    return T(0.0);
  }
  return Polynomial(std::array{1.0, 0.0, 0.0, -10.0, 15.0, -6.0}, x);
}

}  // namespace girdle
