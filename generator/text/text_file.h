// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Opening text files.
#pragma once

#include <fstream>
#include <string>

namespace girdle {

/// Returns an open file. Throws InputError if there is none, it is a folder or must not be read.
[[nodiscard]] std::ifstream OpenTextFile(const std::string& path);

}  // namespace girdle
