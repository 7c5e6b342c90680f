// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Separators, decimal marks and fields of tables as different programs write them.
///
/// A spreadsheet in a country with decimal commas separates columns by semicolons. A copied table
/// has tabs.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace girdle {

/// How the rows of a table are written.
struct CsvDialect {
  char separator = ',';          ///< comma, semicolon or tab
  char decimal_mark = '.';       ///< point; or comma, if the separator is none
  std::string separator_line{};  ///< the line before the header that names the separator, `sep=;`
};

/// Returns whether a line names a separator, as spreadsheets write it before a header: `sep=;`.
[[nodiscard]] bool NamesSeparator(std::string_view line) noexcept;
/// Returns the separator that such a line names: comma, semicolon or tab. Nothing for another one.
/// Precondition: NamesSeparator(line).
[[nodiscard]] std::optional<char> NamedSeparator(std::string_view line) noexcept;

/// The separator that a first line shows.
struct ShownSeparator {
  char separator = ',';
  /// Another separator that splits the line into as many fields, if there is one.
  std::optional<char> rival = std::nullopt;
};

/// Returns the separator that splits a line into the most fields, or into numbers only. The comma
/// if there is none.
[[nodiscard]] ShownSeparator SeparatorOf(std::string_view line);

/// Splits a line into its fields, which are views of the line or of `unquoted`. Fields may be in
/// double quotes, with blanks around the quotes. Blanks at the ends of other fields stay. Returns a
/// fault, or null.
[[nodiscard]] const char* SplitFields(std::string_view line, char separator,
                                      std::vector<std::string_view>& fields, std::string& unquoted);

/// Returns `text` without blanks and tabs at its ends.
[[nodiscard]] std::string_view WithoutBlanks(std::string_view text) noexcept;

/// Returns whether all fields are numbers with a decimal point, a decimal comma or no mark. Blanks
/// around them do not matter.
[[nodiscard]] bool AreNumbers(const std::vector<std::string_view>& fields) noexcept;

/// Returns whether `text` is a number with this decimal mark in it.
[[nodiscard]] bool HasDecimalMark(std::string_view text, char decimal_mark) noexcept;

}  // namespace girdle
