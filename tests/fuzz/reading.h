// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// What every fuzzer of this folder expects of a reader: it returns, or it throws InputError with a
/// short message. Anything else is a finding: it ends the process, and libFuzzer keeps the input.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "text/input_error.h"

namespace girdle::fuzz {

/// Most bytes of a message that a person reads.
inline constexpr std::size_t kLongestMessage = 4096;

/// The name that readers are given for the input.
inline constexpr const char* kName = "input";

/// Reports a finding and ends the process.
[[noreturn]] inline void Report(const std::string& finding) {
  std::cerr << "finding: " << finding << '\n';
  std::abort();
}

/// Reports a finding unless `holds`.
inline void Expect(bool holds, const char* what) {
  if (!holds) {
    Report(std::string("not so: ") + what);
  }
}

/// Returns the result of a reader; nothing if it throws InputError. Reports any other exception,
/// and a message that is empty or longer than kLongestMessage.
template <std::invocable Read>
[[nodiscard]] std::optional<std::invoke_result_t<Read>> ResultOf(const Read& read) {
  try {
    return read();
  } catch (const InputError& error) {
    const std::string_view message = error.what();
    if (message.empty() || message.size() > kLongestMessage) {
      Report("a message of " + std::to_string(message.size()) +
             " bytes: " + std::string(message.substr(0, kLongestMessage)));
    }
  } catch (const std::exception& error) {
    Report(std::string("an exception other than InputError: ") + error.what());
  }
  return std::nullopt;
}

/// Returns the bytes of an input.
[[nodiscard]] inline std::string BytesOf(const std::uint8_t* bytes, std::size_t size) {
  return {bytes, bytes + size};
}

/// Stands in a text for kCopies copies of the byte before it, because libFuzzer makes no long
/// words.
inline constexpr char kRepeat = '\x1a';
inline constexpr std::size_t kCopies = 5000;

/// Returns the bytes of an input as text: the first kRepeat stands for copies.
[[nodiscard]] inline std::string TextOf(const std::uint8_t* bytes, std::size_t size) {
  std::string text = BytesOf(bytes, size);
  const std::size_t place = text.find(kRepeat, 1);
  if (place != std::string::npos) {
    text.replace(place, 1, kCopies, text[place - 1]);
  }
  return text;
}

}  // namespace girdle::fuzz
