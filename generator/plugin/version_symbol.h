// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The one function that the plugin's library offers to others than MuJoCo.
#pragma once

namespace girdle {

/// Name of a C function without arguments that returns, as a `const char*`, the version of Girdle
/// that the plugin belongs to: "0.1.0". It answers in a process without MuJoCo too.
inline constexpr const char* kPluginVersionSymbol = "girdle_rhythm_version";

}  // namespace girdle
