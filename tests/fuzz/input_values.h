// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Values that an input is made of, for what is no text.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

#include "reading.h"

namespace girdle::fuzz {

/// Takes values from the front of an input. Behind its end all bytes are 0.
class InputValues {
 public:
  explicit InputValues(std::string_view bytes) : rest_(bytes) {}

  [[nodiscard]] bool empty() const noexcept { return rest_.empty(); }
  /// The bytes that have not been taken.
  [[nodiscard]] std::string rest() const { return std::string(rest_); }

  /// Takes a byte, 0 to 255.
  unsigned TakeByte() {
    if (rest_.empty()) {
      return 0;
    }
    const auto byte = static_cast<unsigned char>(rest_.front());
    rest_.remove_prefix(1);
    return byte;
  }

  /// Takes two bytes as a number below `count`. Precondition: 0 < count <= 65536.
  std::size_t TakeBelow(std::size_t count) {
    const std::size_t high = TakeByte();
    return (high << 8U | TakeByte()) % count;
  }

  /// Takes four bytes as a number of single precision, which may be infinite or none.
  float TakeFloat() {
    std::uint32_t bits = 0;
    for (int i = 0; i < 4; ++i) {
      bits = bits << 8U | TakeByte();
    }
    return std::bit_cast<float>(bits);
  }

 private:
  std::string_view rest_;
};

}  // namespace girdle::fuzz
