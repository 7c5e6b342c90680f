// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// `girdle compare`: published shoulder rhythms beside the measured one.
#pragma once

#include <CLI/CLI.hpp>

namespace girdle {

/// Adds the verb; its callback does the work and throws InputError.
void AddCompareCommand(CLI::App& program);

}  // namespace girdle
