// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "text/csv.h"

#include <algorithm>
#include <utility>

#include "text/input_error.h"
#include "text/near_names.h"
#include "text/number_text.h"

namespace girdle {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
constexpr const char* kEmptyLine = "empty line between rows. Remove it";
// Bytes of a block. A block is large against the cost of passing it to another thread. It is small
// enough that a slow stream and a terminal with progress do not wait for it.
constexpr std::size_t kBlockSize = 8192;

std::string Joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

// Takes the first line from `text` and returns it without its line end.
std::string_view CutLine(std::string_view& text) {
  const std::size_t size = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, size);
  text.remove_prefix(std::min(size + 1, text.size()));
  if (line.ends_with('\r')) {
    line.remove_suffix(1);
  }
  return line;
}

// Removes the empty lines at the end of `text` and returns their number.
std::size_t CutEmptyEnd(std::string& text) {
  std::size_t count = 0;
  while (!text.empty()) {
    const bool has_line_end = text.back() == '\n';
    const std::size_t before =
        text.size() < 2 ? std::string::npos : text.rfind('\n', text.size() - 2);
    const std::size_t begin = before == std::string::npos ? 0 : before + 1;
    const std::size_t size = text.size() - begin - (has_line_end ? 1 : 0);
    if (size > 1 || (size == 1 && text[begin] != '\r')) {
      break;
    }
    text.resize(begin);
    ++count;
  }
  return count;
}

std::size_t CountLines(const std::string& text) {
  const auto line_ends = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  return line_ends + (text.empty() || text.back() == '\n' ? 0 : 1);
}

// Splits a line with quotes, as SplitFields does. The fields are views of `unquoted`.
const char* SplitQuotedFields(std::string_view line, std::vector<std::string_view>& fields,
                              std::string& unquoted) {
  fields.clear();
  // The views stay valid: the text never grows beyond the line.
  unquoted.clear();
  unquoted.reserve(line.size());
  std::size_t i = 0;
  while (true) {
    const std::size_t begin = unquoted.size();
    if (i < line.size() && line[i] == '"') {
      ++i;
      while (true) {
        const std::size_t quote = line.find('"', i);
        if (quote == std::string_view::npos) {
          return "a quote is not closed on its line";
        }
        unquoted.append(line, i, quote - i);
        i = quote + 1;
        if (i >= line.size() || line[i] != '"') {
          break;
        }
        unquoted += line[i++];
      }
      if (i < line.size() && line[i] != ',') {
        return "text behind a closing quote. Put the whole field in quotes";
      }
    } else {
      const std::size_t comma = std::min(line.find(',', i), line.size());
      unquoted.append(line, i, comma - i);
      i = comma;
    }
    fields.push_back(std::string_view(unquoted).substr(begin));
    if (i >= line.size()) {
      return nullptr;
    }
    ++i;
  }
}

// Splits a line into its fields, which are views of the line or of `unquoted`. Returns a fault, or
// null.
const char* SplitFields(std::string_view line, std::vector<std::string_view>& fields,
                        std::string& unquoted) {
  fields.clear();
  std::size_t begin = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == ',') {
      fields.push_back(line.substr(begin, i - begin));
      begin = i + 1;
    } else if (line[i] == '"') {
      return SplitQuotedFields(line, fields, unquoted);
    }
  }
  fields.push_back(line.substr(begin));
  return nullptr;
}

}  // namespace

void CsvRows::Start(const CsvBlock& block) noexcept {
  unread_ = block.text;
  line_number_ = block.first_line_number - 1;
}

bool CsvRows::Next() {
  if (unread_.empty()) {
    return false;
  }
  line_ = CutLine(unread_);
  ++line_number_;
  if (line_.empty()) {
    Fail(kEmptyLine);
  }
  if (const char* flaw = SplitFields(line_, fields_, unquoted_)) {
    Fail(flaw);
  }
  if (fields_.size() != header_.columns.size()) {
    Fail(CountText(fields_.size(), "field") + ", expected " +
         std::to_string(header_.columns.size()) + " as in the header (" + header_.line + ")");
  }
  return true;
}

double CsvRows::Number(std::size_t column) const {
  const std::optional<double> number = FiniteNumber(Field(column));
  if (!number) {
    Fail(header_.columns[column] + " is '" + std::string(Field(column)) +
         "', expected a finite number such as 22.5");
  }
  return *number;
}

double CsvRows::NumberWithin(std::size_t column, double lower, double upper) const {
  const double number = Number(column);
  if (number < lower || number > upper) {
    Fail(header_.columns[column] + " is " + NumberText(number) + ", expected " + NumberText(lower) +
         " to " + NumberText(upper));
  }
  return number;
}

void CsvRows::Fail(const std::string& message) const {
  throw InputError(header_.file, line_number_, message);
}

