// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The one exception of offline code: something the user gave cannot be used.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace girdle {

/// Bad input or an output that cannot be written. The message names the place, the value and the
/// fix.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;

  /// Message of the form `file:line: message`.
  InputError(const std::string& file, std::size_t line, const std::string& message)
      : std::runtime_error(file + ":" + std::to_string(line) + ": " + message) {}
};

}  // namespace girdle
