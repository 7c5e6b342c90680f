// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "text/text_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "text/input_error.h"

namespace girdle {

std::ifstream OpenTextFile(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw InputError(path + ": is a folder. Name a file in it");
  }
  std::ifstream in(path, std::ios::binary);
  if (!in) {
    throw InputError(path + ": cannot be opened: " + std::strerror(errno) +
                     ". Check the name and its permissions");
  }
  return in;
}

}  // namespace girdle
