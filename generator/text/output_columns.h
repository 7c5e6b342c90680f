// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Columns of CSV files that are written, declared in one table: names, units, and formulas.
///
/// Each line of a table declares one or more columns of one kind. For rows of type `Step`, this
/// table gives the columns `time_s`, `x_m` and `y_m`:
///
///     constexpr std::array<OutputColumns<Step, Options>, 2> kColumns = {{
///         {TimeStem, kSeconds, [](const Step& step, std::size_t) -> Cell { return step.time_s; }},
///         {AxisStems, kMeters, [](const Step& step, std::size_t k) -> Cell { return step.p_m[k];
///         }},
///     }};
///
/// The functions TimeStem and AxisStems return {"time"} and {"x", "y"}. WrittenColumns makes the
/// header and the rows of an output from the table.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "text/number_text.h"

namespace girdle {

inline constexpr std::string_view kNoUnit;
inline constexpr std::string_view kSeconds = "s";
inline constexpr std::string_view kDegrees = "deg";
inline constexpr std::string_view kRadians = "rad";
inline constexpr std::string_view kMeters = "m";
inline constexpr std::string_view kMillimeters = "mm";

/// Returns the name of a column: `distance_deg` for the stem `distance` and the unit `deg`. Without
/// a unit, the name is the stem.
[[nodiscard]] std::string ColumnName(std::string_view stem, std::string_view unit);

/// Content of one column of a row: a number in the column's unit, or a word.
using Cell = std::variant<double, std::string_view>;

/// Columns of one kind, one beside the other.
template <typename Row, typename Options>
struct OutputColumns {
  /// Returns the stems of the columns' names. Empty if the output does not have these columns.
  std::vector<std::string> (*stems)(const Options& options);
  std::string_view unit;
  /// Returns the content of the k-th of these columns, from 0.
  Cell (*value)(const Row& row, std::size_t k);
};

/// Writes each number with the fewest digits that read back as exactly that number.
struct ExactNumbers {
  void operator()(std::string& text, double number) const { AppendNumber(text, number); }
};

/// Writes numbers rounded to a number of decimals.
struct RoundedNumbers {
  int decimals;             ///< not negative
  char decimal_mark = '.';  ///< point or comma
  void operator()(std::string& text, double number) const {
    const std::size_t begin = text.size();
    AppendRounded(text, number, decimals);
    if (decimal_mark != '.') {
      std::replace(text.begin() + static_cast<std::ptrdiff_t>(begin), text.end(), '.',
                   decimal_mark);
    }
  }
};

/// The columns of one output, with numbers as a NumberWriter appends them to a text, and a
/// separator between columns.
template <typename Row, typename NumberWriter>
class WrittenColumns {
 public:
  template <typename Options, std::size_t N>
  WrittenColumns(const std::array<OutputColumns<Row, Options>, N>& table, const Options& options,
                 NumberWriter write_number = {}, char separator = ',')
      : write_number_(write_number), separator_(separator) {
    for (const OutputColumns<Row, Options>& columns : table) {
      const std::vector<std::string> stems = columns.stems(options);
      for (std::size_t k = 0; k < stems.size(); ++k) {
        names_.push_back(ColumnName(stems[k], columns.unit));
        values_.push_back({columns.value, k});
      }
    }
  }

  [[nodiscard]] const std::vector<std::string>& names() const noexcept { return names_; }

  /// Returns the names with separators between them.
  [[nodiscard]] std::string Header() const {
    std::string text;
    for (const std::string& name : names_) {
      if (!text.empty()) {
        text += separator_;
      }
      text += name;
    }
    return text;
  }

  /// Appends the content of a row, with separators between the columns.
  void Append(std::string& text, const Row& row) const {
    bool is_first = true;
    for (const Value& value : values_) {
      if (!is_first) {
        text += separator_;
      }
      is_first = false;
      const Cell cell = value.of(row, value.k);
      if (const auto* const number = std::get_if<double>(&cell)) {
        write_number_(text, *number);
      } else {
        text += *std::get_if<std::string_view>(&cell);
      }
    }
  }

 private:
  struct Value {
    Cell (*of)(const Row& row, std::size_t k);
    std::size_t k;
  };

  NumberWriter write_number_;
  char separator_;
  std::vector<std::string> names_;
  std::vector<Value> values_;
};

}  // namespace girdle
