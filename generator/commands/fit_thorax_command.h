// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// `girdle fit-thorax`: the ellipsoid that the scapula glides on, fitted to an anatomy and a table.
#pragma once

#include <CLI/CLI.hpp>

namespace girdle {

/// Adds the verb; its callback does the work and throws InputError.
void AddFitThoraxCommand(CLI::App& program);

}  // namespace girdle
