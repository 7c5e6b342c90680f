// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The reasons why the AC joint of a loop is open. The plugin and the program use the text of this
/// header.
#pragma once

#include <string>

namespace girdle {

/// Facts of a compiled model about the closing of its loop.
struct LoopClosing {
  bool constraints_are_disabled = false;
  bool equalities_are_disabled = false;
  bool has_connect = false;      ///< between a site of the clavicle and a site of the scapula
  bool starts_inactive = false;  ///< true if every such connect starts inactive
};

/// Returns the reason why the joint is open with the line to write, or an empty text if it is
/// closed.
[[nodiscard]] inline std::string OpenLoopFault(const LoopClosing& closing) {
  const auto fault = [](const std::string& reason, const std::string& line) {
    return "nothing holds the AC joint of the loop, because " + reason + ": write " + line;
  };
  if (closing.constraints_are_disabled) {
    return fault("constraints are disabled", "<flag constraint=\"enable\"/> in <option>");
  }
  if (closing.equalities_are_disabled) {
    return fault("equalities are disabled", "<flag equality=\"enable\"/> in <option>");
  }
  if (!closing.has_connect) {
    return fault("no <connect> of two sites joins clavicle and scapula",
                 "<connect site1=\"...\" site2=\"...\"/> in <equality>, with a site of each bone "
                 "where the joint is");
  }
  return closing.starts_inactive ? fault("its <connect> starts inactive", "active=\"true\" there")
                                 : "";
}

}  // namespace girdle
