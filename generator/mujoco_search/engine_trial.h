// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Real trials of libraries of MuJoCo and of the plugin, each in a process of its own: a broken
/// file harms no other trial, and no process opens two engines. This code is not linked with
/// MuJoCo.
#pragma once

#include <filesystem>
#include <string>

namespace girdle {

/// Result of opening a file: an answer, a problem, or both if the file could be opened and then
/// failed.
struct Trial {
  std::string answer;   ///< one line
  std::string problem;  ///< one line; empty if there was none
};

/// Opens `engine` and asks for its version, which is the answer. Then loads `plugin` as any user of
/// MuJoCo does, loads `model`, MJCF text that uses the plugin, and steps it. Any warning of MuJoCo
/// is a problem, and so is an empty `plugin`.
[[nodiscard]] Trial TryEngine(const std::filesystem::path& engine,
                              const std::filesystem::path& plugin, const std::string& model);

/// Opens a plugin of Girdle without any MuJoCo. The answer is its version.
[[nodiscard]] Trial OpenPlugin(const std::filesystem::path& plugin);

/// Opens a library that is linked with MuJoCo. The answer is the whole path of the library of
/// MuJoCo that was loaded with it.
[[nodiscard]] Trial OpenModule(const std::filesystem::path& module);

}  // namespace girdle
