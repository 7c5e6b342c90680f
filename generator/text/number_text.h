// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Numbers as text: strict reading, and writing that is as short as possible or rounded. The locale
/// has no effect.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace girdle {

/// Returns the finite number that is the whole of `text`, or nothing. `4O`, `nan`, `inf`, an empty
/// text, blanks, and anything after the number are refused. A leading `+` is allowed. The decimal
/// mark is a point, or a comma if that is given.
[[nodiscard]] std::optional<double> FiniteNumber(std::string_view text,
                                                 char decimal_mark = '.') noexcept;

/// Appends the shortest decimals that read back as exactly `value`.
void AppendNumber(std::string& text, double value);

/// Returns the shortest decimals that read back as exactly `value`.
[[nodiscard]] std::string NumberText(double value);

/// Returns `value` rounded to `digits` significant digits, in the shortest form.
[[nodiscard]] std::string SignificantText(double value, int digits);

/// Most decimals that AppendRounded writes fast.
inline constexpr int kMostFastDecimals = 12;

/// Appends `value` rounded to `decimals` places in fixed notation. Halves are rounded to the even
/// digit. Trailing zeros and a sign before zero are left out. The text is that of RoundedText; for
/// |value| < 1000 and `decimals` up to kMostFastDecimals it takes about a tenth of the time.
void AppendRounded(std::string& text, double value, int decimals);

/// Returns `value` rounded to `decimals` places, without trailing zeros; for tables that people
/// read.
[[nodiscard]] std::string RoundedText(double value, int decimals);

/// Returns a count with what is counted: `1 row`, `2 rows`. The noun's plural has an s.
[[nodiscard]] std::string CountText(std::uintmax_t count, std::string_view noun);

}  // namespace girdle
