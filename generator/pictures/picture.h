// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// A picture in memory, and whether it can be one.
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

/// What is wrong with a picture that a renderer gave.
enum class PictureFault {
  kBlank,  ///< one colour all over
  kNoise,  ///< memory that nobody drew on: pixels have nothing to do with their neighbours
};

/// Returns what is wrong with a picture, or nothing.
///
/// Blank: of each colour all values lie within two of one another. Noise: along rows and along
/// columns, the mean squared difference of neighbours is more than 0.7 of what it is between
/// pixels far apart,
///
///     d = mean (a_i - a_(i+1))^2,   d / (2 var a) > 0.7,
///
/// where it is 1 for pixels that do not depend on each other and below 0.2 for what was drawn, also
/// where there is a fine pattern: stripes differ in one direction only.
[[nodiscard]] std::optional<PictureFault> FaultOf(const Picture& picture) noexcept;

}  // namespace girdle
