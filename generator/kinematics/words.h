// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Words for the values of enumerations, in both directions.
///
/// An enumeration has words if a function WordsOf is declared beside it. WordsOf returns an array
/// of words in the order of the enumerators. Its argument only selects the overload:
///
///     enum class Side { kRight, kLeft };
///     inline constexpr std::array<std::string_view, 2> kSideNames = {"right", "left"};
///     constexpr const auto& WordsOf(Side /*which*/) noexcept { return kSideNames; }
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>

namespace girdle {

/// An enumeration that has words.
template <typename Enumeration>
concept HasWords = requires(Enumeration value) {
  WordsOf(value).size();
};

/// Returns the word of a value. Precondition: the value is one of the enumerators.
template <HasWords Enumeration>
[[nodiscard]] constexpr std::string_view Name(Enumeration value) noexcept {
  return WordsOf(value)[static_cast<std::size_t>(value)];
}

/// Returns the value of a word, or nothing if the enumeration does not have that word. Upper and
/// lower case differ.
template <HasWords Enumeration>
[[nodiscard]] constexpr std::optional<Enumeration> FromName(std::string_view word) noexcept {
  const auto& words = WordsOf(Enumeration{});
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end()) {
    return std::nullopt;
  }
  return static_cast<Enumeration>(found - words.begin());
}

}  // namespace girdle
