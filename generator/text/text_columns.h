// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Columns of text, for reports that people read. Widths are in bytes, and so right for ASCII.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace girdle {

/// Returns `text` with blanks behind it up to `width`; a longer text as it is.
[[nodiscard]] std::string AlignedLeft(std::string text, std::size_t width);

/// Returns `text` with blanks before it up to `width`; a longer text as it is.
[[nodiscard]] std::string AlignedRight(const std::string& text, std::size_t width);

enum class Alignment { kLeft, kRight };

/// Returns `rows` below each other, a line each, columns as wide as their widest text and two
/// blanks apart; no line ends in blanks. Columns beyond the last of `alignments` are aligned as the
/// last. Precondition: all rows have as many texts as the first, and there is one alignment or
/// more.
[[nodiscard]] std::string ColumnsText(const std::vector<std::vector<std::string>>& rows,
                                      const std::vector<Alignment>& alignments);

}  // namespace girdle
