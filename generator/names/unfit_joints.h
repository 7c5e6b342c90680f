// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The reasons why the joints of a compiled model are unfit for its servos. The plugin and the
/// program use the texts of this header.
#pragma once

#include <string>

#include "text/number_text.h"

namespace girdle {

/// Returns the fault of joints whose widest range is `widest_rad` with the line to write, or an
/// empty text. The widest range of the emitted models, gh_axial, is 240 degrees = 4.2 rad. Read as
/// degrees, it becomes 0.07 rad. No arm that moves has a widest range below 11 degrees.
[[nodiscard]] inline std::string RangesFault(double widest_rad) {
  constexpr double kNoRangeOfAShoulder_rad = 0.2;
  return widest_rad < kNoRangeOfAShoulder_rad
             ? "all joint ranges are within " + SignificantText(widest_rad, 2) +
                   " rad, as if their radians had been read as degrees: write <compiler "
                   "angle=\"radian\"/> after the last <include>, or in Python set compiler.degree "
                   "of the parent to False before you attach"
             : "";
}

/// Fault of a model that disables the damper in `option/flag`.
inline constexpr const char* kDisabledDamperFault =
    "the joints' damping, which the servos need, is disabled: write <flag damper=\"enable\"/> in "
    "<option> (before MuJoCo 3.3.6 passive=\"enable\")";

}  // namespace girdle
