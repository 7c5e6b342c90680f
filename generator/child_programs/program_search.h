// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Where programs are.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace girdle {

/// Returns the folders of a list such as PATH in the environment, without those that depend on the
/// current folder.
[[nodiscard]] std::vector<std::filesystem::path> FoldersOf(const char* variable);

/// Returns whether a file is there that this process may run.
[[nodiscard]] bool IsProgram(const std::filesystem::path& file);

/// Returns where PATH has a program of this name, or an empty path.
[[nodiscard]] std::filesystem::path FindProgram(const std::string& name);

}  // namespace girdle
