// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The only function of the plugin's library that is not for MuJoCo.
#pragma once

namespace girdle {

/// Name of a C function without arguments. It returns the version of Girdle that the plugin belongs
/// to, for example "0.1.0". The text stays valid. The function also works in a process without
/// MuJoCo.
inline constexpr const char* kPluginVersionSymbol = "girdle_rhythm_version";

}  // namespace girdle
