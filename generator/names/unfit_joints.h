// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// What makes the joints of a compiled model unfit for its servos. Plugin and program say the same
/// of it.
#pragma once

#include <string>

#include "text/number_text.h"

namespace girdle {

/// Returns what is wrong with joints whose widest range is this [rad], and the line to write, or
/// nothing. The emitted models' widest range, of gh_axial, is 240 degrees = 4.2 rad. 4.2 degrees
/// are 0.07 rad, and no arm that moves has a widest range of less than 11 degrees.
[[nodiscard]] inline std::string RangesFault(double widest_rad) {
  constexpr double kNoRangeOfAShoulder_rad = 0.2;
  return widest_rad < kNoRangeOfAShoulder_rad
             ? "all joint ranges are within " + SignificantText(widest_rad, 2) +
                   " rad, as if their radians had been read as degrees: write <compiler "
                   "angle=\"radian\"/> after the last <include>, or in Python set compiler.degree "
                   "of the parent to False before you attach"
             : "";
}

/// Of a model in which `option/flag` disables it.
inline constexpr const char* kDisabledDamperFault =
    "the joints' damping, which the servos need, is disabled: write <flag damper=\"enable\"/> in "
    "<option> (before MuJoCo 3.3.6 passive=\"enable\")";

}  // namespace girdle
