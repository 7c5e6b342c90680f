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
/// A row shows the residual that is nearest to its tolerance or exceeds it most: its value, its
/// tolerance, its pose, and how many residuals of its kind have a tolerance. A kind without any
/// tolerance shows its first residual. Poses are written as elevation/plane [deg].
[[nodiscard]] std::string SummaryAsText(const ResidualReport& report, const TextStyle& style);

/// The parts of the summary, for reports that put other text between them: the model with the
/// verdict, the table, the failures, and the remark with the verdict.
struct SummaryParts {
  std::string head;
  std::string table;
  std::string failures;  ///< empty if there are none
  std::string end;
};
[[nodiscard]] SummaryParts SummaryPartsOf(const ResidualReport& report, const TextStyle& style);

}  // namespace girdle
