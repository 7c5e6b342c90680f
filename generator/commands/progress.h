// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Progress of long work on a terminal.
#pragma once

#include <string>

namespace girdle {

/// A line on standard error that says how much is done; nothing where that is no terminal. The line
/// is gone when the object is, so that a message after it stands alone.
class TerminalProgress {
 public:
  /// Shows nothing if `wanted` is false, as where the result itself goes to the terminal.
  explicit TerminalProgress(std::string label, bool wanted = true);
  TerminalProgress(const TerminalProgress&) = delete;
  TerminalProgress& operator=(const TerminalProgress&) = delete;
  ~TerminalProgress();

  /// Shows how much is done, 0 to 1.
  void operator()(double done);
  /// Takes the line away.
  void Clear();

 private:
  std::string label_;
  bool is_shown_;
  int shown_percent_ = -1;  ///< -1 while no line stands
};

}  // namespace girdle
