// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "text/small_letters.h"

#include <gtest/gtest.h>

namespace girdle::small_letters_test {
namespace {

TEST(SmallLetters, TakeThePlaceOfCapitalsAlone) {
  EXPECT_EQ(InSmallLetters(".GlTf"), ".gltf");
  EXPECT_EQ(InSmallLetters("AZaz@[`{09_-"), "azaz@[`{09_-");
  EXPECT_EQ(InSmallLetters("\xC3\x84"), "\xC3\x84") << "a letter of two bytes";
}

}  // namespace
}  // namespace girdle::small_letters_test
