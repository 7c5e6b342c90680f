// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// A file descriptor that the destructor closes.
#pragma once

#include <unistd.h>

#include <utility>

namespace girdle {

class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) noexcept : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(other.Release()) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    if (this != &other) {
      Close();
      number_ = other.Release();
    }
    return *this;
  }
  ~Descriptor() { Close(); }

  /// Returns the descriptor's number, or -1 for none.
  [[nodiscard]] int get() const noexcept { return number_; }
  void Close() noexcept {
    if (number_ >= 0) {
      close(Release());
    }
  }

 private:
  int Release() noexcept { return std::exchange(number_, -1); }

  int number_ = -1;
};

}  // namespace girdle
