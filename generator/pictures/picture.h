// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// A picture in memory, and a check that a renderer really drew it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pictures/view.h"

namespace girdle {

/// Red, green and blue of each pixel, 0 to 255 (sRGB), row by row from the top, each from the left.
struct Picture {
  PictureSize size;
  std::vector<std::uint8_t> rgb;  ///< 3 * width * height
};

/// Faults of a picture from a renderer.
enum class PictureFault {
  kBlank,  ///< one colour all over
  kNoise,  ///< memory that was never drawn on: pixels are unrelated to their neighbours
};

/// Returns the fault of a picture, or nothing.
///
/// A picture is blank if, for each colour, all values differ by at most two. A picture is noise if,
/// along rows and along columns, the mean squared difference d of neighbours exceeds 0.7 of that
/// between pixels far apart:
///
///     d = mean (a_i - a_(i+1))^2,   d / (2 var a) > 0.7,
///
/// The ratio is 1 for pixels that are independent of each other, and below 0.2 for drawn pictures.
/// A fine pattern of stripes is no noise, because stripes differ in one direction only.
[[nodiscard]] std::optional<PictureFault> FaultOf(const Picture& picture) noexcept;

}  // namespace girdle
