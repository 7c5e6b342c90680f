// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The short form of the residual report, which people read.
#pragma once

#include <string>

#include "residuals/residual.h"
#include "text/text_style.h"

namespace girdle {

/// Returns the report in a few lines: the model, the verdict, a table with one row for each kind of
/// residual, every failure in full, and the verdict again.
///
/// A row shows the residual that comes nearest to its tolerance or exceeds it most: its value, its
/// tolerance, where it is, and how many residuals of its kind have a tolerance. A kind without any
/// tolerance shows its first residual. Poses are written as elevation/plane [deg], without the
/// motion or not at all where the style is too narrow.
[[nodiscard]] std::string SummaryAsText(const ResidualReport& report, const TextStyle& style);

/// The parts of a summary.
struct SummaryParts {
  std::string head;  ///< what the report is about, the verdict, and the remark
  std::string table;
  std::string failures;  ///< empty if there are none
  std::string end;       ///< how to see all, and the verdict
};

/// Returns the parts of the summary, for reports that put something of their own between them.
[[nodiscard]] SummaryParts SummaryPartsOf(const ResidualReport& report, const TextStyle& style);

}  // namespace girdle
