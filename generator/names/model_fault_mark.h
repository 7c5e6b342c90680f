// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The text that marks the plugin's warnings about a compiled model.
#pragma once

namespace girdle {

/// Beginning of a warning that a compiled model differs from what the servos need. Such a model
/// still steps, and a report can say how it moves.
inline constexpr const char* kModelFaultMark = "the compiled model does not suit the servos: ";

}  // namespace girdle
