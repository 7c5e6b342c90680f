// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/words.h"

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace girdle::words_test {

enum class Fruit { kApple, kPear, kPlum };
inline constexpr std::array<std::string_view, 3> kFruitNames = {"apple", "pear", "plum"};
constexpr const auto& WordsOf(Fruit /*which*/) noexcept { return kFruitNames; }

enum class Wordless { kNothing };

namespace {

TEST(Words, ReadBackAsTheValueThatTheyAreFor) {
  for (const auto& [fruit, word] :
       {std::pair(Fruit::kApple, "apple"), std::pair(Fruit::kPear, "pear"),
        std::pair(Fruit::kPlum, "plum")}) {
    EXPECT_EQ(Name(fruit), word);
    EXPECT_EQ(FromName<Fruit>(word), fruit);
  }
}

TEST(Words, AreTheWholeWordInItsOwnLetters) {
  for (const char* const word : {"", "Apple", "apple ", " apple", "appl", "apples", "fig"}) {
    EXPECT_EQ(FromName<Fruit>(word), std::nullopt) << "'" << word << "'";
  }
}

TEST(Words, AreKnownWhileCompiling) {
  static_assert(Name(Fruit::kPlum) == "plum");
  static_assert(FromName<Fruit>("pear") == Fruit::kPear);
  static_assert(HasWords<Fruit>);
  static_assert(!HasWords<Wordless>);
  static_assert(!HasWords<int>);
}

}  // namespace
}  // namespace girdle::words_test
