// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Columns of text, for reports that people read. Widths count bytes, which is right for ASCII.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace girdle {

/// Returns `text` with blanks after it up to `width`. A longer text is returned unchanged.
[[nodiscard]] std::string AlignedLeft(std::string text, std::size_t width);

/// Returns `text` with blanks before it up to `width`. A longer text is returned unchanged.
[[nodiscard]] std::string AlignedRight(const std::string& text, std::size_t width);

enum class Alignment { kLeft, kRight };

/// Blanks between two columns of ColumnsText.
inline constexpr std::size_t kColumnGap = 2;

/// Returns `rows` as lines. Each column is as wide as its widest text, columns are kColumnGap
/// blanks apart, and no line ends in blanks. Columns beyond the last of `alignments` are aligned as
/// the last. Precondition: all rows have as many texts as the first, and there is at least one
/// alignment.
[[nodiscard]] std::string ColumnsText(const std::vector<std::vector<std::string>>& rows,
                                      const std::vector<Alignment>& alignments);

/// Returns `text` with line breaks in place of blanks, so that lines have at most `width` bytes;
/// a longer word stands on a line of its own. Lines after the first begin with `indent` blanks. A
/// line of `text` that begins with a blank is an example of a command: it is broken before an
/// option, with a backslash at the end of the line, as a shell allows.
[[nodiscard]] std::string WrappedText(const std::string& text, std::size_t width,
                                      std::size_t indent = 0);

/// Returns two columns: `label`, with `indent` blanks before it and padded up to column
/// `label_width`, and `text`, wrapped at `width`. A longer label has a line of its own. The result
/// ends in a line end.
[[nodiscard]] std::string LabelledText(const std::string& label, const std::string& text,
                                       std::size_t indent, std::size_t label_width,
                                       std::size_t width);

}  // namespace girdle
