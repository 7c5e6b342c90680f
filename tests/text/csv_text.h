// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Comma-separated text that a test changes in one place, and the message that this should give.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace girdle {

/// Columns and cells of a file without quotes; its comments are left out, so that the header is
/// line 1 and row i is line i + 2.
class CsvText {
 public:
  explicit CsvText(std::string_view text) {
    std::istringstream in{std::string(text)};
    for (std::string line; std::getline(in, line);) {
      if (line.empty() || line.front() == '#') continue;
      (columns.empty() ? columns : rows.emplace_back()) = Split(line);
    }
  }

  [[nodiscard]] std::string Text() const {
    std::string text = Joined(columns);
    for (const std::vector<std::string>& row : rows) text += "\n" + Joined(row);
    return text + "\n";
  }

  [[nodiscard]] std::size_t Column(const std::string& column) const {
    const auto found = std::find(columns.begin(), columns.end(), column);
    if (found == columns.end()) throw std::logic_error("the test names no column " + column);
    return static_cast<std::size_t>(found - columns.begin());
  }

  /// The cell of row `row`.
  std::string& Cell(std::size_t row, const std::string& column) {
    return rows.at(row).at(Column(column));
  }

  void RemoveColumn(const std::string& column) {
    const auto index = static_cast<std::ptrdiff_t>(Column(column));
    columns.erase(columns.begin() + index);
    for (std::vector<std::string>& row : rows) row.erase(row.begin() + index);
  }

  void AddColumn(const std::string& column, const std::string& cell) {
    columns.push_back(column);
    for (std::vector<std::string>& row : rows) row.push_back(cell);
  }

  void RemoveRow(std::size_t row) { rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(row)); }

  /// Keeps the rows whose cell is `value`.
  void KeepRows(const std::string& column, const std::string& value) {
    const std::size_t index = Column(column);
    std::vector<std::vector<std::string>> kept;
    for (const std::vector<std::string>& row : rows) {
      if (row.at(index) == value) kept.push_back(row);
    }
    rows = kept;
  }

  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;

 private:
  static std::vector<std::string> Split(const std::string& line) {
    std::vector<std::string> fields(1);
    for (const char c : line) {
      if (c == ',') {
        fields.emplace_back();
      } else {
        fields.back() += c;
      }
    }
    return fields;
  }

  static std::string Joined(const std::vector<std::string>& fields) {
    std::string line;
    for (const std::string& field : fields) line += (&field == &fields[0] ? "" : ",") + field;
    return line;
  }
};

/// One change of a valid text, and what has to be said about it.
struct CsvFlaw {
  const char* name;
  std::function<void(CsvText&)> change;
  const char* message;
};

inline void PrintTo(const CsvFlaw& flaw, std::ostream* out) { *out << flaw.name; }

/// The text of the exception of type `Error` that `call` throws; a text that says so if it throws
/// none.
template <typename Error, typename Call>
std::string MessageOf(Call&& call) {
  try {
    std::forward<Call>(call)();
  } catch (const Error& error) {
    return error.what();
  }
  return "(nothing was thrown)";
}

}  // namespace girdle
