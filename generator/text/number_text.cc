// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "text/number_text.h"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace girdle {
namespace {

// Bytes of the longest double in its shortest form: sign, 17 digits, point, exponent of five
// characters.
constexpr std::size_t kLongestNumber = 32;
// The largest double in fixed notation has 309 digits before the point, and decimals after it.
constexpr std::size_t kLongestFixedNumber = 400;

constexpr double kFastBelow = 1000;
// Bytes of a sign, three digits, a point and decimals.
constexpr std::size_t kLongestRounded = 1 + 3 + 1 + kMostFastDecimals;

// Returns base^0, base^1, ... base^kMostFastDecimals.
constexpr auto PowersOf(std::uint64_t base) {
  std::array<std::uint64_t, kMostFastDecimals + 1> powers{1};
  for (std::size_t i = 1; i < powers.size(); ++i) {
    powers.at(i) = base * powers.at(i - 1);
  }
  return powers;
}
constexpr auto kPowersOfFive = PowersOf(5);
constexpr auto kPowersOfTen = PowersOf(10);

// Returns |value| 10^d rounded to a whole number, halves to the even number, for |value| < 1000 and
// d from 0 to 12.
//
//   |value| = m 2^e   =>   |value| 10^d = m 5^d 2^(e + d)
//
// All steps use whole numbers: m 5^d has at most 81 bits, and e + d is negative.
std::uint64_t RoundedUnits(double value, int d) {
  using Uint128 = unsigned __int128;
  constexpr int kFractionBits = std::numeric_limits<double>::digits - 1;
  constexpr int kExponentBias = std::numeric_limits<double>::max_exponent - 1 + kFractionBits;
  constexpr int kProductBits = 81;
  constexpr std::uint64_t kHiddenBit = std::uint64_t{1} << kFractionBits;

  const auto bits = std::bit_cast<std::uint64_t>(std::abs(value));
  const int shift = kExponentBias - d - static_cast<int>(bits >> kFractionBits);
  // The number is below half a unit. All numbers without a hidden bit are.
  if (shift > kProductBits) {
    return 0;
  }
  const Uint128 product =
      Uint128{(bits & (kHiddenBit - 1)) | kHiddenBit} * kPowersOfFive[static_cast<std::size_t>(d)];
  // Adds just under one half, or exactly one half if the digit is odd. The shift then cuts off the
  // rest.
  const Uint128 under_half = (Uint128{1} << (shift - 1)) - 1;
  const Uint128 odd = (product >> shift) & 1;
  return static_cast<std::uint64_t>((product + under_half + odd) >> shift);
}

constexpr std::array<char, 200> kDigitPairs = [] {
  std::array<char, 200> pairs{};
  for (std::size_t i = 0; i < pairs.size() / 2; ++i) {
    pairs[2 * i] = static_cast<char>('0' + i / 10);
    pairs[2 * i + 1] = static_cast<char>('0' + i % 10);
  }
  return pairs;
}();

// Writes two digits, leading zeros included, and returns the place behind them.
char* WritePair(char* out, std::uint32_t number) {
  std::memcpy(out, &kDigitPairs[std::size_t{2} * number], 2);
  return out + 2;
}

char* WriteSixDigits(char* out, std::uint32_t number) {
  out = WritePair(out, number / 10'000);
  out = WritePair(out, number / 100 % 100);
  return WritePair(out, number % 100);
}

// Writes a number below 1000 without leading zeros. Up to two characters behind it may be
// overwritten.
char* WriteWhole(char* out, std::uint32_t number) {
  std::array<char, 5> digits{static_cast<char>('0' + number / 100)};
  WritePair(&digits[1], number % 100);
  // The number of digits is nearly random, so a branch would be slow.
  const std::size_t zeros = (number < 10 ? 1U : 0U) + (number < 100 ? 1U : 0U);
  std::memcpy(out, &digits[zeros], 3);
  return out + 3 - zeros;
}

// Whether all digits of a number are zero. If not, a value of 0 means that it is too small for a
// double.
bool IsZero(std::string_view number) {
  const std::string_view digits = number.substr(0, number.find_first_of("eE"));
  return std::all_of(digits.begin(), digits.end(),
                     [](char digit) { return digit < '1' || digit > '9'; });
}

}  // namespace

std::optional<double> FiniteNumber(std::string_view text, char decimal_mark) noexcept {
  if (text.size() > 1 && text.front() == '+' && text[1] != '-' && text[1] != '+') {
    text.remove_prefix(1);
  }
  // Used in place of std::from_chars, which Clang's own library lacks for double before version 20.
  double value = 0;
  const auto [end, error] = fast_float::from_chars_advanced(
      text.data(), text.data() + text.size(), value,
      fast_float::parse_options{fast_float::chars_format::general, decimal_mark});
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value) ||
      (value == 0 && !IsZero(text))) {
    return std::nullopt;
  }
  return value;
}

void AppendNumber(std::string& text, double value) {
  std::array<char, kLongestNumber> buffer;  // NOLINT(*-member-init): filled by to_chars
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  text.append(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
}

std::string NumberText(double value) {
  std::string text;
  AppendNumber(text, value);
  return text;
}

std::string SignificantText(double value, int digits) {
  std::array<char, kLongestNumber> buffer;  // NOLINT(*-member-init): filled by to_chars
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                          std::chars_format::general, digits);
  return {buffer.data(), end};
}

void AppendRounded(std::string& text, double value, int decimals) {
  const bool is_fast = std::abs(value) < kFastBelow && decimals <= kMostFastDecimals;
  const std::uint64_t units = is_fast ? RoundedUnits(value, decimals) : 0;
  const std::uint64_t units_per_one =
      is_fast ? kPowersOfTen[static_cast<std::size_t>(decimals)] : 1;
  // A number just below 1000 may be rounded up to 1000.
  if (!is_fast || units >= static_cast<std::uint64_t>(kFastBelow) * units_per_one) {
    text += RoundedText(value, decimals);
    return;
  }
  std::array<char, kLongestRounded> buffer;  // NOLINT(*-member-init): written below
  char* out = buffer.data();
  *out = '-';
  out += std::signbit(value) && units > 0 ? 1 : 0;
  out = WriteWhole(out, static_cast<std::uint32_t>(units / units_per_one));
  if (const std::uint64_t fraction = units % units_per_one; fraction > 0) {
    constexpr std::uint64_t kHalf = 1'000'000;
    const std::uint64_t twelve_digits =
        fraction * kPowersOfTen[static_cast<std::size_t>(kMostFastDecimals - decimals)];
    *out++ = '.';
    out = WriteSixDigits(out, static_cast<std::uint32_t>(twelve_digits / kHalf));
    if (twelve_digits % kHalf > 0) {
      out = WriteSixDigits(out, static_cast<std::uint32_t>(twelve_digits % kHalf));
    }
    while (out[-1] == '0') {
      --out;
    }
  }
  text.append(buffer.data(), static_cast<std::size_t>(out - buffer.data()));
}

std::string RoundedText(double value, int decimals) {
  std::array<char, kLongestFixedNumber> buffer;  // NOLINT(*-member-init): filled by to_chars
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                          std::chars_format::fixed, decimals);
  std::string text(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') {
      text.pop_back();
    }
  }
  return text == "-0" ? "0" : text;
}

std::string CountText(std::uintmax_t count, std::string_view noun) {
  return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

}  // namespace girdle
