// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Progress of long work on a terminal.
#pragma once

#include <string>

namespace girdle {

/// A line on standard error that shows how much is done. Nothing is shown if standard error is not
/// a terminal. The destructor removes the line, so that a later message does not run into it.
class TerminalProgress {
 public:
  /// Shows nothing if `wanted` is false, for example where the result itself goes to the terminal.
  explicit TerminalProgress(std::string label, bool wanted = true);
  TerminalProgress(const TerminalProgress&) = delete;
  TerminalProgress& operator=(const TerminalProgress&) = delete;
  ~TerminalProgress();

  /// Shows how much is done, 0 to 1.
  void operator()(double done);
  /// Removes the line.
  void Clear();

 private:
  std::string label_;
  bool is_shown_;
  int shown_percent_ = -1;  ///< -1 while no line is shown
};

}  // namespace girdle
