// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Functions that receive text and progress while they are made.
#pragma once

#include <functional>
#include <string_view>

namespace girdle {

/// Receives text as it is made.
using TextSink = std::function<void(std::string_view)>;
/// Receives the share of the work that is done, 0 to 1.
using ProgressSink = std::function<void(double)>;

}  // namespace girdle
