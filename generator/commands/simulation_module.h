// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Finding and loading the parts of Girdle that run MuJoCo.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>

#include "engine_verbs/module.h"

namespace girdle {

/// Adds `--plugin FILE`.
void AddPluginArgument(CLI::App& verb, std::string& plugin);

/// Returns `plugin`, or if it is empty the plugin that belongs to this program.
[[nodiscard]] std::string ChosenPlugin(const std::string& plugin);

/// Returns the folder that the program lies in.
[[nodiscard]] std::filesystem::path ProgramFolder();

/// Returns where the library that runs MuJoCo is, or would be.
[[nodiscard]] std::filesystem::path SimulationFile();

/// Returns whether the library that runs MuJoCo was built with this program.
[[nodiscard]] bool HasSimulation();

/// Loads that library, once. Throws InputError that says what is missing.
[[nodiscard]] const SimulationModule& LoadSimulation();

}  // namespace girdle
