// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "text/text_decoder.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace girdle {
namespace {

constexpr std::string_view kMarkOfUtf8 = "\xEF\xBB\xBF";
constexpr std::string_view kMarkOfUtf16Little = "\xFF\xFE";
constexpr std::string_view kMarkOfUtf16Big = "\xFE\xFF";

constexpr const char* kByteZero =
    "a byte 0, which no text has. If this is a workbook (.xlsx) or UTF-16 without a byte-order "
    "mark, save it as CSV in UTF-8";
constexpr const char* kHalfCharacter =
    "half of a character of UTF-16. Save the file again, as CSV in UTF-8";

// Halves of characters beyond U+FFFF in UTF-16 (RFC 2781).
constexpr std::uint32_t kFirstHigh = 0xD800;
constexpr std::uint32_t kFirstLow = 0xDC00;
constexpr std::uint32_t kBehindLow = 0xE000;
constexpr std::uint32_t kFirstOfPairs = 0x10000;
constexpr unsigned kBitsOfHalf = 10;

// Appends a character as UTF-8 (RFC 3629). Every byte but the first has six bits of it.
void AppendCharacter(std::string& text, std::uint32_t character) {
  constexpr unsigned kBits = 6;
  constexpr std::uint32_t kMask = (1U << kBits) - 1;
  struct Size {
    std::uint32_t end;   // first character that is too large
    std::uint32_t lead;  // bits of the first byte
    unsigned further;    // bytes
  };
  constexpr std::array<Size, 4> kSizes = {
      {{0x80, 0, 0}, {0x800, 0xC0, 1}, {0x10000, 0xE0, 2}, {0x110000, 0xF0, 3}}};
  for (const Size& size : kSizes) {
    if (character < size.end) {
      text += static_cast<char>(size.lead | (character >> (kBits * size.further)));
      for (unsigned i = size.further; i-- > 0;) {
        text += static_cast<char>(0x80U | ((character >> (kBits * i)) & kMask));
      }
      return;
    }
  }
}

}  // namespace

const char* TextDecoder::Decode(std::string& text, std::size_t begin) {
  if (text.size() == begin) {
    return nullptr;
  }
  if (encoding_ == Encoding::kUnknown && !TakeMark(text, begin)) {
    return nullptr;
  }
  if (bytes_per_unit() == 1) {
    return CorrectLineEnds(text, begin);
  }
  const char* const flaw = DecodeUtf16(text, begin);
  const char* const earlier = CorrectLineEnds(text, begin);
  return earlier != nullptr ? earlier : flaw;
}

const char* TextDecoder::Finish(std::string& text) {
  const std::size_t begin = text.size();
  if (bytes_per_unit() == 2) {
    return kept_back_.empty() && high_surrogate_ == 0 ? nullptr : kHalfCharacter;
  }
  text += kept_back_;
  kept_back_.clear();
  return CorrectLineEnds(text, begin);
}

bool TextDecoder::TakeMark(std::string& text, std::size_t begin) {
  struct Mark {
    std::string_view bytes;
    Encoding encoding;
  };
  constexpr std::array<Mark, 3> kMarks = {{{kMarkOfUtf8, Encoding::kAsItStands},
                                           {kMarkOfUtf16Little, Encoding::kUtf16Little},
                                           {kMarkOfUtf16Big, Encoding::kUtf16Big}}};
  text.insert(begin, kept_back_);
  kept_back_.clear();
  const std::string_view piece = std::string_view(text).substr(begin);
  for (const Mark& mark : kMarks) {
    if (piece.starts_with(mark.bytes)) {
      encoding_ = mark.encoding;
      text.erase(begin, mark.bytes.size());
      return true;
    }
    if (mark.bytes.starts_with(piece)) {
      kept_back_ = piece;
      text.resize(begin);
      return false;
    }
  }
  encoding_ = Encoding::kAsItStands;
  return true;
}

const char* TextDecoder::DecodeUtf16(std::string& text, std::size_t begin) {
  constexpr unsigned kBitsOfByte = 8;
  const std::string bytes = kept_back_ + text.substr(begin);
  text.resize(begin);
  kept_back_.clear();
  const std::size_t high = encoding_ == Encoding::kUtf16Big ? 0 : 1;
  std::size_t i = 0;
  for (; i + 1 < bytes.size(); i += 2) {
    const auto byte = [&](std::size_t k) {
      return std::uint32_t{static_cast<unsigned char>(bytes[k])};
    };
    if (const char* const flaw =
            AppendUnit(text, byte(i + high) << kBitsOfByte | byte(i + 1 - high))) {
      return flaw;
    }
  }
  kept_back_ = bytes.substr(i);
  return nullptr;
}

const char* TextDecoder::AppendUnit(std::string& text, std::uint32_t unit) {
  const bool is_low = unit >= kFirstLow && unit < kBehindLow;
  if (is_low != (high_surrogate_ != 0)) {
    return kHalfCharacter;
  }
  if (is_low) {
    AppendCharacter(
        text, kFirstOfPairs + ((high_surrogate_ - kFirstHigh) << kBitsOfHalf) + (unit - kFirstLow));
    high_surrogate_ = 0;
  } else if (unit >= kFirstHigh && unit < kFirstLow) {
    high_surrogate_ = unit;
  } else {
    AppendCharacter(text, unit);
  }
  return nullptr;
}

// Replaces carriage returns, and looks for a byte 0.
const char* TextDecoder::CorrectLineEnds(std::string& text, std::size_t begin) {
  if (text.size() == begin) {
    return nullptr;
  }
  const char* flaw = nullptr;
  if (const std::size_t zero = text.find('\0', begin); zero != std::string::npos) {
    text.resize(zero);
    flaw = kByteZero;
  }
  if (is_after_return_ && text.size() > begin && text[begin] == '\n') {
    text.erase(begin, 1);
  }
  is_after_return_ = text.size() > begin && text.back() == '\r';
  std::size_t end = text.find('\r', begin);
  if (end == std::string::npos) {
    return flaw;
  }
  // Moves the stretches between carriage returns together.
  std::size_t from = end;
  while (from < text.size()) {
    from += text.compare(from, 2, "\r\n") == 0 ? 2 : 1;
    text[end++] = '\n';
    const std::size_t next = std::min(text.find('\r', from), text.size());
    std::memmove(text.data() + end, text.data() + from, next - from);
    end += next - from;
    from = next;
  }
  text.resize(end);
  return flaw;
}

}  // namespace girdle
