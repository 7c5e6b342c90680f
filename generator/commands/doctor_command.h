// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// `girdle doctor`: which MuJoCo of this machine works with which plugin.
#pragma once

#include <CLI/CLI.hpp>

namespace girdle {

/// Adds the verb; its callback does the work and throws InputError. `status` becomes 1 if no MuJoCo
/// works.
void AddDoctorCommand(CLI::App& program, int& status);

}  // namespace girdle
