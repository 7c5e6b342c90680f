// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Texts that are lists of texts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace girdle {

/// Returns the parts of `text` between the separators, without them. There is one part more than
/// there are separators; parts may be empty. Precondition: `separator` is not empty.
[[nodiscard]] std::vector<std::string> Split(std::string_view text, std::string_view separator);

/// Returns the texts of a container with ", " between them.
template <typename Texts>
[[nodiscard]] std::string Joined(const Texts& texts) {
  std::string joined;
  for (const std::string_view text : texts) {
    joined += joined.empty() ? "" : ", ";
    joined += text;
  }
  return joined;
}

}  // namespace girdle
