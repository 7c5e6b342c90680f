// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "text/shown_text.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace girdle::shown_text_test {
namespace {

std::string Printed(std::string_view message) {
  std::ostringstream out;
  WritePrintable(out, message);
  return out.str();
}

TEST(ShortText, LeavesATextThatIsShort) {
  EXPECT_EQ(ShortText("axial_deg"), "axial_deg");
  EXPECT_EQ(ShortText("12345", 5), "12345");
}

TEST(ShortText, CutsALongTextAndGivesItsSize) {
  EXPECT_EQ(ShortText("123456", 5), "12345... (6 bytes)");
}

TEST(ShortText, DoesNotCutACharacterInTwo) {
  EXPECT_EQ(ShortText("a\xC3\xA4\xE4\xB8\xAD", 2), "a... (6 bytes)");
  EXPECT_EQ(ShortText("a\xC3\xA4\xE4\xB8\xAD", 5), "a\xC3\xA4... (6 bytes)");
}

TEST(WritePrintable, LeavesLettersOfAllLanguagesAndLineFeeds) {
  const std::string text = "a\n\xC3\xA4 \xE4\xB8\xAD \xED\x9F\xBF \xF0\x9F\x92\xAA~";
  EXPECT_EQ(Printed(text), text);
}

TEST(WritePrintable, ShowsControlCharactersByTheirNumbers) {
  EXPECT_EQ(Printed("\x1b]0;owned\x07\x1b[31mred\tx\x7f\r"),
            "\\x1b]0;owned\\x07\\x1b[31mred\\x09x\\x7f\\x0d");
  // C1, "control sequence introducer", in UTF-8 and by itself.
  EXPECT_EQ(Printed("\xC2\x9B"
                    "31m \x9B"),
            "\\xc2\\x9b31m \\x9b");
}

TEST(WritePrintable, ShowsBytesThatAreNotUtf8ByTheirNumbers) {
  EXPECT_EQ(Printed("caf\xE9"), "caf\\xe9");
  // Too long a form, a half of UTF-16, beyond U+10FFFF, and a character that is cut.
  EXPECT_EQ(Printed("\xC0\xAF"), "\\xc0\\xaf");
  EXPECT_EQ(Printed("\xE0\x80\xAF"), "\\xe0\\x80\\xaf");
  EXPECT_EQ(Printed("\xED\xA0\x80"), "\\xed\\xa0\\x80");
  EXPECT_EQ(Printed("\xF4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");
  EXPECT_EQ(Printed("\xE4\xB8"), "\\xe4\\xb8");
}

}  // namespace
}  // namespace girdle::shown_text_test
