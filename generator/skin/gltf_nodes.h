// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// What has to be known of a glTF file before a reader follows its nodes.
#pragma once

#include <optional>
#include <string>

namespace girdle {

/// Nodes one below the other that are followed. A rig with its fingers has about twenty.
inline constexpr int kDeepestGltfNode = 256;

/// Returns what keeps the nodes of a `.glb` or `.gltf` file (version 2) from being followed: a file
/// that is none or is cut short, one whose nodes are no trees, as the format demands, or are more
/// than kDeepestGltfNode deep. Readers that follow them by recursion would run out of stack or,
/// where nodes are shared, of memory. Nothing if they can be. Throws InputError for a file that
/// cannot be opened.
[[nodiscard]] std::optional<std::string> FlawOfGltfNodes(const std::string& path);

}  // namespace girdle
