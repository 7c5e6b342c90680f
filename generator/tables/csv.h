// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Reading comma-separated text with the place of every value.
///
/// Accepted: `#` comment lines and empty lines before the header, a byte-order mark, Windows line
/// ends, a missing line end at the end, and fields in double quotes (with "" for a quote; no line
/// break inside).
#pragma once

#include <cstddef>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace girdle {

/// Reads rows one by one in constant memory. Every row has as many fields as the header; all errors
/// are InputError with file and line.
class CsvReader {
 public:
  /// Reads up to and including the header. `name` stands in messages for the file. Throws if there
  /// is no header, a column has no name or two have the same. `in` must outlive the reader.
  CsvReader(std::istream& in, std::string name);

  /// Reads the next row. Returns false at the end. Throws if the number of fields differs from the
  /// header's, a quote is not closed or the stream fails. Empty lines at the end are passed over,
  /// within the rows they are errors.
  [[nodiscard]] bool Next();

  [[nodiscard]] const std::vector<std::string>& columns() const noexcept { return columns_; }
  /// The comment lines before the header, each with its `#` and without its line end.
  [[nodiscard]] const std::vector<std::string>& comments() const noexcept { return comments_; }
  /// The header line as it stands in the file, without its line end.
  [[nodiscard]] const std::string& header_line() const noexcept { return header_line_; }

  /// Returns the position of a column. Throws if it is missing, naming those that are there.
  [[nodiscard]] std::size_t Column(std::string_view column) const;
  [[nodiscard]] bool HasColumn(std::string_view column) const noexcept;
  /// Throws if the file has a column that is not among `known`.
  void ExpectOnlyColumns(const std::vector<std::string_view>& known) const;

  /// The current row as it stands in the file, without its line end.
  [[nodiscard]] const std::string& line() const noexcept { return line_; }
  /// The text of a field of the current row, without quotes. Valid until the next call of Next.
  [[nodiscard]] std::string_view Field(std::size_t column) const { return fields_[column]; }
  /// Returns a field of the current row as a finite number. Throws otherwise.
  [[nodiscard]] double Number(std::size_t column) const;
  /// As Number, within [lower, upper].
  [[nodiscard]] double NumberWithin(std::size_t column, double lower, double upper) const;

  /// Throws InputError at the current row.
  [[noreturn]] void Fail(const std::string& message) const;

  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  /// Line number of the current row, from 1.
  [[nodiscard]] std::size_t line_number() const noexcept { return line_number_; }

 private:
  [[nodiscard]] bool ReadLine();
  void Split();

  std::istream& in_;
  std::string name_;
  std::vector<std::string> comments_;
  std::string header_line_;
  std::vector<std::string> columns_;
  std::string line_;
  std::string unquoted_;  ///< text of the quoted fields of the current row
  std::vector<std::string_view> fields_;
  std::size_t line_number_ = 0;
};

}  // namespace girdle
