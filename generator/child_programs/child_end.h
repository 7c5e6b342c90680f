// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Waiting for the end of child processes, and how they ended.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>

namespace girdle {

/// How a process ended.
struct ChildEnd {
  bool by_signal = false;
  int number = 0;  ///< number of the signal if a signal ended it, else the exit status

  [[nodiscard]] bool is_fine() const noexcept { return !by_signal && number == 0; }
  /// Returns a predicate whose subject is the process: `ended with status 3`, `was ended by a
  /// signal: Killed`. Empty if the process ended with status 0.
  [[nodiscard]] std::string text() const;
};

/// Makes the system report how children of this process end. The system does not if this process
/// was started with SIGCHLD ignored.
void HearHowChildrenEnd() noexcept;

/// Waits for a child's end. If its end was already waited for elsewhere, it counts as a program
/// that cannot be run.
[[nodiscard]] ChildEnd WaitForEnd(pid_t child) noexcept;

/// Waits at most that long; returns nothing if the child still runs.
[[nodiscard]] std::optional<ChildEnd> WaitForEnd(pid_t child,
                                                 std::chrono::milliseconds longest) noexcept;

/// Exit status of shells that cannot run a program.
inline constexpr int kCannotRun = 127;

}  // namespace girdle
