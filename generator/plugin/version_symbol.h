// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The one function that the plugin's library offers to others than MuJoCo.
#pragma once

namespace girdle {

/// Name of a C function without arguments that returns, as an int in the form of mj_version, the
/// version of MuJoCo that the plugin is built for. It answers in a process without MuJoCo too.
inline constexpr const char* kEngineVersionSymbol = "girdle_rhythm_engine_version";

}  // namespace girdle
