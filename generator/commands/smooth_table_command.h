// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// `girdle smooth-table`: a measured table without the steps of people who drop out.
#pragma once

#include <CLI/CLI.hpp>

namespace girdle {

/// Adds the verb; its callback does the work and throws InputError.
void AddSmoothTableCommand(CLI::App& program);

}  // namespace girdle
