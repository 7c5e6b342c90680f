// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "text/csv.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "text/input_error.h"
#include "text/near_names.h"
#include "text/number_text.h"
#include "text/shown_text.h"
#include "text/small_letters.h"
#include "text/split.h"

namespace girdle {
namespace {

constexpr const char* kLineTooLong =
    "the line has more than 1 MiB. Check that the file is a table with line ends";
constexpr const char* kEmptyLine = "empty line between rows. Remove it";
// Bytes of a block. A block is large against the cost of passing it to another thread. It is small
// enough that a slow stream and a terminal with progress do not wait for it.
constexpr std::size_t kBlockSize = 8192;

// Takes the first line from `text` and returns it without its line end.
std::string_view CutLine(std::string_view& text) {
  const std::size_t size = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, size);
  text.remove_prefix(std::min(size + 1, text.size()));
  return line;
}

// Removes the empty lines at the end of `text` and returns their number.
std::size_t CutEmptyEnd(std::string& text) {
  const std::size_t last = text.find_last_not_of('\n');
  // The first line end behind a row belongs to the row.
  const std::size_t end = last == std::string::npos ? 0 : std::min(last + 2, text.size());
  const std::size_t count = text.size() - end;
  text.resize(end);
  return count;
}

std::size_t CountLines(const std::string& text) {
  const auto line_ends = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  return line_ends + (text.empty() || text.back() == '\n' ? 0 : 1);
}

// Returns the fix for a field that is not a number.
std::string NumberMend(std::string_view field, const CsvDialect& dialect) {
  const bool has_point = field.find('.') != std::string_view::npos;
  const bool has_comma = field.find(',') != std::string_view::npos;
  const std::string example = dialect.decimal_mark == ',' ? "22,5" : "22.5";
  std::string expected = "expected a finite number such as " + example;
  if (has_point && has_comma) {
    return expected + ", with one decimal mark and none between thousands";
  }
  if (dialect.separator == ',') {
    return expected + (HasDecimalMark(field, ',')
                           ? ". Write a decimal point, or separate the columns by semicolons"
                           : "");
  }
  const char other = dialect.decimal_mark == ',' ? '.' : ',';
  if (HasDecimalMark(field, other)) {
    return expected + ": the decimal mark of this file is a " +
           (dialect.decimal_mark == ',' ? "comma" : "point") +
           ". Write all its numbers with one mark, from the first row on";
  }
  return expected;
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
  if (const char* flaw = SplitFields(line_, header_.dialect.separator, fields_, unquoted_)) {
    Fail(flaw);
  }
  if (fields_.size() != header_.columns.size()) {
    Fail(CountText(fields_.size(), "field") + ", expected " +
         std::to_string(header_.columns.size()) + " as in the header (" +
         ShortText(header_.line, kMostShownOfHeader) + ")");
  }
  return true;
}

double CsvRows::Number(std::size_t column) const {
  const std::string_view field = Field(column);
  const std::optional<double> number = FiniteNumber(field, header_.dialect.decimal_mark);
  if (!number) {
    Fail(ShortText(header_.columns[column]) + " is '" + ShortText(field) + "', " +
         NumberMend(field, header_.dialect));
  }
  return *number;
}

bool CsvRows::IsGap(std::size_t column) const {
  const std::string_view field = Field(column);
  return field.empty() || field == "NA" || field == "#N/A" || InSmallLetters(field) == "nan";
}

std::optional<double> CsvRows::NumberOrGap(std::size_t column) const {
  const std::optional<double> number = FiniteNumber(Field(column), header_.dialect.decimal_mark);
  if (!number && !IsGap(column)) {
    return Number(column);  // throws
  }
  return number;
}

double CsvRows::NumberWithin(std::size_t column, double lower, double upper) const {
  const double number = Number(column);
  if (number < lower || number > upper) {
    Fail(ShortText(header_.columns[column]) + " is " + NumberText(number) + ", expected " +
         NumberText(lower) + " to " + NumberText(upper));
  }
  return number;
}

void CsvRows::Fail(const std::string& message) const {
  throw InputError(header_.file, line_number_, message);
}

CsvReader::CsvReader(std::istream& in, std::string name, std::span<const std::string_view> example)
    : in_(in), rows_(header_) {
  header_.file = std::move(name);
  ReadHeader();
  block_.first_line_number = header_.line_number + 1;
  rows_.Start(block_);
  ReadNames(example);
}

// Finds the header, and leaves the text after it unread.
void CsvReader::ReadHeader() {
  CsvBlock block;
  std::string_view rest;
  std::string_view line;
  std::size_t line_number = 0;
  std::size_t size = 0;
  do {
    if (rest.empty()) {
      if (!TakeLines(block)) {
        throw InputError(name(), line_number_,
                         "no header line. The first line must name the columns");
      }
      rest = block.text;
    }
    line = CutLine(rest);
    ++line_number;
    size += line.size() + 1;
    if (size > kMostBeforeCsvHeader) {
      throw InputError(name(), line_number,
                       "no header in the first " + CountText(kMostBeforeCsvHeader, "byte") +
                           ". The first line that is no comment must name the columns");
    }
    if (line.starts_with('#')) {
      header_.comments.emplace_back(line);
    } else if (NamesSeparator(line) && header_.dialect.separator_line.empty()) {
      TakeSeparatorLine(line, line_number);
      line = {};
    }
  } while (line.empty() || line.front() == '#');
  header_.line = line;
  header_.line_number = line_number;
  unread_.insert(0, rest);
  lines_size_ = rest.size();
  line_number_ = line_number + 1;
}

void CsvReader::TakeSeparatorLine(std::string_view line, std::size_t line_number) {
  const std::optional<char> separator = NamedSeparator(line);
  if (!separator) {
    throw InputError(name(), line_number,
                     "'" + std::string(line) +
                         "' names an unknown separator. Separate the columns by commas, semicolons "
                         "or tabs");
  }
  header_.dialect.separator = *separator;
  header_.dialect.separator_line = line;
}

void CsvReader::ReadNames(std::span<const std::string_view> example) {
  if (header_.dialect.separator_line.empty()) {
    const ShownSeparator shown = SeparatorOf(header_.line);
    if (shown.rival) {
      Fail("two separators make equally many columns of the header (" +
           ShortText(header_.line, kMostShownOfHeader) +
           "). Put the line sep=, or sep=; before it to choose one");
    }
    header_.dialect.separator = shown.separator;
  }
  std::vector<std::string_view> fields;
  std::string unquoted;
  if (const char* flaw = SplitFields(header_.line, header_.dialect.separator, fields, unquoted)) {
    Fail(flaw);
  }
  if (fields.size() > kMostCsvColumns) {
    Fail(CountText(fields.size(), "column") + ", at most " + std::to_string(kMostCsvColumns) +
         " are read. Remove those that are not needed");
  }
  if (AreNumbers(fields)) {
    std::string names;
    for (std::size_t i = 0; i < std::min(fields.size(), example.size()); ++i) {
      names += (i > 0 ? std::string(1, header_.dialect.separator) : "") + std::string(example[i]);
    }
    Fail("the first line has numbers, not names. Put a line before it that names " +
         (fields.size() == 1 ? "its column" : "its " + CountText(fields.size(), "column")) +
         (names.empty() ? "" : ", in their order, such as " + names));
  }
  for (const std::string_view field : fields) {
    header_.columns.emplace_back(WithoutBlanks(field));
  }
  std::unordered_set<std::string_view> earlier;
  for (std::size_t i = 0; i < columns().size(); ++i) {
    if (columns()[i].empty()) {
      Fail("column " + std::to_string(i + 1) + " has no name. Give it one, or remove the column");
    }
    if (!earlier.insert(columns()[i]).second) {
      Fail("column '" + ShortText(columns()[i]) + "' is given twice. Rename or remove one");
    }
  }
}

bool CsvReader::HasLinesAtHand() {
  while (in_.good() && flaw_ == nullptr && (unread_.size() < kBlockSize || lines_size_ == 0)) {
    const std::streamsize at_hand = in_.rdbuf()->in_avail();
    if (at_hand <= 0) {
      break;
    }
    const std::size_t old_size = unread_.size();
    const std::size_t size = std::min(static_cast<std::size_t>(at_hand), kBlockSize);
    unread_.resize(old_size + size);
    in_.read(unread_.data() + old_size, static_cast<std::streamsize>(size));
    unread_.resize(old_size + static_cast<std::size_t>(in_.gcount()));
    flaw_ = decoder_.Decode(unread_, old_size);
    const std::string_view decoded = std::string_view(unread_).substr(old_size);
    const std::size_t first_end = std::min(decoded.find('\n'), decoded.size());
    if (lines_size_ == 0 && old_size + first_end > kLongestCsvLine) {
      flaw_ = kLineTooLong;
      break;
    }
    const std::size_t line_end = decoded.rfind('\n');
    if (line_end != std::string_view::npos) {
      lines_size_ = old_size + line_end + 1;
    }
  }
  return lines_size_ > 0;
}

bool CsvReader::WaitForLines() {
  while (!HasLinesAtHand()) {
    if (flaw_ == nullptr && in_.peek() != std::istream::traits_type::eof()) {
      continue;
    }
    if (in_.bad()) {
      throw InputError(name(), line_number_, "cannot be read");
    }
    if (flaw_ == nullptr) {
      flaw_ = decoder_.Finish(unread_);
    }
    if (flaw_ != nullptr) {
      throw InputError(name(), line_number_, flaw_);
    }
    // The last line has no line end.
    lines_size_ = unread_.size();
    break;
  }
  return lines_size_ > 0;
}

bool CsvReader::TakeLines(CsvBlock& block) {
  if (!WaitForLines()) {
    return false;
  }
  block.text.assign(unread_, 0, lines_size_);
  block.first_line_number = line_number_;
  unread_.erase(0, lines_size_);
  lines_size_ = 0;
  line_number_ += CountLines(block.text);
  return true;
}

void CsvReader::FindDecimalMark() {
  CsvDialect& dialect = header_.dialect;
  if (is_mark_found_ || dialect.separator == ',') {
    return;
  }
  dialect.decimal_mark = dialect.separator == ';' ? ',' : '.';
  std::string_view rest = WaitForLines() ? std::string_view(unread_).substr(0, lines_size_) : "";
  is_mark_found_ = true;
  std::vector<std::string_view> fields;
  std::string unquoted;
  for (std::size_t line_number = line_number_; !rest.empty(); ++line_number) {
    // A line with a fault is reported when it is read.
    static_cast<void>(SplitFields(CutLine(rest), dialect.separator, fields, unquoted));
    const auto with = [&fields](char decimal_mark) {
      return std::find_if(fields.begin(), fields.end(), [decimal_mark](std::string_view field) {
        return HasDecimalMark(WithoutBlanks(field), decimal_mark);
      });
    };
    const auto comma = with(',');
    const auto point = with('.');
    if (comma != fields.end() && point != fields.end()) {
      throw InputError(name(), line_number,
                       "'" + ShortText(WithoutBlanks(*comma)) + "' has a decimal comma and '" +
                           ShortText(WithoutBlanks(*point)) +
                           "' a decimal point. Write all numbers of the file with one mark");
    }
    if (comma != fields.end() || point != fields.end()) {
      dialect.decimal_mark = comma != fields.end() ? ',' : '.';
      return;
    }
  }
}

bool CsvReader::TakeBlock(CsvBlock& block) {
  FindDecimalMark();
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
    Fail("column '" + std::string(column) +
         "' is missing. The header has: " + ShortText(Joined(columns()), kMostShownOfHeader));
  }
  return static_cast<std::size_t>(found - columns().begin());
}

bool CsvReader::HasColumn(std::string_view column) const noexcept {
  return std::find(columns().begin(), columns().end(), column) != columns().end();
}

void CsvReader::ExpectOnlyColumns(const std::vector<std::string_view>& known) const {
  for (const std::string& column : columns()) {
    if (std::find(known.begin(), known.end(), column) == known.end()) {
      Fail("column '" + ShortText(column) + "' is not known. " + DidYouMean(column, known) +
           "Remove it or correct its name");
    }
  }
}

}  // namespace girdle
