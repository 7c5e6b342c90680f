// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Trying libraries of MuJoCo and the plugin for real, each in a process of its own: a broken file
/// harms nobody else, and two engines never meet. Nothing here is linked with MuJoCo.
#pragma once

#include <filesystem>
#include <string>

namespace girdle {

/// What came of opening a file: an answer or a problem, or both where the file could be opened and
/// then failed.
struct Trial {
  std::string answer;   ///< one line
  std::string problem;  ///< one line; empty if all went well
};

/// Opens `engine`, which answers with its version, loads `plugin` as any user of MuJoCo does, and
/// with it loads `model`, MJCF text that uses the plugin, and steps it. Any warning of MuJoCo is a
/// problem, and so is an empty `plugin`.
[[nodiscard]] Trial TryEngine(const std::filesystem::path& engine,
                              const std::filesystem::path& plugin, const std::string& model);

/// Opens a plugin of Girdle, without any MuJoCo; it answers with its version.
[[nodiscard]] Trial OpenPlugin(const std::filesystem::path& plugin);

/// Opens a library that is linked with MuJoCo. The answer is the whole path of the library
/// of MuJoCo that came with it.
[[nodiscard]] Trial OpenModule(const std::filesystem::path& module);

}  // namespace girdle
