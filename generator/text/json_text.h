// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Writing JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace girdle {

/// Returns the text of a report, indented, with a line end at its end. Names of files may have any
/// bytes. Bytes that are not UTF-8 become U+FFFD, because JSON cannot hold them.
template <typename Json>
[[nodiscard]] std::string JsonText(const Json& json) {
  constexpr int kIndent = 2;
  return json.dump(kIndent, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace girdle
