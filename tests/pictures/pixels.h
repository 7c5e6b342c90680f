// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// What tests ask of a picture.
#pragma once

#include <algorithm>
#include <cstddef>

#include "pictures/picture.h"

namespace girdle {

struct Pixel {
  int red;
  int green;
  int blue;

  // Much more of one colour than of the others, however it is lit.
  [[nodiscard]] bool is_red() const { return red > 40 && red > 2 * std::max(green, blue); }
  [[nodiscard]] bool is_green() const { return green > 40 && green > 2 * std::max(red, blue); }
  [[nodiscard]] bool is_blue() const { return blue > 40 && blue > 2 * std::max(red, green); }
};

// Column from the left, row from the top.
inline Pixel PixelAt(const Picture& picture, int x, int y) {
  const std::size_t at =
      3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.size.width) +
           static_cast<std::size_t>(x));
  return {picture.rgb[at], picture.rgb[at + 1], picture.rgb[at + 2]};
}

inline Pixel Middle(const Picture& picture) {
  return PixelAt(picture, picture.size.width / 2, picture.size.height / 2);
}

// Columns and rows that hold a pixel for which `is` is true; count 0 if there is none.
struct Patch {
  int left = 1 << 20;
  int right = -1;
  int top = 1 << 20;
  int bottom = -1;
  int count = 0;

  [[nodiscard]] double middle_x() const { return 0.5 * (left + right); }
  [[nodiscard]] double middle_y() const { return 0.5 * (top + bottom); }
};

template <typename Predicate>
Patch PatchWhere(const Picture& picture, const Predicate& is) {
  Patch patch;
  for (int y = 0; y < picture.size.height; ++y) {
    for (int x = 0; x < picture.size.width; ++x) {
      if (is(PixelAt(picture, x, y))) {
        patch.left = std::min(patch.left, x);
        patch.right = std::max(patch.right, x);
        patch.top = std::min(patch.top, y);
        patch.bottom = std::max(patch.bottom, y);
        ++patch.count;
      }
    }
  }
  return patch;
}

inline Patch RedPatch(const Picture& picture) {
  return PatchWhere(picture, [](const Pixel& pixel) { return pixel.is_red(); });
}
inline Patch GreenPatch(const Picture& picture) {
  return PatchWhere(picture, [](const Pixel& pixel) { return pixel.is_green(); });
}
inline Patch BluePatch(const Picture& picture) {
  return PatchWhere(picture, [](const Pixel& pixel) { return pixel.is_blue(); });
}

}  // namespace girdle
