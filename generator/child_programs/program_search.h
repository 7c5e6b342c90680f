// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Search for programs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace girdle {

/// Returns the folders in an environment variable that holds a list, such as PATH. Folders that are
/// relative to the current folder are left out.
[[nodiscard]] std::vector<std::filesystem::path> FoldersOf(const char* variable);

/// Returns whether `file` exists and this process may run it.
[[nodiscard]] bool IsProgram(const std::filesystem::path& file);

/// Returns the path of a program of this name in the folders of PATH; empty if there is none.
[[nodiscard]] std::filesystem::path FindProgram(const std::string& name);

}  // namespace girdle
