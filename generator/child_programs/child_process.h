// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Work in a child process, which may crash, hang or be hostile without harm to this process.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace girdle {

/// Output and end of a child.
struct ChildResult {
  std::string output;    ///< its output up to its end or its crash
  std::string failure;   ///< how it ended; empty if it ended with status 0
  bool is_late = false;  ///< whether it was ended because its time was over
};

/// Limits of a child.
struct ChildLimits {
  int time_s = 0;                        ///< longest time from its start to its end [s]
  std::size_t output_bytes = 1'000'000;  ///< most output
  /// Most memory for its data, those of this process included; 0 for no limit. Beyond it, the child
  /// is given no memory, which is std::bad_alloc in C++. Not applied in a build with
  /// AddressSanitizer, which reserves terabytes.
  std::size_t memory_bytes = 0;
};

/// Runs `work` in a copy of this process and gives it a function that writes to `output`. Waits for
/// its end at most `limits.time_s` seconds, and up to 2 s more until its processes are gone.
///
/// The child's current folder is `/`. Its standard output goes to `output` too, its standard error
/// is discarded, and its standard input is empty. It is ended when its time is over or when it has
/// written more than `limits.output_bytes`. A crash leaves no core file. All processes that it
/// started end with it, including those in a session of their own. Processes in sessions that
/// existed before are not ended. The child's parent is a process between this one and the child: a
/// child that kills its parent ends itself.
///
/// Call this only while this process has one thread. This process becomes the parent of the orphans
/// among its descendants (PR_SET_CHILD_SUBREAPER). Throws InputError if no process can be made.
[[nodiscard]] ChildResult RunInChild(
    const std::function<void(const std::function<void(std::string_view)>& write)>& work,
    const ChildLimits& limits);

/// Runs a program in a child as RunInChild does. A program that cannot be run ends with kCannotRun.
[[nodiscard]] ChildResult RunProgramInChild(const std::filesystem::path& program,
                                            std::vector<std::string> arguments,
                                            const ChildLimits& limits);

}  // namespace girdle
