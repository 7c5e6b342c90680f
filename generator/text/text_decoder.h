// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Text as editors and spreadsheets store it, as UTF-8 with line feeds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace girdle {

/// Turns the bytes of one file into text, piece by piece.
///
/// A byte-order mark of UTF-8 or UTF-16 at the beginning is left out and chooses the encoding.
/// UTF-16 becomes UTF-8. Bytes of a file without a mark stay, whatever their encoding is. Carriage
/// returns, alone or before a line feed, become line feeds. A plain text is not copied.
class TextDecoder {
 public:
  /// Replaces the bytes of `text` from `begin` on, which are the next piece of the file, by their
  /// text. A character that is cut at the end of the piece is kept back. Returns null, or a fault:
  /// a byte 0, or half of a character of UTF-16. After a fault `text` ends before it.
  [[nodiscard]] const char* Decode(std::string& text, std::size_t begin);

  /// Appends to `text` what was kept back, at the end of the file. Returns null or a fault, as
  /// Decode does.
  [[nodiscard]] const char* Finish(std::string& text);

  /// Bytes of the file for each byte of a plain text: 2 for UTF-16, otherwise 1.
  [[nodiscard]] std::size_t bytes_per_unit() const noexcept {
    return encoding_ == Encoding::kUtf16Little || encoding_ == Encoding::kUtf16Big ? 2 : 1;
  }

 private:
  enum class Encoding { kUnknown, kAsItStands, kUtf16Little, kUtf16Big };

  /// Takes the byte-order mark away. Returns false if further bytes must come to know it.
  [[nodiscard]] bool TakeMark(std::string& text, std::size_t begin);
  [[nodiscard]] const char* DecodeUtf16(std::string& text, std::size_t begin);
  [[nodiscard]] const char* AppendUnit(std::string& text, std::uint32_t unit);
  [[nodiscard]] const char* CorrectLineEnds(std::string& text, std::size_t begin);

  Encoding encoding_ = Encoding::kUnknown;
  std::string kept_back_;             ///< bytes of a mark or of a unit of UTF-16
  std::uint32_t high_surrogate_ = 0;  ///< first half of a character of UTF-16; 0 if none
  bool is_after_return_ = false;      ///< whether the last byte was a carriage return
};

}  // namespace girdle
