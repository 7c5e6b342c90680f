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

/// Returns a loaded plugin for a message: its file, and its Girdle's version where it says one.
[[nodiscard]] std::string DescribedPlugin(const std::string& file);

}  // namespace girdle
