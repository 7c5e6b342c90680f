// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "text/text_columns.h"

#include <algorithm>

namespace girdle {

std::string AlignedLeft(std::string text, std::size_t width) {
  text.resize(std::max(text.size(), width), ' ');
  return text;
}

std::string AlignedRight(const std::string& text, std::size_t width) {
  return std::string(width - std::min(width, text.size()), ' ') + text;
}

std::string ColumnsText(const std::vector<std::vector<std::string>>& rows,
                        const std::vector<Alignment>& alignments) {
  std::vector<std::size_t> widths(rows.empty() ? 0 : rows.front().size());
  for (const std::vector<std::string>& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths.at(i) = std::max(widths.at(i), row[i].size());
    }
  }
  std::string text;
  for (const std::vector<std::string>& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const Alignment alignment = alignments[std::min(i, alignments.size() - 1)];
      line +=
          (i == 0 ? "" : "  ") + (alignment == Alignment::kLeft ? AlignedLeft(row[i], widths[i])
                                                                : AlignedRight(row[i], widths[i]));
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

}  // namespace girdle
