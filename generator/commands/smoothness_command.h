// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// `girdle smoothness`: how smooth the interpolations are, and what a rhythm keeps.
#pragma once

#include <CLI/CLI.hpp>

namespace girdle {

/// Adds the verb; `status` becomes 1 if a check fails.
void AddSmoothnessCommand(CLI::App& program, int& status);

}  // namespace girdle
