// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "text/csv.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <istream>
#include <memory>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <streambuf>
#include <string>
#include <utility>
#include <vector>

#include "text/csv_text.h"
#include "text/input_error.h"
#include "text/shown_text.h"

namespace girdle::csv_test {
namespace {

using Rows = std::vector<std::vector<std::string>>;

Rows AllRows(CsvReader& csv) {
  Rows rows;
  while (csv.Next()) {
    rows.emplace_back();
    for (std::size_t column = 0; column < csv.columns().size(); ++column) {
      rows.back().emplace_back(csv.Field(column));
    }
  }
  return rows;
}

struct AcceptedText {
  const char* name;
  const char* text;
  Rows rows;
};

void PrintTo(const AcceptedText& accepted, std::ostream* out) { *out << accepted.name; }

class AcceptedCsv : public testing::TestWithParam<AcceptedText> {};

TEST_P(AcceptedCsv, HasItsColumns) {
  std::istringstream in(GetParam().text);
  EXPECT_EQ(CsvReader(in, "t.csv").columns(), (std::vector<std::string>{"a", "b"}));
}

TEST_P(AcceptedCsv, HasItsRows) {
  std::istringstream in(GetParam().text);
  CsvReader csv(in, "t.csv");
  EXPECT_EQ(AllRows(csv), GetParam().rows);
}

INSTANTIATE_TEST_SUITE_P(
    Texts, AcceptedCsv,
    testing::Values(
        AcceptedText{"plain", "a,b\n1,2\n3,4\n", {{"1", "2"}, {"3", "4"}}},
        AcceptedText{"header alone", "a,b\n", {}},
        AcceptedText{"comments before the header", "# one\n#two\na,b\n1,2\n", {{"1", "2"}}},
        AcceptedText{"empty lines before the header", "\n\na,b\n1,2\n", {{"1", "2"}}},
        AcceptedText{"byte-order mark",
                     "\xEF\xBB\xBF"
                     "a,b\n1,2\n",
                     {{"1", "2"}}},
        AcceptedText{
            "byte-order mark before a comment", "\xEF\xBB\xBF# one\na,b\n1,2\n", {{"1", "2"}}},
        AcceptedText{
            "Windows line ends", "# one\r\n\r\na,b\r\n1,2\r\n3,4\r\n", {{"1", "2"}, {"3", "4"}}},
        AcceptedText{"no line end at the end", "a,b\n1,2", {{"1", "2"}}},
        AcceptedText{"header without a line end", "a,b", {}},
        AcceptedText{"empty lines at the end", "a,b\n1,2\n\n\r\n\n", {{"1", "2"}}},
        AcceptedText{"empty fields", "a,b\n,\n1,\n,2\n", {{"", ""}, {"1", ""}, {"", "2"}}},
        AcceptedText{"blanks around fields", "a,b\n 1 ,\t2\n", {{"1", "2"}}},
        AcceptedText{"blanks around names", " a, b\t\n1,2\n", {{"1", "2"}}},
        AcceptedText{"blanks around quotes", "a,b\n \"1,5\" , \"2\"\n", {{"1,5", "2"}}},
        AcceptedText{"line ends of old Macs", "# one\ra,b\r1,2\r3,4\r", {{"1", "2"}, {"3", "4"}}},
        AcceptedText{
            "mixed line ends", "a,b\r1,2\n3,4\r\n5,6", {{"1", "2"}, {"3", "4"}, {"5", "6"}}},
        AcceptedText{"semicolons", "a;b\n1,5;2\n", {{"1,5", "2"}}},
        AcceptedText{"tabs", "a\tb\n1,5\t2\n", {{"1,5", "2"}}},
        AcceptedText{"tabs and empty fields", "a\tb\n\t2\n1\t\n", {{"", "2"}, {"1", ""}}},
        AcceptedText{"semicolons and quotes", "\"a\";b\n\"1;5\";2\n", {{"1;5", "2"}}},
        AcceptedText{"separator line", "sep=;\na;b\n1,5;2\n", {{"1,5", "2"}}},
        AcceptedText{"separator line in quotes and capitals",
                     "\"SEP=\t\"\r\na\tb\r\n1\t2\r\n",
                     {{"1", "2"}}},
        AcceptedText{"separator line that names the comma", "sep=,\na,b\n1,2;3\n", {{"1", "2;3"}}},
        AcceptedText{"quoted field", "a,b\n\"1\",2\n", {{"1", "2"}}},
        AcceptedText{"quoted last field", "a,b\n1,\"2\"\n", {{"1", "2"}}},
        AcceptedText{"comma in quotes", "a,b\n\"1,5\",\"2,5\"\n", {{"1,5", "2,5"}}},
        AcceptedText{
            "quote in quotes", "a,b\n\"say \"\"no\"\"\",\"\"\"\"\n", {{"say \"no\"", "\""}}},
        // Longer than a string keeps within itself.
        AcceptedText{"long quoted fields",
                     "a,b\n\"a field of some forty letters, with a comma\",\"and one more, as long "
                     "as the first of both\"\n",
                     {{"a field of some forty letters, with a comma",
                       "and one more, as long as the first of both"}}},
        AcceptedText{"empty quotes", "a,b\n\"\",\"\"\n", {{"", ""}}},
        AcceptedText{"plain field after a quoted one", "a,b\n\"1\",\n", {{"1", ""}}},
        AcceptedText{"quotes under Windows", "a,b\r\n\"1\",\"2\"\r\n", {{"1", "2"}}},
        AcceptedText{"quoted header", "\"a\",\"b\"\n1,2\n", {{"1", "2"}}}));

TEST(CsvReader, ShowsAHeaderWhereThereIsNone) {
  EXPECT_EQ(MessageOf<InputError>([] {
              std::istringstream in("30,5;40,0\n");
              constexpr std::array<std::string_view, 3> kExample = {"elevation_deg", "plane_deg",
                                                                    "axial_deg"};
              const CsvReader csv(in, "t.csv", kExample);
            }),
            "t.csv:1: the first line has numbers, not names. Put a line before it that names its 2 "
            "columns, in their order, such as elevation_deg;plane_deg");
}

// A text as UTF-16; ASCII and a few letters beyond it suffice.
std::string AsUtf16(const std::u16string& text, bool is_big) {
  std::string bytes;
  for (const char16_t unit : u"\uFEFF" + text) {
    const auto high = static_cast<char>(unit >> 8U);
    const auto low = static_cast<char>(unit & 0xFFU);
    bytes += is_big ? high : low;
    bytes += is_big ? low : high;
  }
  return bytes;
}

class CsvInUtf16 : public testing::TestWithParam<bool> {};

TEST_P(CsvInUtf16, IsReadAsUtf8) {
  std::istringstream in(AsUtf16(u"a\t\u00E4\r\n\u4E2D\t\U0001F4AA\r\n", GetParam()));
  CsvReader csv(in, "t.csv");
  EXPECT_EQ(csv.header_line(), "a\t\xC3\xA4");
  EXPECT_EQ(AllRows(csv), (Rows{{"\xE4\xB8\xAD", "\xF0\x9F\x92\xAA"}}));
}

TEST_P(CsvInUtf16, IsRefusedWithHalfOfACharacter) {
  std::u16string text = u"a,b\n1,?\n";
  text[6] = 0xDC00;
  EXPECT_EQ(MessageOf<InputError>([&] {
              std::istringstream in(AsUtf16(text, GetParam()));
              CsvReader csv(in, "t.csv");
              AllRows(csv);
            }),
            "t.csv:2: half of a character of UTF-16. Save the file again, as CSV in UTF-8");
}

INSTANTIATE_TEST_SUITE_P(ByteOrders, CsvInUtf16, testing::Bool());

TEST(CsvReader, RefusesAByteZeroAtItsLine) {
  using namespace std::string_literals;
  const std::string no_text =
      "a byte 0, which no text has. If this is a workbook (.xlsx) or UTF-16 without a byte-order "
      "mark, save it as CSV in UTF-8";
  for (const auto& [text, place] :
       {std::pair{"a\0,\0b\0\n\0"s, "t.csv:1: "s}, std::pair{"a,b\n1,2\n3,\0\n"s, "t.csv:3: "s}}) {
    EXPECT_EQ(MessageOf<InputError>([&text = text] {
                std::istringstream in(text);
                CsvReader csv(in, "t.csv");
                AllRows(csv);
              }),
              place + no_text);
  }
}

TEST(CsvReader, RefusesALineOfMoreThanAMebibyte) {
  const std::string longest(kLongestCsvLine, '7');
  for (const auto& [text, place] :
       {std::pair{longest + "7\n", "t.csv:1: "}, std::pair{"a\n" + longest + "7", "t.csv:2: "},
        std::pair{"a\n1\n" + longest + "7\n", "t.csv:3: "}}) {
    EXPECT_EQ(MessageOf<InputError>([&text = text] {
                std::istringstream in(text);
                CsvReader csv(in, "t.csv");
                AllRows(csv);
              }),
              place + std::string("the line has more than 1 MiB. Check that the file is a table "
                                  "with line ends"));
  }
  std::istringstream in("a\n" + longest + "\n");
  CsvReader csv(in, "t.csv");
  EXPECT_EQ(AllRows(csv), (Rows{{longest}}));
}

// A header of so many columns.
std::string ManyColumns(std::size_t count) {
  std::string header;
  for (std::size_t i = 0; i < count; ++i) header += (i > 0 ? ",c" : "c") + std::to_string(i);
  return header + "\n";
}

TEST(CsvReader, RefusesMoreColumnsThanItCountsTo) {
  std::istringstream most(ManyColumns(kMostCsvColumns));
  EXPECT_EQ(CsvReader(most, "t.csv").columns().size(), kMostCsvColumns);
  std::istringstream in(ManyColumns(kMostCsvColumns + 1));
  EXPECT_EQ(MessageOf<InputError>([&] { const CsvReader csv(in, "t.csv"); }),
            "t.csv:1: 4097 columns, at most 4096 are read. Remove those that are not needed");
}

TEST(CsvReader, RefusesCommentsWithoutEnd) {
  const std::string line = "#" + std::string(kLongestCsvLine - 2, '-') + "\n";
  std::string text;
  for (std::size_t size = 0; size <= kMostBeforeCsvHeader; size += line.size()) text += line;
  std::istringstream in(text);
  EXPECT_EQ(MessageOf<InputError>([&] { const CsvReader csv(in, "t.csv"); }),
            "t.csv:17: no header in the first 16777216 bytes. The first line that is no comment "
            "must name the columns");
}

TEST(CsvReader, ShowsTheBeginningOfALongField) {
  std::istringstream in("a,b\n1," + std::string(1000, 'x') + "\n");
  CsvReader csv(in, "t.csv");
  ASSERT_TRUE(csv.Next());
  EXPECT_EQ(MessageOf<InputError>([&] { static_cast<void>(csv.Number(1)); }),
            "t.csv:2: b is '" + std::string(kMostShownOfValue, 'x') +
                "... (1000 bytes)', expected a finite number such as 22.5");
}

// A table, the numbers of its first column, and the decimal mark that is found.
struct MarkedText {
  const char* name;
  const char* text;
  std::vector<double> numbers;
  char decimal_mark;
};

void PrintTo(const MarkedText& marked, std::ostream* out) { *out << marked.name; }

class DecimalMark : public testing::TestWithParam<MarkedText> {};

TEST_P(DecimalMark, IsThatOfTheFirstRowWithOne) {
  std::istringstream in(GetParam().text);
  CsvReader csv(in, "t.csv");
  std::vector<double> numbers;
  while (csv.Next()) numbers.push_back(csv.Number(0));
  EXPECT_EQ(numbers, GetParam().numbers);
  EXPECT_EQ(csv.header().dialect.decimal_mark, GetParam().decimal_mark);
}

INSTANTIATE_TEST_SUITE_P(
    Texts, DecimalMark,
    testing::Values(MarkedText{"comma", "a;b\n-30,5;1\n+1,5e1;2\n", {-30.5, 15}, ','},
                    MarkedText{"point", "a;b\n30.5;1\n", {30.5}, '.'},
                    MarkedText{"comma in another column", "a;b\n30;1,5\n", {30}, ','},
                    MarkedText{"comma in a later row", "a\tb\n30\t1\n31\t1,5\n", {30, 31}, ','},
                    MarkedText{"none with semicolons", "a;b\n30;1\n", {30}, ','},
                    MarkedText{"none with tabs", "a\tb\n30\t1\n", {30}, '.'},
                    MarkedText{"blanks around it", "a;b\n 30,5 ;1\n", {30.5}, ','}));

TEST(CsvReader, KeepsTheHeaderAndTheRowAsTheyStand) {
  std::istringstream in("\xEF\xBB\xBF# one\r\na,\"b\"\r\n\"1,5\", 2\r\n");
  CsvReader csv(in, "t.csv");
  EXPECT_EQ(csv.header_line(), "a,\"b\"");
  ASSERT_TRUE(csv.Next());
  EXPECT_EQ(csv.line(), "\"1,5\", 2");
  EXPECT_EQ(csv.header_line(), "a,\"b\"");
}

TEST(CsvReader, CountsAllLinesFromOne) {
  std::istringstream in("# one\n\na,b\n1,2\n3,4\n");
  CsvReader csv(in, "t.csv");
  EXPECT_EQ(csv.line_number(), 3U);
  ASSERT_TRUE(csv.Next());
  EXPECT_EQ(csv.line_number(), 4U);
  ASSERT_TRUE(csv.Next());
  EXPECT_EQ(csv.line_number(), 5U);
}

TEST(CsvReader, KnowsItsFile) {
  std::istringstream in("a,b\n");
  EXPECT_EQ(CsvReader(in, "folder/t.csv").name(), "folder/t.csv");
}

TEST(CsvReader, FindsColumnsByName) {
  std::istringstream in("a,b\n");
  const CsvReader csv(in, "t.csv");
  EXPECT_EQ(csv.Column("b"), 1U);
  EXPECT_TRUE(csv.HasColumn("a"));
  EXPECT_FALSE(csv.HasColumn("A"));
}

struct RefusedText {
  const char* name;
  const char* text;
  const char* message;
};

void PrintTo(const RefusedText& refused, std::ostream* out) { *out << refused.name; }

class RefusedCsv : public testing::TestWithParam<RefusedText> {};

TEST_P(RefusedCsv, SaysWhereAndWhy) {
  EXPECT_EQ(MessageOf<InputError>([] {
              std::istringstream in(GetParam().text);
              CsvReader csv(in, "t.csv");
              AllRows(csv);
            }),
            GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Texts, RefusedCsv,
    testing::Values(
        RefusedText{"nothing", "", "t.csv:1: no header line. The first line must name the columns"},
        RefusedText{"numbers in place of a header", "1,2\n",
                    "t.csv:1: the first line has numbers, not names. Put a line before it that "
                    "names its 2 columns"},
        RefusedText{"decimal commas in place of a header", "# one\n1,5;2,5;3\n",
                    "t.csv:2: the first line has numbers, not names. Put a line before it that "
                    "names its 3 columns"},
        RefusedText{"unknown separator", "sep=|\na|b\n",
                    "t.csv:1: 'sep=|' names an unknown separator. Separate the columns by commas, "
                    "semicolons or tabs"},
        RefusedText{"two possible separators", "a,b;c\n1,2\n",
                    "t.csv:1: two separators make equally many columns of the header (a,b;c). Put "
                    "the line sep=, or sep=; before it to choose one"},
        RefusedText{"two decimal marks in a row", "a;b;c\n1;2;3\n1;2,5;3.5\n",
                    "t.csv:3: '2,5' has a decimal comma and '3.5' a decimal point. Write all "
                    "numbers of the file with one mark"},
        RefusedText{"UTF-16 that breaks off",
                    "\xFF\xFE"
                    "a",
                    "t.csv:1: half of a character of UTF-16. Save the file again, as CSV in UTF-8"},
        RefusedText{"comments alone", "# one\n# two\n",
                    "t.csv:3: no header line. The first line must name the columns"},
        RefusedText{"column without a name", "# one\na,,b\n1,2,3\n",
                    "t.csv:2: column 2 has no name. Give it one, or remove the column"},
        RefusedText{"two columns of one name", "a,b,a\n1,2,3\n",
                    "t.csv:1: column 'a' is given twice. Rename or remove one"},
        RefusedText{"field too few", "a,b\n1,2\n3\n",
                    "t.csv:3: 1 field, expected 2 as in the header (a,b)"},
        RefusedText{"field too many", "a,b\n1,2,3\n",
                    "t.csv:2: 3 fields, expected 2 as in the header (a,b)"},
        RefusedText{"comma at the end of a row", "a,b\n1,2,\n",
                    "t.csv:2: 3 fields, expected 2 as in the header (a,b)"},
        RefusedText{"comment among the rows", "a,b\n1,2\n# here\n3,4\n",
                    "t.csv:3: 1 field, expected 2 as in the header (a,b)"},
        RefusedText{"quote not closed", "a,b\n1,\"2\n",
                    "t.csv:2: a quote is not closed on its line"},
        RefusedText{"line break in quotes", "a,b\n\"1\n5\",2\n",
                    "t.csv:2: a quote is not closed on its line"},
        RefusedText{"quote not closed in the header", "a,\"b\n",
                    "t.csv:1: a quote is not closed on its line"},
        RefusedText{"text behind a quote", "a,b\n\"1\"5,2\n",
                    "t.csv:2: text behind a closing quote. Put the whole field in quotes"},
        RefusedText{"empty line among the rows", "a,b\n1,2\n\n\n3,4\n",
                    "t.csv:3: empty line between rows. Remove it"}));

TEST(CsvReader, NamesTheColumnsThatAreThereWhenOneIsMissing) {
  std::istringstream in("# one\na,b\n");
  const CsvReader csv(in, "t.csv");
  EXPECT_EQ(MessageOf<InputError>([&] { static_cast<void>(csv.Column("c")); }),
            "t.csv:2: column 'c' is missing. The header has: a, b");
}

TEST(CsvReader, RefusesAColumnThatIsNotKnown) {
  std::istringstream in("a,b\n");
  const CsvReader csv(in, "t.csv");
  EXPECT_EQ(MessageOf<InputError>([&] {
              csv.ExpectOnlyColumns({"a", "c"});
            }),
            "t.csv:1: column 'b' is not known. Remove it or correct its name");
}

TEST(CsvReader, AcceptsThatKnownColumnsAreMissing) {
  std::istringstream in("a,b\n");
  const CsvReader csv(in, "t.csv");
  EXPECT_NO_THROW(csv.ExpectOnlyColumns({"c", "b", "a"}));
}

// A reader that stands at a row of one number.
class NumberField : public testing::Test {
 protected:
  CsvReader& AtRow(const std::string& number) {
    in_.str("angle_deg\n" + number + "\n");
    csv_ = std::make_unique<CsvReader>(in_, "t.csv");
    EXPECT_TRUE(csv_->Next());
    return *csv_;
  }

 private:
  std::istringstream in_;
  std::unique_ptr<CsvReader> csv_;
};

TEST_F(NumberField, IsReadAsItsNumber) { EXPECT_EQ(AtRow("-22.5").Number(0), -22.5); }

TEST_F(NumberField, InQuotesIsReadToo) { EXPECT_EQ(AtRow("\"22.5\"").Number(0), 22.5); }

TEST_F(NumberField, ThatIsNoneIsRefusedWithItsText) {
  CsvReader& csv = AtRow("4O");
  EXPECT_EQ(MessageOf<InputError>([&] { static_cast<void>(csv.Number(0)); }),
            "t.csv:2: angle_deg is '4O', expected a finite number such as 22.5");
}

TEST_F(NumberField, WithBlanksAroundItIsRead) { EXPECT_EQ(AtRow(" 22.5\t").Number(0), 22.5); }

struct OtherMark {
  const char* text;
  const char* message;
};

TEST(CsvReader, RefusesNumbersWithAnotherDecimalMark) {
  for (const auto& [text, message] :
       {OtherMark{"a;b\n1,5;2\n2.5;3\n",
                  "t.csv:3: a is '2.5', expected a finite number such as 22,5: the decimal mark of "
                  "this file is a comma. Write all its numbers with one mark, from the first row "
                  "on"},
        OtherMark{"a\tb\n1\t2.5\n2,5\t3\n",
                  "t.csv:3: a is '2,5', expected a finite number such as 22.5: the decimal mark of "
                  "this file is a point. Write all its numbers with one mark, from the first row "
                  "on"},
        OtherMark{
            "a;b\n1.234,5;2,5\n",
            "t.csv:2: a is '1.234,5', expected a finite number such as 22,5, with one decimal "
            "mark and none between thousands"},
        OtherMark{"a,b\n\"1,5\",2\n",
                  "t.csv:2: a is '1,5', expected a finite number such as 22.5. Write a decimal "
                  "point, or separate the columns by semicolons"},
        OtherMark{"a;b\n1,234,567;2\n",
                  "t.csv:2: a is '1,234,567', expected a finite number such as 22,5"}}) {
    std::istringstream in(text);
    CsvReader csv(in, "t.csv");
    EXPECT_EQ(MessageOf<InputError>([&] {
                while (csv.Next()) static_cast<void>(csv.Number(0));
              }),
              message);
  }
}

TEST_F(NumberField, MayLieOnItsLimits) {
  EXPECT_EQ(AtRow("-180").NumberWithin(0, -180, 180), -180);
  EXPECT_EQ(AtRow("180").NumberWithin(0, -180, 180), 180);
}

TEST_F(NumberField, BelowItsLimitsIsRefusedWithValueAndLimits) {
  CsvReader& csv = AtRow("-180.5");
  EXPECT_EQ(MessageOf<InputError>([&] { static_cast<void>(csv.NumberWithin(0, -180, 180)); }),
            "t.csv:2: angle_deg is -180.5, expected -180 to 180");
}

TEST_F(NumberField, AboveItsLimitsIsRefusedWithValueAndLimits) {
  CsvReader& csv = AtRow("181");
  EXPECT_EQ(MessageOf<InputError>([&] { static_cast<void>(csv.NumberWithin(0, -180, 180)); }),
            "t.csv:2: angle_deg is 181, expected -180 to 180");
}

TEST_F(NumberField, IsPointedAtByFail) {
  CsvReader& csv = AtRow("1");
  EXPECT_EQ(MessageOf<InputError>([&] { csv.Fail("does not suit"); }), "t.csv:2: does not suit");
}

// A file that breaks off with an error of the disk.
class BrokenBuffer : public std::streambuf {
 public:
  explicit BrokenBuffer(std::string text) : text_(std::move(text)) {
    setg(text_.data(), text_.data(), text_.data() + text_.size());
  }

 protected:
  int_type underflow() override { throw std::runtime_error("disk"); }

 private:
  std::string text_;
};

TEST(CsvReader, SaysThatAStreamFailedWithinTheRows) {
  BrokenBuffer buffer("a,b\n1,2\n");
  std::istream in(&buffer);
  CsvReader csv(in, "t.csv");
  ASSERT_TRUE(csv.Next());
  EXPECT_EQ(MessageOf<InputError>([&] { static_cast<void>(csv.Next()); }),
            "t.csv:3: cannot be read");
}

TEST(CsvReader, SaysThatAStreamFailedBeforeTheHeader) {
  BrokenBuffer buffer("# one\n");
  std::istream in(&buffer);
  EXPECT_EQ(MessageOf<InputError>([&] { const CsvReader csv(in, "t.csv"); }),
            "t.csv:2: cannot be read");
}

TEST(CsvReader, KeepsTheCommentsBeforeTheHeader) {
  std::istringstream in("\xEF\xBB\xBF# one\r\n\n#two\r\na,b\r\n1,2\r\n");
  CsvReader csv(in, "t.csv");
  EXPECT_EQ(csv.comments(), (std::vector<std::string>{"# one", "#two"}));
  EXPECT_EQ(csv.header_line(), "a,b");
}

// A stream that gives so many characters at a time, as a slow pipe does.
class SlowBuffer : public std::streambuf {
 public:
  SlowBuffer(std::string text, std::size_t at_a_time)
      : text_(std::move(text)), at_a_time_(at_a_time) {}

  [[nodiscard]] std::size_t given() const { return given_; }

 protected:
  int_type underflow() override {
    const std::size_t size = std::min(at_a_time_, text_.size() - given_);
    if (size == 0) return traits_type::eof();
    setg(text_.data() + given_, text_.data() + given_, text_.data() + given_ + size);
    given_ += size;
    return traits_type::to_int_type(*gptr());
  }

 private:
  std::string text_;
  std::size_t at_a_time_;
  std::size_t given_ = 0;
};

// More than a few blocks.
constexpr int kManyRows = 5000;

// A text of many rows, with all that may stand in them, and its rows.
struct LongText {
  std::string text;
  Rows rows;
};

LongText ManyRows(const std::string& line_end) {
  LongText made;
  made.text = "# long" + line_end + "a,b" + line_end;
  for (int i = 0; i < kManyRows; ++i) {
    const std::string number = std::to_string(i * i);
    const bool is_quoted = i % 7 == 0;
    made.text += (is_quoted ? "\"" + number + ",\"\"\"," : number + ",") + line_end;
    made.rows.push_back({is_quoted ? number + ",\"" : number, ""});
  }
  return made;
}

class ManyRowsOfAStream : public testing::TestWithParam<std::size_t> {};

TEST_P(ManyRowsOfAStream, AreTheSameHoweverManyCharactersComeAtATime) {
  for (const char* line_end : {"\n", "\r\n", "\r"}) {
    const LongText expected = ManyRows(line_end);
    SlowBuffer buffer(expected.text, GetParam());
    std::istream in(&buffer);
    CsvReader csv(in, "t.csv");
    EXPECT_EQ(AllRows(csv), expected.rows);
    EXPECT_EQ(csv.line_number(), kManyRows + 2U);
  }
}

TEST_P(ManyRowsOfAStream, AreTheSameInBlocks) {
  const LongText expected = ManyRows("\n");
  SlowBuffer buffer(expected.text, GetParam());
  std::istream in(&buffer);
  CsvReader csv(in, "t.csv");
  CsvRows rows(csv.header());
  Rows found;
  std::vector<CsvBlock> blocks(1);
  while (csv.TakeBlock(blocks.back())) blocks.emplace_back();
  EXPECT_GT(blocks.size(), 4U);
  for (const CsvBlock& block : blocks) {
    rows.Start(block);
    while (rows.Next()) {
      found.push_back({std::string(rows.Field(0)), std::string(rows.Field(1))});
      EXPECT_EQ(rows.line_number(), found.size() + 2);
    }
  }
  EXPECT_EQ(found, expected.rows);
}

TEST_P(ManyRowsOfAStream, AreReadUpToTheFirstFlaw) {
  LongText expected = ManyRows("\n");
  SlowBuffer buffer(expected.text + "1,2,3\n", GetParam());
  std::istream in(&buffer);
  EXPECT_EQ(
      MessageOf<InputError>([&in] {
        CsvReader csv(in, "t.csv");
        AllRows(csv);
      }),
      "t.csv:" + std::to_string(kManyRows + 3) + ": 3 fields, expected 2 as in the header (a,b)");
}

INSTANTIATE_TEST_SUITE_P(AtATime, ManyRowsOfAStream,
                         testing::Values(1, 2, 3, 100, 4096, 8191, 8192, 8193, 1 << 30));

TEST(CsvReader, ReadsAByteOrderMarkThatComesInParts) {
  SlowBuffer buffer(
      "\xEF\xBB\xBF"
      "a,b\n1,2\n",
      1);
  std::istream in(&buffer);
  CsvReader csv(in, "t.csv");
  EXPECT_EQ(csv.header_line(), "a,b");
  EXPECT_EQ(AllRows(csv), (Rows{{"1", "2"}}));
}

TEST(CsvReader, ReadsUtf16AndLineEndsThatComeInParts) {
  for (const std::size_t at_a_time : {1U, 2U, 3U, 5U}) {
    SlowBuffer buffer(AsUtf16(u"a,b\r\n1,\U0001F4AA\r3,4\r\n", false), at_a_time);
    std::istream in(&buffer);
    CsvReader csv(in, "t.csv");
    EXPECT_EQ(AllRows(csv), (Rows{{"1", "\xF0\x9F\x92\xAA"}, {"3", "4"}})) << at_a_time;
    EXPECT_EQ(csv.line_number(), 3U);
  }
}

TEST(CsvReader, TellsTheColumnsBeforeTheFirstRowComes) {
  SlowBuffer buffer("a;b\n1,5;2\n", 4);
  std::istream in(&buffer);
  CsvReader csv(in, "t.csv");
  EXPECT_EQ(buffer.given(), 4U);
  csv.FindDecimalMark();
  EXPECT_EQ(csv.header().dialect.decimal_mark, ',');
  EXPECT_EQ(AllRows(csv), (Rows{{"1,5", "2"}}));
}

TEST(CsvReader, ReadsALineThatIsLongerThanABlock) {
  const std::string longest(100'000, '7');
  std::istringstream in("a,b\n1,2\n" + longest + ",\"" + longest + "\"\n3,4\n");
  CsvReader csv(in, "t.csv");
  EXPECT_EQ(AllRows(csv), (Rows{{"1", "2"}, {longest, longest}, {"3", "4"}}));
}

TEST(CsvReader, ReadsCommentsThatAreLongerThanABlock) {
  std::string text;
  for (int i = 0; i < kManyRows; ++i) text += "# a comment\n\n";
  std::istringstream in(text + "a,b\n1,2\n");
  CsvReader csv(in, "t.csv");
  EXPECT_EQ(csv.line_number(), 2U * kManyRows + 1);
  EXPECT_EQ(AllRows(csv), (Rows{{"1", "2"}}));
  EXPECT_EQ(csv.line_number(), 2U * kManyRows + 2);
}

// Empty lines that fill blocks of their own.
const std::string kManyEmptyLines(50'000, '\n');

TEST(CsvReader, PassesOverManyEmptyLinesAtTheEnd) {
  std::istringstream in("a,b\n1,2\n\r\n" + kManyEmptyLines + "\r");
  CsvReader csv(in, "t.csv");
  EXPECT_EQ(AllRows(csv), (Rows{{"1", "2"}}));
}

TEST(CsvReader, PointsAtTheFirstOfManyEmptyLinesAmongTheRows) {
  std::istringstream in("a,b\n1,2\n" + kManyEmptyLines + "3,4\n");
  CsvReader csv(in, "t.csv");
  ASSERT_TRUE(csv.Next());
  EXPECT_EQ(MessageOf<InputError>([&] { static_cast<void>(csv.Next()); }),
            "t.csv:3: empty line between rows. Remove it");
}

TEST(CsvReader, PointsAtAnEmptyLineThatCameByItself) {
  SlowBuffer buffer("a,b\n1,2\n\n\n3,4\n", 1);
  std::istream in(&buffer);
  EXPECT_EQ(MessageOf<InputError>([&in] {
              CsvReader csv(in, "t.csv");
              AllRows(csv);
            }),
            "t.csv:3: empty line between rows. Remove it");
}

TEST(CsvReader, GivesTheRowsThatCameWithoutWaitingForMore) {
  SlowBuffer buffer("a,b\n1,2\n3,4\n", 4);
  std::istream in(&buffer);
  CsvReader csv(in, "t.csv");
  EXPECT_EQ(buffer.given(), 4U);
  EXPECT_FALSE(csv.HasLinesAtHand());
  ASSERT_TRUE(csv.Next());
  EXPECT_EQ(csv.line(), "1,2");
  EXPECT_EQ(buffer.given(), 8U);
}

TEST(CsvReader, SaysThatAStreamFailedAfterTheRowsBeforeIt) {
  BrokenBuffer buffer("a,b\n1,2\n3");
  std::istream in(&buffer);
  CsvReader csv(in, "t.csv");
  EXPECT_TRUE(csv.HasLinesAtHand());
  ASSERT_TRUE(csv.Next());
  for (int again = 0; again < 2; ++again) {
    EXPECT_EQ(MessageOf<InputError>([&] { static_cast<void>(csv.Next()); }),
              "t.csv:3: cannot be read");
  }
}

}  // namespace
}  // namespace girdle::csv_test
