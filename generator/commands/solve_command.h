// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// `girdle solve`: joint angles for one arm position or for a file of them.
#pragma once

#include <CLI/CLI.hpp>

namespace girdle {

/// Adds the verb; its callback does the work and throws InputError.
void AddSolveCommand(CLI::App& program);

}  // namespace girdle
