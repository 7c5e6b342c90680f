// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The files that the libraries of this process were loaded from.
#pragma once

#include <string>

namespace girdle {

/// Returns the file of the library that holds `address`, or "another library" if that is not known.
[[nodiscard]] std::string FileOf(const void* address);

/// Returns the file of this plugin.
[[nodiscard]] std::string OwnFile();

/// Returns whether both files can be read and hold the same bytes.
[[nodiscard]] bool HaveTheSameBytes(const std::string& first, const std::string& second);

/// Returns a loaded plugin for a message: its file, and its Girdle's version where it says one.
[[nodiscard]] std::string DescribedPlugin(const std::string& file);

}  // namespace girdle
