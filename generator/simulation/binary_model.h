// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Looking at a model in MuJoCo's binary format, MJB, before MuJoCo does.
#pragma once

#include <string>

namespace girdle {

/// Throws InputError if the MJB file at `path` cannot be loaded and stepped in this process. MuJoCo
/// itself crashes where a plugin of the file is not registered here under the same slot number, and
/// where some numbers of the file are damaged. To be called while this process has one thread.
void ExpectLoadable(const std::string& path);

}  // namespace girdle
