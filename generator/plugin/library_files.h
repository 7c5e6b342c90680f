// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The files that the libraries of this process were loaded from.
#pragma once

#include <string>

namespace girdle {

/// Returns the file of the library that contains `address`, or "another library" if it is unknown.
[[nodiscard]] std::string FileOf(const void* address);

/// Returns the file of this plugin.
[[nodiscard]] std::string OwnFile();

/// Returns the description of a loaded plugin for a message: its file, and the version of its
/// Girdle if it reports one.
[[nodiscard]] std::string DescribedPlugin(const std::string& file);

}  // namespace girdle
