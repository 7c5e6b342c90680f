// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Input of the user as messages show it: short, and without effect on a terminal.
#pragma once

#include <cstddef>
#include <ostream>
#include <string>
#include <string_view>

namespace girdle {

/// Most bytes of a value that a message shows.
inline constexpr std::size_t kMostShownOfValue = 80;
/// Most bytes of a header that a message shows.
inline constexpr std::size_t kMostShownOfHeader = 400;

/// Returns `text`. Of a text with more than `most` bytes it returns the beginning and the size,
/// such as `777... (100000 bytes)`. A character of UTF-8 is not cut in two.
[[nodiscard]] std::string ShortText(std::string_view text, std::size_t most = kMostShownOfValue);

/// Writes a message. Control characters and bytes that are not UTF-8 become `\x1b` and so on; line
/// feeds stay. Allocates nothing.
void WritePrintable(std::ostream& out, std::string_view message);

}  // namespace girdle
