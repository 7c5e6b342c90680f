// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Comparing files.
#pragma once

#include <filesystem>

namespace girdle {

/// Returns whether both are regular files that can be read and hold the same bytes.
[[nodiscard]] bool HaveTheSameBytes(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace girdle
