// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Trying libraries of MuJoCo and plugins for real, each in a process of its own: a broken file
/// harms nobody else, and two engines never meet. Nothing here is linked with MuJoCo.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "engines/engine_version.h"

namespace girdle {

/// What came of opening a file. Either has a version or a problem, or both where the file could be
/// opened and then failed.
struct Trial {
  std::optional<EngineVersion> version;
  std::string problem;  ///< one line; empty if all went well
};

/// Opens a library of MuJoCo and asks for its version.
[[nodiscard]] Trial OpenEngine(const std::filesystem::path& engine);

/// Opens an engine plugin of Girdle, without any MuJoCo, and asks which version it is built for.
[[nodiscard]] Trial OpenPlugin(const std::filesystem::path& plugin);

/// Opens `engine`, loads `plugin` as any user of MuJoCo does, and with it loads `model`, MJCF text
/// that uses the plugin, and steps it. Any warning of MuJoCo is a problem.
[[nodiscard]] Trial TryPlugin(const std::filesystem::path& engine,
                              const std::filesystem::path& plugin, const std::string& model);

/// Opens a library that is linked with MuJoCo. Returns which library of MuJoCo came with it, or an
/// empty path, with the loader's reason in `problem`.
[[nodiscard]] std::filesystem::path EngineOfModule(const std::filesystem::path& module,
                                                   std::string& problem);

}  // namespace girdle
