// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The longest time steps with which a shoulder moves as it should.
#pragma once

#include "kinematics/assembly.h"

namespace girdle {

/// Returns the longest step [s], a whole number of milliseconds and at most 10, with which an arm
/// that goes between elevation 15 and 120 and back once a second keeps a loop's joint closed within
/// 1 mm, or a tree's largest joint error within 0.2 degrees of that at 1 ms, and comes to rest
/// after a command that jumps. Measured with the models that girdle generate emits
/// (scripts/longest_steps). `is_rk4` is of MuJoCo's integrator: the others integrate the joints'
/// damping implicitly.
[[nodiscard]] constexpr double LongestTimestep_s(Assembly assembly, Lead lead,
                                                 bool is_rk4) noexcept {
  if (assembly == Assembly::kTree) {
    return is_rk4 ? 0.002 : 0.010;
  }
  if (is_rk4) {
    return 0.001;
  }
  return lead == Lead::kClavicle ? 0.005 : 0.007;
}

}  // namespace girdle
