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
  int number = 0;  ///< of the signal, or else the exit status

  [[nodiscard]] bool is_fine() const noexcept { return !by_signal && number == 0; }
  /// Says it, with the process as what is spoken of: `ended with status 3`, `was ended by a signal:
  /// Killed`. Empty if it is fine.
  [[nodiscard]] std::string text() const;
};

/// Makes the system tell this process how its children end: it does not if whoever started this
/// process had SIGCHLD ignored.
void HearHowChildrenEnd() noexcept;

/// Waits for a child's end. One that somebody else has waited for counts as a program that could
/// not be run.
[[nodiscard]] ChildEnd WaitForEnd(pid_t child) noexcept;

/// Waits no longer than that; returns nothing if the child still runs.
[[nodiscard]] std::optional<ChildEnd> WaitForEnd(pid_t child,
                                                 std::chrono::milliseconds longest) noexcept;

/// What shells end with if they cannot run a program.
inline constexpr int kCannotRun = 127;

}  // namespace girdle
