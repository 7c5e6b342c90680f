// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Reading comma-separated text with the place of every value.
///
/// Accepted: `#` comment lines and empty lines before the header, a byte-order mark, Windows line
/// ends, a missing line end at the end, and fields in double quotes (with "" for a quote; no line
/// break inside).
///
/// CsvReader reads a file row by row. To share the work between threads, one at a time takes the
/// next CsvBlock from it and then reads the rows of that with CsvRows of its own.
#pragma once

#include <cstddef>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace girdle {

/// What the rows of a file have in common.
struct CsvHeader {
  std::string file;                   ///< stands in messages for the file
  std::string line;                   ///< as it stands in the file, without its line end
  std::size_t line_number = 0;        ///< from 1
  std::vector<std::string> columns;   ///< names, without quotes
  std::vector<std::string> comments;  ///< lines before it that begin with `#`, without line ends
};

/// Successive whole rows of a file, as they stand in it; the last may lack its line end.
struct CsvBlock {
  std::string text;
  std::size_t first_line_number = 0;  ///< in the file, from 1
};

/// Reads the rows of one block after the other. Every row has as many fields as the header; all
/// errors are InputError with file and line.
class CsvRows {
 public:
  /// Without rows as yet. `header` must outlive this.
  explicit CsvRows(const CsvHeader& header) : header_(header) {}

  /// Goes before the first row of `block`, which must stay as it is while its rows are read.
  void Start(const CsvBlock& block) noexcept;

  /// Reads the next row. Returns false at the end of the block. Throws if the number of fields
  /// differs from the header's, a quote is not closed or the line is empty.
  [[nodiscard]] bool Next();

  /// The current row as it stands in the file, without its line end. Valid as long as the block.
  [[nodiscard]] std::string_view line() const noexcept { return line_; }
  /// The text of a field of the current row, without quotes. Valid until the next call of Next.
  [[nodiscard]] std::string_view Field(std::size_t column) const { return fields_[column]; }
  /// Returns a field of the current row as a finite number. Throws otherwise.
  [[nodiscard]] double Number(std::size_t column) const;
  /// As Number, within [lower, upper].
  [[nodiscard]] double NumberWithin(std::size_t column, double lower, double upper) const;

  /// Throws InputError at the current row.
  [[noreturn]] void Fail(const std::string& message) const;

  /// Line number of the current row, from 1.
  [[nodiscard]] std::size_t line_number() const noexcept { return line_number_; }
  /// The name of a column in the header.
  [[nodiscard]] const std::string& ColumnName(std::size_t column) const {
    return header_.columns[column];
  }

 private:
  const CsvHeader& header_;
  std::string_view unread_;  ///< of the block
  std::string_view line_;
  std::vector<std::string_view> fields_;
  std::string unquoted_;  ///< text of the quoted fields of the current row
  std::size_t line_number_ = 0;
};

/// Reads rows one by one in constant memory. Every row has as many fields as the header; all errors
/// are InputError with file and line.
class CsvReader {
 public:
  /// Reads up to and including the header. `name` stands in messages for the file. Throws if there
  /// is no header, a column has no name or two have the same. `in` must outlive the reader.
  CsvReader(std::istream& in, std::string name);
  CsvReader(const CsvReader&) = delete;
  CsvReader& operator=(const CsvReader&) = delete;

  /// Reads the next row. Returns false at the end. Throws if the number of fields differs from the
  /// header's, a quote is not closed or the stream fails. Empty lines at the end are passed over,
  /// within the rows they are errors.
  [[nodiscard]] bool Next();

  /// Takes the next rows for a CsvRows to read, in place of Next: as many as the stream has at
  /// hand, a few kilobytes of them at most. There may be none in the block. Waits for the stream
  /// only if it has no whole line at hand. Returns false at the end. Throws if the stream fails or
  /// an empty line stands between this block and an earlier one.
  [[nodiscard]] bool TakeBlock(CsvBlock& block);
  /// Returns whether TakeBlock will not wait for the stream; false at the end, too.
  [[nodiscard]] bool HasLinesAtHand();

  [[nodiscard]] const CsvHeader& header() const noexcept { return header_; }
  [[nodiscard]] const std::vector<std::string>& columns() const noexcept { return header_.columns; }
  /// The comment lines before the header, each with its `#` and without its line end.
  [[nodiscard]] const std::vector<std::string>& comments() const noexcept {
    return header_.comments;
  }
  /// The header line as it stands in the file, without its line end.
  [[nodiscard]] const std::string& header_line() const noexcept { return header_.line; }

  /// Returns the position of a column. Throws if it is missing, naming those that are there.
  [[nodiscard]] std::size_t Column(std::string_view column) const;
  [[nodiscard]] bool HasColumn(std::string_view column) const noexcept;
  /// Throws if the file has a column that is not among `known`, whatever it is called: such a file
  /// has no others.
  void ExpectOnlyColumns(const std::vector<std::string_view>& known) const;
  /// Throws if a column is nearly one of `known` (IsNearly), with the one that is meant.
  void ExpectNoneNearly(const std::vector<std::string_view>& known) const;

  /// The current row, and what CsvRows says of it.
  [[nodiscard]] const CsvRows& row() const noexcept { return rows_; }
  [[nodiscard]] std::string_view line() const noexcept { return rows_.line(); }
  [[nodiscard]] std::string_view Field(std::size_t column) const { return rows_.Field(column); }
  [[nodiscard]] double Number(std::size_t column) const { return rows_.Number(column); }
  [[nodiscard]] double NumberWithin(std::size_t column, double lower, double upper) const {
    return rows_.NumberWithin(column, lower, upper);
  }
  [[noreturn]] void Fail(const std::string& message) const { rows_.Fail(message); }

  [[nodiscard]] const std::string& name() const noexcept { return header_.file; }
  /// Line number of the current row, from 1.
  [[nodiscard]] std::size_t line_number() const noexcept { return rows_.line_number(); }

 private:
  void ReadHeader();
  void ExpectNotNearly(const std::string& column, const std::vector<std::string_view>& known) const;
  /// As TakeBlock, with the empty lines.
  [[nodiscard]] bool TakeLines(CsvBlock& block);

  std::istream& in_;
  std::string unread_;                            ///< taken from the stream and not handed out
  std::size_t lines_size_ = 0;                    ///< of the whole lines in unread_
  std::size_t line_number_ = 1;                   ///< of the first line in unread_
  std::optional<std::size_t> empty_line_number_;  ///< of the first empty line behind the last row
  CsvHeader header_;
  CsvBlock block_;  ///< that Next reads
  CsvRows rows_;
};

}  // namespace girdle