CsvReader::CsvReader(std::istream& in, std::string name)
    : in_(in), header_{std::move(name), {}, 0, {}, {}}, rows_(header_) {
  ReadHeader();
  block_.first_line_number = header_.line_number + 1;
  rows_.Start(block_);
  std::vector<std::string_view> fields;
  std::string unquoted;
  if (const char* flaw = SplitFields(header_.line, fields, unquoted)) {
    Fail(flaw);
  }
  header_.columns.assign(fields.begin(), fields.end());
  for (auto column = columns().begin(); column != columns().end(); ++column) {
    if (column->empty()) {
      Fail("column " + std::to_string(column - columns().begin() + 1) + " has no name");
    }
    if (std::find(columns().begin(), column, *column) != column) {
      Fail("column '" + *column + "' is given twice. Rename or remove one");
    }
  }
}

// Finds the header, and leaves the text after it unread.
void CsvReader::ReadHeader() {
  CsvBlock block;
  std::string_view rest;
  std::string_view line;
  std::size_t line_number = 0;
  do {
    if (rest.empty()) {
      if (!TakeLines(block)) {
        throw InputError(name(), line_number_,
                         "no header line. The first line must name the columns");
      }
      rest = block.text;
      if (block.first_line_number == 1 && rest.starts_with(kByteOrderMark)) {
        rest.remove_prefix(kByteOrderMark.size());
      }
    }
    line = CutLine(rest);
    ++line_number;
    if (line.starts_with('#')) {
      header_.comments.emplace_back(line);
    }
  } while (line.empty() || line.front() == '#');
  header_.line = line;
  header_.line_number = line_number;
  unread_.insert(0, rest);
  lines_size_ = rest.size();
  line_number_ = line_number + 1;
}

bool CsvReader::HasLinesAtHand() {
  while (in_.good() && (unread_.size() < kBlockSize || lines_size_ == 0)) {
    const std::streamsize at_hand = in_.rdbuf()->in_avail();
    if (at_hand <= 0) {
      break;
    }
    const std::size_t old_size = unread_.size();
    const std::size_t size = std::min(static_cast<std::size_t>(at_hand), kBlockSize);
    unread_.resize(old_size + size);
    in_.read(unread_.data() + old_size, static_cast<std::streamsize>(size));
    unread_.resize(old_size + static_cast<std::size_t>(in_.gcount()));
    const std::size_t line_end = std::string_view(unread_).substr(old_size).rfind('\n');
    if (line_end != std::string_view::npos) {
      lines_size_ = old_size + line_end + 1;
    }
  }
  return lines_size_ > 0;
}

bool CsvReader::TakeLines(CsvBlock& block) {
  while (!HasLinesAtHand()) {
    if (in_.peek() != std::istream::traits_type::eof()) {
      continue;
    }
    if (in_.bad()) {
      throw InputError(name(), line_number_, "cannot be read");
    }
    // The last line has no line end.
    lines_size_ = unread_.size();
    break;
  }
  if (lines_size_ == 0) {
    return false;
  }
  block.text.assign(unread_, 0, lines_size_);
  block.first_line_number = line_number_;
  unread_.erase(0, lines_size_);
  lines_size_ = 0;
  line_number_ += CountLines(block.text);
  return true;
}

bool CsvReader::TakeBlock(CsvBlock& block) {
  if (!TakeLines(block)) {
    return false;
  }
  const std::size_t empty_lines = CutEmptyEnd(block.text);
  if (empty_line_number_ && !block.text.empty()) {
    throw InputError(name(), *empty_line_number_, kEmptyLine);
  }
  if (empty_lines > 0 && !empty_line_number_) {
    empty_line_number_ = line_number_ - empty_lines;
  }
  return true;
}

bool CsvReader::Next() {
  while (!rows_.Next()) {
    if (!TakeBlock(block_)) {
      return false;
    }
    rows_.Start(block_);
  }
  return true;
}

std::size_t CsvReader::Column(std::string_view column) const {
  const auto found = std::find(columns().begin(), columns().end(), column);
  if (found == columns().end()) {
    Fail("column '" + std::string(column) + "' is missing. The header has: " + Joined(columns()));
  }
  return static_cast<std::size_t>(found - columns().begin());
}

bool CsvReader::HasColumn(std::string_view column) const noexcept {
  return std::find(columns().begin(), columns().end(), column) != columns().end();
}

void CsvReader::ExpectOnlyColumns(const std::vector<std::string_view>& known) const {
  for (const std::string& column : columns()) {
    if (std::find(known.begin(), known.end(), column) == known.end()) {
      Fail("column '" + column + "' is not known. " + DidYouMean(column, known) +
           "Remove it or correct its name");
    }
  }
}

void CsvReader::ExpectNoneNearly(const std::vector<std::string_view>& known) const {
  for (const std::string& column : columns()) {
    ExpectNotNearly(column, known);
  }
}

void CsvReader::ExpectNotNearly(const std::string& column,
                                const std::vector<std::string_view>& known) const {
  // A name that is known counts as it is, even if another known name is nearly equal.
  if (std::find(known.begin(), known.end(), column) != known.end()) {
    return;
  }
  const auto meant = std::find_if(known.begin(), known.end(), [&column](std::string_view name) {
    return IsNearly(column, name);
  });
  if (meant != known.end()) {
    Fail("column '" + column + "' is not known. Did you mean '" + std::string(*meant) +
         "'? Correct its name, or give it one that is less alike");
  }
}

}  // namespace girdle
