// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Checks the nodes of a glTF file before a reader follows them.
#pragma once

#include <optional>
#include <string>

namespace girdle {

/// The largest depth of nested nodes that is followed. A rig with fingers has a depth of about
/// twenty.
inline constexpr int kDeepestGltfNode = 256;

/// Returns the reason why the nodes of a `.glb` or `.gltf` file (version 2) cannot be followed, or
/// nothing if they can. Reasons are: it is not a glTF file; it is cut short; its nodes are not
/// trees, as the format requires; they are nested deeper than kDeepestGltfNode. Recursive readers
/// would run out of stack, or of memory if nodes are shared. Throws InputError if the file cannot
/// be opened.
[[nodiscard]] std::optional<std::string> FlawOfGltfNodes(const std::string& path);

}  // namespace girdle
