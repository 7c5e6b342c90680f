// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "tables/csv.h"

#include <algorithm>
#include <utility>

#include "tables/input_error.h"
#include "tables/number_text.h"

namespace girdle {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

std::string Joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

}  // namespace

CsvReader::CsvReader(std::istream& in, std::string name) : in_(in), name_(std::move(name)) {
  while (header_line_.empty()) {
    if (!ReadLine()) {
      throw InputError(name_, line_number_ + 1,
                       "no header line. The first line must name the columns");
    }
    if (line_.starts_with('#')) {
      comments_.push_back(line_);
    } else {
      header_line_ = line_;
    }
  }
  Split();
  columns_.assign(fields_.begin(), fields_.end());
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (columns_[i].empty()) {
      Fail("column " + std::to_string(i + 1) + " has no name");
    }
    if (std::find(columns_.begin(), columns_.begin() + static_cast<std::ptrdiff_t>(i),
                  columns_[i]) != columns_.begin() + static_cast<std::ptrdiff_t>(i)) {
      Fail("column '" + columns_[i] + "' stands twice. Rename or remove one");
    }
  }
}

bool CsvReader::ReadLine() {
  if (!std::getline(in_, line_)) {
    if (in_.bad()) {
      throw InputError(name_, line_number_ + 1, "cannot be read");
    }
    return false;
  }
  ++line_number_;
  if (line_number_ == 1 && std::string_view(line_).starts_with(kByteOrderMark)) {
    line_.erase(0, kByteOrderMark.size());
  }
  if (!line_.empty() && line_.back() == '\r') {
    line_.pop_back();
  }
  return true;
}

bool CsvReader::Next() {
  if (!ReadLine()) {
    return false;
  }
  if (line_.empty()) {
    const std::size_t empty_line = line_number_;
    while (ReadLine()) {
      if (!line_.empty()) {
        throw InputError(name_, empty_line, "empty line between rows. Remove it");
      }
    }
    return false;
  }
  Split();
  if (fields_.size() != columns_.size()) {
    Fail(std::to_string(fields_.size()) + " fields, expected " + std::to_string(columns_.size()) +
         " as in the header (" + header_line_ + ")");
  }
  return true;
}

void CsvReader::Split() {
  fields_.clear();
  const std::string_view line = line_;
  if (line.find('"') == std::string_view::npos) {
    std::size_t begin = 0;
    for (std::size_t comma = line.find(','); comma != std::string_view::npos;
         comma = line.find(',', begin)) {
      fields_.push_back(line.substr(begin, comma - begin));
      begin = comma + 1;
    }
    fields_.push_back(line.substr(begin));
    return;
  }
  // Views into unquoted_ stay valid: it never grows beyond the line.
  unquoted_.clear();
  unquoted_.reserve(line.size());
  std::size_t i = 0;
  while (true) {
    const std::size_t begin = unquoted_.size();
    if (i < line.size() && line[i] == '"') {
      ++i;
      while (true) {
        const std::size_t quote = line.find('"', i);
        if (quote == std::string_view::npos) {
          Fail("a quote is not closed on its line");
        }
        unquoted_.append(line, i, quote - i);
        i = quote + 1;
        if (i >= line.size() || line[i] != '"') {
          break;
        }
        unquoted_ += line[i++];
      }
      if (i < line.size() && line[i] != ',') {
        Fail("text behind a closing quote. Put the whole field in quotes");
      }
    } else {
      const std::size_t comma = std::min(line.find(',', i), line.size());
      unquoted_.append(line, i, comma - i);
      i = comma;
    }
    fields_.push_back(std::string_view(unquoted_).substr(begin));
    if (i >= line.size()) {
      return;
    }
    ++i;
  }
}

std::size_t CsvReader::Column(std::string_view column) const {
  const auto found = std::find(columns_.begin(), columns_.end(), column);
  if (found == columns_.end()) {
    throw InputError(
        name_, line_number_,
        "column '" + std::string(column) + "' is missing. The header has: " + Joined(columns_));
  }
  return static_cast<std::size_t>(found - columns_.begin());
}

bool CsvReader::HasColumn(std::string_view column) const noexcept {
  return std::find(columns_.begin(), columns_.end(), column) != columns_.end();
}

void CsvReader::ExpectOnlyColumns(const std::vector<std::string_view>& known) const {
  for (const std::string& column : columns_) {
    if (std::find(known.begin(), known.end(), column) == known.end()) {
      Fail("column '" + column + "' is not known. Remove it or correct its name");
    }
  }
}

double CsvReader::Number(std::size_t column) const {
  const std::optional<double> number = FiniteNumber(Field(column));
  if (!number) {
    Fail(columns_[column] + " is '" + std::string(Field(column)) +
         "', expected a finite number such as 22.5");
  }
  return *number;
}

double CsvReader::NumberWithin(std::size_t column, double lower, double upper) const {
  const double number = Number(column);
  if (number < lower || number > upper) {
    Fail(columns_[column] + " is " + NumberText(number) + ", expected " + NumberText(lower) +
         " to " + NumberText(upper));
  }
  return number;
}

void CsvReader::Fail(const std::string& message) const {
  throw InputError(name_, line_number_, message);
}

}  // namespace girdle
