// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Options of the command line that take one of some words.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "text/input_error.h"

namespace girdle {

/// Sets `chosen`, of an enumeration whose words are `names` in its order, to what `word` says; an
/// option that was not given (an empty word) leaves it. Throws InputError with the known words.
template <typename Enumeration, std::size_t N>
void ChooseWord(const std::string& option, const std::string& word,
                const std::array<std::string_view, N>& names, Enumeration& chosen) {
  if (word.empty()) {
    return;
  }
  const auto found = std::find(names.begin(), names.end(), word);
  if (found == names.end()) {
    std::string choices;
    for (const std::string_view name : names) {
      choices += (choices.empty() ? "" : ", ") + std::string(name);
    }
    throw InputError(option + " " + word + ": not known. Choose one of: " + choices);
  }
  chosen = static_cast<Enumeration>(found - names.begin());
}

}  // namespace girdle
