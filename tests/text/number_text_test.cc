// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "text/number_text.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <locale>
#include <optional>
#include <ostream>
#include <random>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>

#include "kinematics/random_rotations.h"

namespace girdle::number_text_test {
namespace {

// Any finite double, all bit patterns alike.
rc::Gen<double> AnyFiniteNumber() {
  return rc::gen::suchThat(
      rc::gen::map(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()),
                   [](std::uint64_t bits) { return std::bit_cast<double>(bits); }),
      [](double number) { return std::isfinite(number); });
}

struct NumberCase {
  const char* text;
  double number;
};

void PrintTo(const NumberCase& number, std::ostream* out) { *out << number.text; }

class AcceptedNumber : public testing::TestWithParam<NumberCase> {};

TEST_P(AcceptedNumber, IsTheNumberWritten) {
  EXPECT_EQ(FiniteNumber(GetParam().text), GetParam().number);
}

INSTANTIATE_TEST_SUITE_P(
    Texts, AcceptedNumber,
    testing::Values(NumberCase{"0", 0}, NumberCase{"4", 4}, NumberCase{"-22.5", -22.5},
                    NumberCase{"+1", 1}, NumberCase{"+.5", 0.5}, NumberCase{"5.", 5},
                    NumberCase{"1e5", 1e5}, NumberCase{"1E5", 1e5}, NumberCase{"-1.5e-3", -1.5e-3},
                    NumberCase{"1e+05", 1e5}, NumberCase{"007", 7}, NumberCase{"0e5", 0},
                    NumberCase{"0.00e-999", 0}, NumberCase{"0e99999999999999999999", 0},
                    NumberCase{"1.7976931348623157e308", std::numeric_limits<double>::max()},
                    NumberCase{"2.2250738585072014e-308", std::numeric_limits<double>::min()},
                    NumberCase{"5e-324", std::numeric_limits<double>::denorm_min()},
                    NumberCase{"0.1000000000000000055511151231257827", 0.1}));

class RefusedNumber : public testing::TestWithParam<std::string_view> {};

TEST_P(RefusedNumber, IsNoNumber) { EXPECT_EQ(FiniteNumber(GetParam()), std::nullopt); }

INSTANTIATE_TEST_SUITE_P(Texts, RefusedNumber,
                         testing::Values("", " ", "4O", "O", "nan", "NaN", "+nan", "-nan", "nan(0)",
                                         "inf", "+inf", "-inf", "infinity", " 1", "1 ", "\t1",
                                         "1\n", "+", "-", "+-1", "-+1", "++1", "--1", "+ 1", "1,5",
                                         "1.2.3", "0x10", "1e", "1e+", "e5", ".", "1e400", "-1e400",
                                         "1e-400", "-1e-400", "2e-324", "0.0000001e-320",
                                         "1e99999999999999999999", "1f", "1_000", "one",
                                         std::string_view("1\0", 2)));

// What FiniteNumber has to do, by the standard library, which not every compiler's has.
std::optional<double> FromChars(std::string_view text) {
  if (text.size() > 1 && text.front() == '+' && text[1] != '-' && text[1] != '+') {
    text.remove_prefix(1);
  }
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_whole = end == text.data() + text.size();
  return error == std::errc() && is_whole && std::isfinite(value) ? std::optional(value)
                                                                  : std::nullopt;
}

// Bits of a number; of none those of a NaN, which is never read.
std::uint64_t Bits(const std::optional<double>& number) {
  return std::bit_cast<std::uint64_t>(number.value_or(std::nan("")));
}

// Numbers of any length and size: the doubles are from 1e-323 to 1e308.
rc::Gen<std::string> NumberLikeText() {
  return rc::gen::exec([] {
    const auto digits = rc::gen::container<std::string>(
        rc::gen::weightedOneOf<char>({{1, rc::gen::just('0')}, {2, rc::gen::inRange('0', ':')}}));
    std::string text = *rc::gen::element<std::string>("", "", "-", "+") + *digits;
    if (*rc::gen::arbitrary<bool>()) text += "." + *digits;
    if (*rc::gen::arbitrary<bool>()) {
      text += *rc::gen::element<std::string>("e", "E") +
              *rc::gen::element<std::string>("", "-", "-", "+") +
              std::to_string(*rc::gen::inRange(0, 400));
    }
    return text;
  });
}

RC_GTEST_PROP(FiniteNumber, IsThatOfTheStandardLibrary, ()) {
  const std::string text = *NumberLikeText();
  RC_CLASSIFY(FromChars(text).has_value(), "accepted");
  RC_ASSERT(Bits(FiniteNumber(text)) == Bits(FromChars(text)));
}

RC_GTEST_PROP(FiniteNumber, RefusesWhatTheStandardLibraryRefuses, ()) {
  // One character more, less or another.
  constexpr std::string_view kCharacters("0123456789+-.eEpPxXnaif()_', \0", 29);
  std::string text = *NumberLikeText();
  const std::size_t at = *rc::gen::inRange<std::size_t>(0, text.size() + 1);
  const std::string put(*rc::gen::inRange<std::size_t>(0, 2),
                        *rc::gen::elementOf(std::string(kCharacters)));
  text.replace(at, std::min(*rc::gen::inRange<std::size_t>(0, 2), text.size() - at), put);
  RC_CLASSIFY(FromChars(text).has_value(), "accepted");
  RC_ASSERT(Bits(FiniteNumber(text)) == Bits(FromChars(text)));
}

// Where rounding is hardest: half way between two doubles, and a digit far behind beside it.
RC_GTEST_PROP(FiniteNumber, IsRoundedToTheNearestDouble, ()) {
  const double number = *AnyFiniteNumber();
  std::array<char, 1200> buffer{};
  // The double above has one bit more; 53 + 1 bits are exact in this type.
  const long double half_way =
      (static_cast<long double>(number) +
       static_cast<long double>(std::nextafter(number, std::numeric_limits<double>::infinity()))) /
      2;
  RC_PRE(std::isfinite(half_way));
  const int length = std::snprintf(buffer.data(), buffer.size(), "%.780Le", half_way);
  RC_PRE(length > 0);
  std::string text(buffer.data(), static_cast<std::size_t>(length));
  const int beside = *rc::gen::inRange(0, 3);
  if (beside > 0) text[text.find('e') - 1] = beside == 1 ? '1' : '9';
  RC_ASSERT(Bits(FiniteNumber(text)) == Bits(FromChars(text)));
}

RC_GTEST_PROP(NumberText, ReadsBackAsTheSameBits, ()) {
  const double number = *AnyFiniteNumber();
  const auto back = FiniteNumber(NumberText(number));
  RC_ASSERT(back.has_value());
  RC_ASSERT(std::bit_cast<std::uint64_t>(*back) == std::bit_cast<std::uint64_t>(number));
}

// The digits before an exponent, without sign and point and the zeros at either end.
std::string SignificantDigits(const std::string& text) {
  std::string digits;
  for (const char c : text.substr(0, text.find('e'))) {
    if (c >= '0' && c <= '9') digits += c;
  }
  const std::size_t first = digits.find_first_not_of('0');
  return first == std::string::npos
             ? ""
             : digits.substr(first, digits.find_last_not_of('0') - first + 1);
}

RC_GTEST_PROP(NumberText, HasNoDigitToSpare, ()) {
  const double number = *AnyFiniteNumber();
  const std::string text = NumberText(number);
  // A whole number without an exponent is shortest as it is, whatever its digits.
  RC_PRE(text.find_first_of(".e") != std::string::npos);
  const std::size_t digits = SignificantDigits(text).size();
  RC_PRE(digits > 1U);
  std::ostringstream shorter;
  shorter.precision(static_cast<std::streamsize>(digits) - 2);
  shorter << std::scientific << number;
  RC_ASSERT(FiniteNumber(shorter.str()) != number);
}

TEST(NumberText, IsThatOfAShortDecimal) {
  EXPECT_EQ(NumberText(0.1), "0.1");
  EXPECT_EQ(NumberText(-22.5), "-22.5");
  EXPECT_EQ(NumberText(500), "500");
}

TEST(NumberText, OfTheLongestNumbersIsWhole) {
  for (const double number :
       {-std::numeric_limits<double>::max(), -std::numeric_limits<double>::denorm_min(),
        -2.2250738585072011e-308, -1.2345678901234567e-100}) {
    EXPECT_EQ(FiniteNumber(NumberText(number)), number);
  }
}

TEST(AppendNumber, WritesBehindWhatIsThere) {
  std::string text = "1 ";
  AppendNumber(text, 0.25);
  EXPECT_EQ(text, "1 0.25");
}

struct RoundedCase {
  double number;
  int decimals;
  const char* text;
};

void PrintTo(const RoundedCase& rounded, std::ostream* out) {
  *out << rounded.number << " to " << rounded.decimals << " decimals";
}

class Rounded : public testing::TestWithParam<RoundedCase> {};

TEST_P(Rounded, IsWrittenWithoutZerosAtItsEnd) {
  EXPECT_EQ(RoundedText(GetParam().number, GetParam().decimals), GetParam().text);
}

INSTANTIATE_TEST_SUITE_P(Numbers, Rounded,
                         testing::Values(RoundedCase{2.5, 3, "2.5"}, RoundedCase{2.46, 1, "2.5"},
                                         RoundedCase{2, 4, "2"}, RoundedCase{100, 0, "100"},
                                         RoundedCase{1200, 2, "1200"}, RoundedCase{99.96, 1, "100"},
                                         RoundedCase{-0.04, 1, "0"}, RoundedCase{-0.0, 2, "0"},
                                         RoundedCase{-0.0, 0, "0"}, RoundedCase{0.004, 2, "0"},
                                         RoundedCase{-0.06, 1, "-0.1"},
                                         RoundedCase{1e22, 2, "10000000000000000000000"}));

RC_GTEST_PROP(RoundedText, IsAtMostHalfItsLastPlaceOff, ()) {
  const double number = *NumberWithin(-1000, 1000);
  const int decimals = *rc::gen::inRange(0, 10);
  const auto back = FiniteNumber(RoundedText(number, decimals));
  RC_ASSERT(back.has_value());
  constexpr double kRounding = 1e-12;  // of numbers up to a thousand
  RC_ASSERT(std::abs(*back - number) <= 0.5 * std::pow(10, -decimals) + kRounding);
}

TEST(RoundedText, OfTheLargestNumberIsWhole) {
  EXPECT_EQ(FiniteNumber(RoundedText(-std::numeric_limits<double>::max(), 15)),
            -std::numeric_limits<double>::max());
}

// What std::to_chars makes of it, without the zeros at the end and without a sign before zero.
std::string ToCharsRounded(double number, int decimals = 12) {
  std::array<char, 400> buffer{};
  const auto written = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number,
                                     std::chars_format::fixed, decimals);
  std::string text(buffer.data(), written.ptr);
  if (text.find('.') != std::string::npos) {
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string AppendedRounded(double number, int decimals = 12) {
  std::string text = "1 ";
  AppendRounded(text, number, decimals);
  EXPECT_EQ(text.substr(0, 2), "1 ");
  return text.substr(2);
}

RC_GTEST_PROP(AppendRounded, WritesWhatToCharsWrites, ()) {
  // Of all sizes: the exponent is drawn, not the number.
  const double number = *NumberWithin(-1, 1) * std::ldexp(1.0, *rc::gen::inRange(-50, 60));
  RC_ASSERT(AppendedRounded(number) == ToCharsRounded(number));
}

TEST(AppendRounded, WritesWhatToCharsWritesForManyAngles) {
  std::mt19937_64 random(20090815);
  std::uniform_real_distribution<double> angle_deg(-1000, 1000);
  for (int i = 0; i < 200'000; ++i) {
    const double number = angle_deg(random);
    ASSERT_EQ(AppendedRounded(number), ToCharsRounded(number));
  }
}

TEST(AppendRounded, WritesWhatToCharsWritesWithAnyDecimals) {
  std::mt19937_64 random(20090816);
  std::uniform_real_distribution<double> angle_deg(-1000, 1000);
  for (int decimals = 0; decimals <= 15; ++decimals) {
    for (int i = 0; i < 5000; ++i) {
      const double number = std::ldexp(angle_deg(random), -(i % 40));
      ASSERT_EQ(AppendedRounded(number, decimals), ToCharsRounded(number, decimals)) << decimals;
    }
    // Exact halves of the last decimal, and a number that is rounded up to 1000.
    for (const double number : {0.5, 2.5, -0.5, 0.25, 0.375, 999.99999999999997, 999.5}) {
      ASSERT_EQ(AppendedRounded(number, decimals), ToCharsRounded(number, decimals)) << decimals;
    }
  }
}

TEST(AppendRounded, RoundsHalvesToTheEvenDigit) {
  // k / 2^13 has 13 decimals, the last of them a 5: an exact half of the last place.
  for (int k = 1; k < 1 << 13; k += 2) {
    const double number = k / 8192.0;
    for (const double half : {number, -number, 999 + number}) {
      for (const double near : {half, std::nextafter(half, -1e3), std::nextafter(half, 1e3)}) {
        ASSERT_EQ(AppendedRounded(near), ToCharsRounded(near)) << k;
      }
    }
  }
  EXPECT_EQ(AppendedRounded(1 / 8192.0), "0.000122070312");
  EXPECT_EQ(AppendedRounded(3 / 8192.0), "0.000366210938");
}

struct WrittenCase {
  double number;
  const char* text;
};

void PrintTo(const WrittenCase& written, std::ostream* out) { *out << written.text; }

class RoundedToTwelve : public testing::TestWithParam<WrittenCase> {};

TEST_P(RoundedToTwelve, IsWrittenInFixedNotation) {
  EXPECT_EQ(AppendedRounded(GetParam().number), GetParam().text);
}

INSTANTIATE_TEST_SUITE_P(
    Numbers, RoundedToTwelve,
    testing::Values(WrittenCase{0, "0"}, WrittenCase{-0.0, "0"}, WrittenCase{1e-13, "0"},
                    WrittenCase{-1e-13, "0"}, WrittenCase{4.9999e-13, "0"},
                    WrittenCase{5.0001e-13, "0.000000000001"},
                    WrittenCase{-6e-13, "-0.000000000001"}, WrittenCase{1e-12, "0.000000000001"},
                    WrittenCase{5e-324, "0"}, WrittenCase{0.1, "0.1"}, WrittenCase{-22.5, "-22.5"},
                    WrittenCase{9.9999999999996, "10"}, WrittenCase{99.99999999999996, "100"},
                    WrittenCase{10, "10"}, WrittenCase{305, "305"},
                    WrittenCase{100.000000000001, "100.000000000001"},
                    WrittenCase{999.999999999999, "999.999999999999"},
                    WrittenCase{999.9999999999999, "1000"},
                    WrittenCase{-999.9999999999999, "-1000"}, WrittenCase{1000, "1000"},
                    WrittenCase{-1234.5, "-1234.5"}, WrittenCase{1e22, "10000000000000000000000"},
                    WrittenCase{std::numeric_limits<double>::infinity(), "inf"},
                    WrittenCase{-std::numeric_limits<double>::infinity(), "-inf"},
                    WrittenCase{std::numeric_limits<double>::quiet_NaN(), "nan"}));

TEST(SignificantText, HasSoManyDigitsAtMost) {
  EXPECT_EQ(SignificantText(123.456, 3), "123");
  EXPECT_EQ(SignificantText(0.0123456, 3), "0.0123");
  EXPECT_EQ(SignificantText(2.5, 3), "2.5");
  EXPECT_EQ(SignificantText(1.23456e-12, 3), "1.23e-12");
  EXPECT_EQ(SignificantText(-17.26, 3), "-17.3");
}

RC_GTEST_PROP(SignificantText, IsAtMostHalfItsLastDigitOff, ()) {
  const double number = *NumberWithin(-1000, 1000);
  RC_PRE(number != 0);
  const int digits = *rc::gen::inRange(1, 16);
  const auto back = FiniteNumber(SignificantText(number, digits));
  RC_ASSERT(back.has_value());
  const double last_digit = std::pow(10, std::floor(std::log10(std::abs(number))) - digits + 1);
  constexpr double kRounding = 1e-12;  // of numbers up to a thousand
  RC_ASSERT(std::abs(*back - number) <= 0.5 * last_digit + kRounding);
}

RC_GTEST_PROP(SignificantText, OfSeventeenDigitsReadsBackExactly, ()) {
  const double number = *AnyFiniteNumber();
  RC_ASSERT(FiniteNumber(SignificantText(number, 17)) == number);
}

// A locale that writes 1.234,5.
class CommaForPoint : public std::numpunct<char> {
 protected:
  [[nodiscard]] char do_decimal_point() const override { return ','; }
  [[nodiscard]] char do_thousands_sep() const override { return '.'; }
  [[nodiscard]] std::string do_grouping() const override { return "\3"; }
};

class NumbersInAnotherLocale : public testing::Test {
 protected:
  void SetUp() override {
    previous_ = std::locale::global(std::locale(std::locale(), new CommaForPoint));
    std::ostringstream control;
    control << 1234.5;
    ASSERT_EQ(control.str(), "1.234,5") << "the locale must be in force";
  }
  void TearDown() override { std::locale::global(previous_); }

 private:
  std::locale previous_;
};

TEST_F(NumbersInAnotherLocale, AreReadAsEver) { EXPECT_EQ(FiniteNumber("1234.5"), 1234.5); }

TEST_F(NumbersInAnotherLocale, AreWrittenAsEver) {
  EXPECT_EQ(NumberText(1234.5), "1234.5");
  EXPECT_EQ(RoundedText(1234.56, 1), "1234.6");
  EXPECT_EQ(AppendedRounded(234.5), "234.5");
  EXPECT_EQ(AppendedRounded(1234.5), "1234.5");
}

}  // namespace
}  // namespace girdle::number_text_test
