// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Width and colours of a text for people.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace girdle {

struct TextStyle {
  std::size_t width = 80;   ///< most bytes of a line
  bool has_colour = false;  ///< whether escape sequences of terminals may be written
};

/// Colours of a terminal (ECMA-48, "select graphic rendition").
enum class Colour { kRed = 31, kGreen = 32 };

/// Returns `text` in a colour, or unchanged if the style has no colours.
[[nodiscard]] inline std::string Coloured(std::string_view text, Colour colour,
                                          const TextStyle& style) {
  if (!style.has_colour) {
    return std::string(text);
  }
  return "\x1b[" + std::to_string(static_cast<int>(colour)) + "m" + std::string(text) + "\x1b[0m";
}

}  // namespace girdle
