// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The residual report as text and as JSON.
#pragma once

#include <string>

#include "residuals/residual.h"
#include "text/text_style.h"

namespace girdle {

/// How a report is written.
enum class ReportForm {
  kSummary,  ///< one line for each kind of residual, and every failure in full
  kFull,     ///< every residual
  kJson,     ///< every residual, for programs
};

/// Form of a report, and the width and colours of text.
struct ReportChoice {
  ReportForm form = ReportForm::kSummary;
  TextStyle style;
};

/// Returns all residuals as a table for people, the verdict last. The result of a residual is
/// `pass` or `FAIL`; `stated` if it has no tolerance; `follows` if it cannot be off unless another
/// residual is. Where the table is wider than the style allows, each kind stands under a heading
/// and the pose of the worst case stands on a line of its own.
[[nodiscard]] std::string ReportAsText(const ResidualReport& report, const TextStyle& style);

/// Returns the report as JSON: `model`, `kind`, `rhythm`, `mujoco`, `passed`, `remark`, and the
/// array `residuals`.
///
/// Each residual has `group`, `item`, `value`, `unit`, `tolerance` (null if the value is only
/// stated), `bound` (a word of kBoundNames: how the value must compare with the tolerance),
/// `follows` (whether the value can only be off if another line is), `passed`, and `where`. A value
/// that is not finite is null.
[[nodiscard]] std::string ReportAsJson(const ResidualReport& report);

/// Returns the report in the chosen form. The summary is that of report_summary.h.
[[nodiscard]] std::string ReportIn(const ReportChoice& choice, const ResidualReport& report);

}  // namespace girdle
