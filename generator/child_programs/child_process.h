// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Work in a process of its own, which may crash, hang or be hostile without harm to this one.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace girdle {

/// What a child left.
struct ChildResult {
  std::string output;    ///< what it wrote, to its end or to its crash
  std::string failure;   ///< empty if it ended with status 0, else how it ended
  bool is_late = false;  ///< ended because its time was over
};

/// Runs `work` in a copy of this process, gives it a function that writes to `output`, and waits
/// for it, `limit_s` seconds at most, and up to 2 s more until it is gone.
///
/// The child's current folder is `/`. Its standard output goes to `output` as well, its standard
/// error nowhere, and its standard input is empty. It is ended when the time is over or when it has
/// written more than a megabyte. All processes that it started end with it, also those with a
/// session of their own. Processes in sessions that were there before are left alone. The child's
/// parent is a process between this one and the child: a child that kills its parent ends itself.
///
/// To be called while this process has one thread. This process becomes the parent of the orphans
/// among its descendants (PR_SET_CHILD_SUBREAPER). Throws InputError if no process can be made.
[[nodiscard]] ChildResult RunInChild(
    const std::function<void(const std::function<void(std::string_view)>& write)>& work,
    int limit_s);

/// Runs a program in such a child. A program that cannot be run ends with kCannotRun.
[[nodiscard]] ChildResult RunProgramInChild(const std::filesystem::path& program,
                                            std::vector<std::string> arguments, int limit_s);

}  // namespace girdle
