// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/random_name.h"

#include <sys/random.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "text/input_error.h"

namespace girdle {

std::string RandomName() {
  std::uint64_t number = 0;
  if (getrandom(&number, sizeof(number), 0) != sizeof(number)) {
    throw InputError("cannot get random bytes: " + std::string(std::strerror(errno)) +
                     ". Give the program access to the system call getrandom");
  }
  constexpr int kHexadecimal = 16;
  constexpr std::size_t kMostDigits = 16;
  std::array<char, kMostDigits> digits{};
  char* const begin = digits.data();
  return {begin, std::to_chars(begin, begin + kMostDigits, number, kHexadecimal).ptr};
}

}  // namespace girdle
