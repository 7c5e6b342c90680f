// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// How the plugin's warnings of a compiled model are told from all others.
#pragma once

namespace girdle {

/// Stands before what differs in a compiled model from what the servos need. Such a model steps,
/// and a report can say how it moves.
inline constexpr const char* kModelFaultMark = "the compiled model does not suit the servos: ";

}  // namespace girdle
