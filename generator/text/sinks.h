// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Where text and progress go as they are made.
#pragma once

#include <functional>
#include <string_view>

namespace girdle {

/// Receives text as it is made.
using TextSink = std::function<void(std::string_view)>;
/// Told how much is done, 0 to 1.
using ProgressSink = std::function<void(double)>;

}  // namespace girdle
