// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Texts that the full report and its summary have in common.
#pragma once

#include <cstddef>
#include <string>

#include "residuals/residual.h"
#include "text/text_style.h"

namespace girdle {

/// Returns what the report is about: model, kind, rhythm, engine. Each begins a line, and lines are
/// wrapped at `width`. A longer path of the model loses its beginning.
[[nodiscard]] std::string SubjectText(const ResidualReport& report, std::size_t width);

/// Returns the verdict in one sentence that begins with PASS or FAIL: how many residuals are
/// outside their tolerances, of how many that have one. It is wrapped and coloured as the style
/// allows, and ends in a line end.
[[nodiscard]] std::string VerdictText(const ResidualReport& report, const TextStyle& style);

/// Returns the remark of the report, wrapped, with a line end; an empty text if there is none.
[[nodiscard]] std::string RemarkText(const ResidualReport& report, const TextStyle& style);

/// Returns a residual's value with three significant digits; `nan`, `inf` or `-inf` for a value
/// that is not finite.
[[nodiscard]] std::string ValueText(double value);

/// Returns the tolerance of a residual as ValueText, with `> ` before it if the value has to be
/// more than it, and `-` if it has none.
[[nodiscard]] std::string ToleranceText(const Residual& residual);

/// Returns the bytes of the longest line.
[[nodiscard]] std::size_t WidestLine(const std::string& text);

}  // namespace girdle
