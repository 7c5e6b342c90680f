// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Opening text files.
#pragma once

#include <fstream>
#include <string>

namespace girdle {

/// Returns an open file. Throws InputError if the file does not exist, is a folder or is not
/// readable.
[[nodiscard]] std::ifstream OpenTextFile(const std::string& path);

}  // namespace girdle
