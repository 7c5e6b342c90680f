// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// A check of a model in MuJoCo's binary format, MJB, before MuJoCo loads it.
#pragma once

#include <string>

namespace girdle {

/// Throws InputError if the MJB file at `path` cannot be loaded and stepped in this process. MuJoCo
/// itself crashes if a plugin of the file is not registered here with the same slot number, or if
/// certain numbers of the file are damaged. Precondition: this process has one thread.
void ExpectLoadable(const std::string& path);

}  // namespace girdle
