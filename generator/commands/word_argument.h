// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Options of the command line whose value is one of a few words.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "kinematics/words.h"
#include "text/input_error.h"
#include "text/near_names.h"

namespace girdle {

/// Returns the enumerator that `word` names; nothing if the option is not given (an empty word).
/// Throws InputError with the known words.
template <HasWords Enumeration>
[[nodiscard]] std::optional<Enumeration> ChosenWord(const std::string& option,
                                                    const std::string& word) {
  const std::optional<Enumeration> chosen = FromName<Enumeration>(word);
  if (!chosen && !word.empty()) {
    std::string choices;
    for (const std::string_view name : WordsOf(Enumeration{})) {
      choices += (choices.empty() ? "" : ", ") + std::string(name);
    }
    throw InputError(option + " " + word + ": not known. " +
                     DidYouMean(word, WordsOf(Enumeration{})) + "Choose one of: " + choices);
  }
  return chosen;
}

/// Sets `chosen` to the enumerator that `word` names. If the option is not given, `chosen` stays as
/// it is. Throws as ChosenWord.
template <HasWords Enumeration>
void ChooseWord(const std::string& option, const std::string& word, Enumeration& chosen) {
  chosen = ChosenWord<Enumeration>(option, word).value_or(chosen);
}

}  // namespace girdle
