// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// `girdle verify`: the residual report of a model.
#pragma once

#include <CLI/CLI.hpp>

namespace girdle {

/// Adds the verb; its callback does the work and throws InputError. `status` becomes 1 if a
/// residual is above its tolerance.
void AddVerifyCommand(CLI::App& program, int& status);

}  // namespace girdle
