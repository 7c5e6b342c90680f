// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "tables/number_text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace girdle {
namespace {

// Longest shortest-form double: sign, 17 digits, point, exponent of five characters.
constexpr std::size_t kLongestNumber = 32;
// The largest double in fixed notation has 309 digits before the point; decimals come on top.
constexpr std::size_t kLongestFixedNumber = 400;

}  // namespace

std::optional<double> FiniteNumber(std::string_view text) noexcept {
  if (text.size() > 1 && text.front() == '+' && text[1] != '-' && text[1] != '+') {
    text.remove_prefix(1);
  }
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
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

}  // namespace girdle
