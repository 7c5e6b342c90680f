// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "child_programs/program_search.h"

#include <unistd.h>

#include <cstdlib>
#include <sstream>
#include <system_error>

namespace girdle {

std::vector<std::filesystem::path> FoldersOf(const char* variable) {
  const char* const value = std::getenv(variable);
  std::vector<std::filesystem::path> folders;
  std::istringstream in(value == nullptr ? "" : value);
  for (std::string folder; std::getline(in, folder, ':');) {
    if (std::filesystem::path(folder).is_absolute()) {
      folders.emplace_back(folder);
    }
  }
  return folders;
}

bool IsProgram(const std::filesystem::path& file) {
  std::error_code error;
  return std::filesystem::is_regular_file(file, error) && access(file.c_str(), X_OK) == 0;
}

std::filesystem::path FindProgram(const std::string& name) {
  for (const std::filesystem::path& folder : FoldersOf("PATH")) {
    if (std::filesystem::path file = folder / name; IsProgram(file)) {
      return file;
    }
  }
  return {};
}

}  // namespace girdle
