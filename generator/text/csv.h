// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Reading tables of text (CSV) with the place of every value.
///
/// Accepted: `#` comment lines and empty lines before the header; what TextDecoder takes (UTF-8,
/// UTF-16 with a byte-order mark; line ends of every system); a missing line end at the end; fields
/// in double quotes (with "" for a quote; no line break inside); blanks around fields and names.
/// The first line may name the separator: `sep=;`.
///
/// The header shows the separator (SeparatorOf). If it is a semicolon or a tab, the first rows show
/// the decimal mark. Numbers with another mark are errors. If the first rows have no decimals, the
/// mark is a comma in a file with semicolons and a point in a file with tabs.
///
/// CsvReader reads a file row by row. Threads can share the work: one at a time takes the next
/// CsvBlock from the reader, and then reads the block's rows with its own CsvRows.
#pragma once

#include <cstddef>
#include <istream>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "text/csv_dialect.h"
#include "text/text_decoder.h"

namespace girdle {

/// Most columns of a table.
inline constexpr std::size_t kMostCsvColumns = 4096;
/// Most bytes of a line, 1 MiB.
inline constexpr std::size_t kLongestCsvLine = std::size_t{1} << 20;
/// Most bytes of comments and empty lines before a header, 16 MiB.
inline constexpr std::size_t kMostBeforeCsvHeader = std::size_t{1} << 24;

/// Header of a file, which all its rows have in common.
struct CsvHeader {
  std::string file;                   ///< the file's name in messages
  std::string line;                   ///< header as in the file, without its line end
  std::size_t line_number = 0;        ///< from 1
  std::vector<std::string> columns;   ///< names, without quotes and blanks around them
  std::vector<std::string> comments;  ///< lines before it that begin with `#`, without line ends
  CsvDialect dialect;                 ///< of all rows
};

/// Successive whole rows of a file, as UTF-8 with line feeds, otherwise unchanged. The last row may
/// lack its line end.
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
  /// The text of a field of the current row, without quotes and blanks around it. Valid until the
  /// next call of Next.
  [[nodiscard]] std::string_view Field(std::size_t column) const {
    return WithoutBlanks(fields_[column]);
  }
  /// Returns a field of the current row as a finite number. Throws otherwise.
  [[nodiscard]] double Number(std::size_t column) const;
  /// Returns whether a field of the current row is a gap of a recording: an empty field, `NA`,
  /// `#N/A`, or `NaN` in small or capital letters.
  [[nodiscard]] bool IsGap(std::size_t column) const;
  /// Returns a field as Number does; nothing if it is a gap.
  [[nodiscard]] std::optional<double> NumberOrGap(std::size_t column) const;
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
  /// if there is no header, if a column has no name, if two columns have the same name, or if the
  /// file exceeds kMostCsvColumns, kLongestCsvLine or kMostBeforeCsvHeader. `example` are names
  /// that the message about a missing header shows. `in` must outlive the reader.
  CsvReader(std::istream& in, std::string name, std::span<const std::string_view> example = {});
  CsvReader(const CsvReader&) = delete;
  CsvReader& operator=(const CsvReader&) = delete;

  /// Waits for the first row, which may show the decimal mark, unless the separator is a comma.
  /// Next and TakeBlock do so, too. Throws if a row has numbers with both marks.
  void FindDecimalMark();

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
  /// Bytes of the file for each byte of a plain text of it: 2 for UTF-16, otherwise 1.
  [[nodiscard]] std::size_t bytes_per_unit() const noexcept { return decoder_.bytes_per_unit(); }
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
  void ReadNames(std::span<const std::string_view> example);
  /// Takes the separator from the line before the header. Throws for an unknown one.
  void TakeSeparatorLine(std::string_view line, std::size_t line_number);
  /// Waits until whole lines are at hand. Returns false at the end.
  [[nodiscard]] bool WaitForLines();
  /// Takes lines as TakeBlock does, with empty lines among them.
  [[nodiscard]] bool TakeLines(CsvBlock& block);

  std::istream& in_;
  TextDecoder decoder_;
  const char* flaw_ = nullptr;                    ///< of the text behind unread_
  bool is_mark_found_ = false;                    ///< whether FindDecimalMark has run
  std::string unread_;                            ///< taken from the stream, not handed out
  std::size_t lines_size_ = 0;                    ///< of the whole lines in unread_
  std::size_t line_number_ = 1;                   ///< of the first line in unread_
  std::optional<std::size_t> empty_line_number_;  ///< of the first empty line behind the last row
  CsvHeader header_;
  CsvBlock block_;  ///< the block that Next reads
  CsvRows rows_;
};

}  // namespace girdle
