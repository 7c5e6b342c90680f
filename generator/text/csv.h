// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Reading comma-separated text with the place of every value.
///
/// Accepted: `#` comment lines and empty lines before the header, a byte-order mark, Windows line
/// ends, a missing line end at the end, and fields in double quotes (with "" for a quote; no line
/// break inside).
///
/// CsvReader reads a file row by row. Threads can share the work: one at a time takes the next
/// CsvBlock from the reader, and then reads the block's rows with its own CsvRows.
#pragma once

#include <cstddef>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace girdle {

/// Header of a file, which all its rows have in common.
struct CsvHeader {
  std::string file;                   ///< the file's name in messages
  std::string line;                   ///< header as in the file, without its line end
  std::size_t line_number = 0;        ///< from 1
  std::vector<std::string> columns;   ///< names, without quotes
  std::vector<std::string> comments;  ///< lines before it that begin with `#`, without line ends
};

/// Successive whole rows of a file, unchanged. The last row may lack its line end.
struct CsvBlock {
  std::string text;
  std::size_t first_line_number = 0;  ///< in the file, from 1
};

/// Reads the rows of one block after the other. Every row has as many fields as the header; all
/// errors are InputError with file and line.
class CsvRows {
 public:
  /// Begins without rows. `header` must outlive this.
  explicit CsvRows(const CsvHeader& header) : header_(header) {}

  /// Moves to before the first row of `block`, which must not change while its rows are read.
  void Start(const CsvBlock& block) noexcept;

  /// Reads the next row. Returns false at the end of the block. Throws if the number of fields
  /// differs from the header's, a quote is not closed or the line is empty.
  [[nodiscard]] bool Next();

  /// The current row as in the file, without its line end. Valid as long as the block.
  [[nodiscard]] std::string_view line() const noexcept { return line_; }
  /// The text of a field of the current row, without quotes. Valid until the next call of Next.
  [[nodiscard]] std::string_view Field(std::size_t column) const { return fields_[column]; }
  /// Returns a field of the current row as a finite number. Throws otherwise.
  [[nodiscard]] double Number(std::size_t column) const;
  /// Returns a field as Number does. Throws too if it is outside [lower, upper].
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
  /// Reads the file up to and including the header. `name` is the file's name in messages. Throws
  /// if there is no header, if a column has no name, or if two columns have the same name. `in`
  /// must outlive the reader.
  CsvReader(std::istream& in, std::string name);
  CsvReader(const CsvReader&) = delete;
  CsvReader& operator=(const CsvReader&) = delete;

  /// Reads the next row. Returns false at the end. Throws if the number of fields differs from the
  /// header's, a quote is not closed, the stream fails, or an empty line is between rows. Empty
  /// lines at the end are skipped.
  [[nodiscard]] bool Next();

  /// Takes the next rows for a CsvRows, in place of Next. The block has the rows that the stream
  /// has ready, at most a few kilobytes; it may be empty. Waits for the stream only if no whole
  /// line is ready. Returns false at the end. Throws if the stream fails, or if an empty line lies
  /// between this block and an earlier one.
  [[nodiscard]] bool TakeBlock(CsvBlock& block);
  /// Returns whether TakeBlock can answer without waiting for the stream. False at the end, too.
  [[nodiscard]] bool HasLinesAtHand();

  [[nodiscard]] const CsvHeader& header() const noexcept { return header_; }
  [[nodiscard]] const std::vector<std::string>& columns() const noexcept { return header_.columns; }
  /// The comment lines before the header, each with its `#` and without its line end.
  [[nodiscard]] const std::vector<std::string>& comments() const noexcept {
    return header_.comments;
  }
  /// The header line as in the file, without its line end.
  [[nodiscard]] const std::string& header_line() const noexcept { return header_.line; }

  /// Returns the position of a column. Throws if it is missing, with the names of the file's
  /// columns.
  [[nodiscard]] std::size_t Column(std::string_view column) const;
  [[nodiscard]] bool HasColumn(std::string_view column) const noexcept;
  /// Throws if the file has a column that is not among `known`. This is for formats that have no
  /// other columns.
  void ExpectOnlyColumns(const std::vector<std::string_view>& known) const;
  /// Throws if the name of a column is nearly one of `known` (IsNearly), with the name that is
  /// meant.
  void ExpectNoneNearly(const std::vector<std::string_view>& known) const;

  /// The current row, whose fields the functions of CsvRows return.
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
  /// Takes lines as TakeBlock does, with empty lines among them.
  [[nodiscard]] bool TakeLines(CsvBlock& block);

  std::istream& in_;
  std::string unread_;                            ///< taken from the stream, not handed out
  std::size_t lines_size_ = 0;                    ///< of the whole lines in unread_
  std::size_t line_number_ = 1;                   ///< of the first line in unread_
  std::optional<std::size_t> empty_line_number_;  ///< of the first empty line behind the last row
  CsvHeader header_;
  CsvBlock block_;  ///< the block that Next reads
  CsvRows rows_;
};

}  // namespace girdle
