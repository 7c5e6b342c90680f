// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "text/text_columns.h"

#include <algorithm>
#include <sstream>

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
      line += std::string(i == 0 ? 0 : kColumnGap, ' ') + (alignment == Alignment::kLeft
                                                               ? AlignedLeft(row[i], widths[i])
                                                               : AlignedRight(row[i], widths[i]));
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

namespace {

// Returns one line with breaks where it is too long. `column` is the column where it begins.
std::string WrappedLine(const std::string& line, std::size_t width, std::size_t indent,
                        std::size_t column) {
  std::istringstream words(line);
  std::string text;
  bool is_first = true;
  for (std::string word; words >> word; is_first = false) {
    const bool fits = column + (is_first ? 0 : 1) + word.size() <= width;
    if (!is_first && !fits) {
      text += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (!is_first) {
      text += ' ';
      ++column;
    }
    text += word;
    column += word.size();
  }
  return text;
}

// An example of a command, broken before its options as a shell allows.
std::string WrappedExample(const std::string& line, std::size_t width) {
  constexpr const char* kGoesOn = " \\";
  const std::string indent(line.find_first_not_of(' ') + 4, ' ');
  std::string text;
  std::string rest = line;
  while (rest.size() > width) {
    const std::size_t last = rest.rfind(" --", width - std::min<std::size_t>(width, 2));
    if (last == std::string::npos || last < indent.size()) {
      break;
    }
    text += rest.substr(0, last) + kGoesOn + "\n";
    rest = indent + rest.substr(last + 1);
  }
  return text + rest;
}

}  // namespace

std::string WrappedText(const std::string& text, std::size_t width, std::size_t indent) {
  std::istringstream lines(text);
  std::string wrapped;
  bool is_first = true;
  for (std::string line; std::getline(lines, line); is_first = false) {
    wrapped += is_first ? "" : "\n" + std::string(line.empty() ? 0 : indent, ' ');
    wrapped += line.starts_with(' ') ? WrappedExample(line, width)
                                     : WrappedLine(line, width, indent, is_first ? 0 : indent);
  }
  return wrapped;
}

std::string LabelledText(const std::string& label, const std::string& text, std::size_t indent,
                         std::size_t label_width, std::size_t width) {
  std::string line = AlignedLeft(std::string(indent, ' ') + label, label_width);
  if (text.empty()) {
    return line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  if (line.size() > label_width || line.back() != ' ') {
    line += "\n" + std::string(label_width, ' ');
  }
  // The first line begins in the text's column, as all others do.
  const std::string wrapped = WrappedText(text, width - std::min(width, label_width));
  std::istringstream lines(wrapped);
  bool is_first = true;
  for (std::string part; std::getline(lines, part); is_first = false) {
    line += (is_first ? "" : std::string(label_width, ' ')) + part + "\n";
  }
  return line;
}

}  // namespace girdle
