// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// `girdle generate`: models as MJCF.
#pragma once

#include <CLI/CLI.hpp>

namespace girdle {

/// Adds the verb; its callback does the work and throws InputError.
void AddGenerateCommand(CLI::App& program);

}  // namespace girdle
