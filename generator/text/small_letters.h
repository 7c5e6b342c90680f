// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Text in small letters, to compare names whose capitals do not matter.
#pragma once

#include <string>
#include <string_view>

namespace girdle {

/// Returns `text` with A to Z replaced by a to z, whatever the locale. All other bytes stay.
[[nodiscard]] std::string InSmallLetters(std::string_view text);

}  // namespace girdle
