// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The residual report as text.
#pragma once

#include <string>

#include "residuals/residual.h"

namespace girdle {

/// Returns the report as a table for people, one line a residual, the verdict last. The result of a
/// line is `pass` or `FAIL`; `stated` where it has no tolerance; `follows` where it cannot be off
/// unless another line is.
[[nodiscard]] std::string ReportAsText(const ResidualReport& report);

/// Returns the report as JSON: `model`, `kind`, `rhythm`, `mujoco`, `passed` and the array
/// `residuals` of `group`, `item`, `value`, `unit`, `tolerance` (null where the value is only
/// stated), `bound` (a word of kBoundNames: what the value has to be to it), `follows` (whether it
/// cannot be off unless another line is), `passed`, `where`. A value that is not finite is null.
[[nodiscard]] std::string ReportAsJson(const ResidualReport& report);

}  // namespace girdle
