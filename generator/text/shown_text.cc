// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "text/shown_text.h"

#include <array>

#include "text/number_text.h"

namespace girdle {
namespace {

using Byte = unsigned char;

constexpr Byte kContinuationMask = 0xC0;
constexpr Byte kContinuation = 0x80;

bool IsContinuation(char c) noexcept {
  return (static_cast<Byte>(c) & kContinuationMask) == kContinuation;
}

// The bytes that begin a character of UTF-8 with more than one byte (RFC 3629, section 4), and
// the range of the byte that may follow. U+0080 to U+009F, the control characters C1, are left out.
struct LeadBytes {
  Byte first;
  Byte last;
  Byte lowest_second;
  Byte highest_second;
  std::size_t size;  // of the character
};
constexpr std::array<LeadBytes, 9> kLeadBytes = {{
    {0xC2, 0xC2, 0xA0, 0xBF, 2},
    {0xC3, 0xDF, 0x80, 0xBF, 2},
    {0xE0, 0xE0, 0xA0, 0xBF, 3},
    {0xE1, 0xEC, 0x80, 0xBF, 3},
    {0xED, 0xED, 0x80, 0x9F, 3},
    {0xEE, 0xEF, 0x80, 0xBF, 3},
    {0xF0, 0xF0, 0x90, 0xBF, 4},
    {0xF1, 0xF3, 0x80, 0xBF, 4},
    {0xF4, 0xF4, 0x80, 0x8F, 4},
}};

// Returns the size of the character that `text` begins with; 0 if a terminal must not get it.
std::size_t PrintableSize(std::string_view text) noexcept {
  constexpr Byte kDelete = 0x7F;
  const auto lead = static_cast<Byte>(text.front());
  if (lead < kContinuation) {
    return (lead >= ' ' && lead != kDelete) || lead == '\n' ? 1 : 0;
  }
  for (const LeadBytes& known : kLeadBytes) {
    if (lead < known.first || lead > known.last) {
      continue;
    }
    if (text.size() < known.size || static_cast<Byte>(text[1]) < known.lowest_second ||
        static_cast<Byte>(text[1]) > known.highest_second) {
      return 0;
    }
    for (std::size_t i = 2; i < known.size; ++i) {
      if (!IsContinuation(text[i])) {
        return 0;
      }
    }
    return known.size;
  }
  return 0;
}

void WriteEscaped(std::ostream& out, char c) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  constexpr unsigned kBase = 16;
  const auto byte = static_cast<Byte>(c);
  const std::array<char, 4> escaped = {'\\', 'x', kDigits[byte / kBase], kDigits[byte % kBase]};
  out.write(escaped.data(), escaped.size());
}

}  // namespace

std::string ShortText(std::string_view text, std::size_t most) {
  if (text.size() <= most) {
    return std::string(text);
  }
  std::size_t end = most;
  while (end > 0 && IsContinuation(text[end])) {
    --end;
  }
  return std::string(text.substr(0, end)) + "... (" + CountText(text.size(), "byte") + ")";
}

void WritePrintable(std::ostream& out, std::string_view message) {
  while (!message.empty()) {
    std::size_t size = 0;
    while (size < message.size()) {
      const std::size_t of_character = PrintableSize(message.substr(size));
      if (of_character == 0) {
        break;
      }
      size += of_character;
    }
    out.write(message.data(), static_cast<std::streamsize>(size));
    message.remove_prefix(size);
    if (!message.empty()) {
      WriteEscaped(out, message.front());
      message.remove_prefix(1);
    }
  }
}

}  // namespace girdle
