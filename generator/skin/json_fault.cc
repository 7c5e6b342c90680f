// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/json_fault.h"

namespace girdle {

std::string JsonFault(const nlohmann::json::exception& error) {
  constexpr int kNumberOverflow = 406;  // its text has the number
  if (const auto* const parsing = dynamic_cast<const nlohmann::json::parse_error*>(&error)) {
    return "no JSON at byte " + std::to_string(parsing->byte);
  }
  return error.id == kNumberOverflow ? "a number is too large" : error.what();
}

}  // namespace girdle
