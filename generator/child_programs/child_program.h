// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// A program that runs beside this process and is fed through its standard input.
///
/// For work whose result is waited for, which may crash, hang or be hostile, there is
/// child_process.h.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "child_programs/child_end.h"
#include "child_programs/descriptor.h"
#include "child_programs/memory_file.h"

namespace girdle {

/// Number that ProgramFiles::extra has in the program.
inline constexpr int kExtraDescriptor = 3;

/// Open files of this process that a program gets. Its standard input and error are those of
/// ChildProgram.
struct ProgramFiles {
  int output = -1;  ///< its standard output; -1: goes nowhere
  int extra = -1;   ///< its kExtraDescriptor; -1: it has none
};

/// The program is ended with this object. May be used while this process has several threads.
class ChildProgram {
 public:
  /// Starts `program` with `arguments` and this process's environment. Throws InputError if it
  /// cannot be started.
  ChildProgram(const std::filesystem::path& program, std::vector<std::string> arguments,
               const ProgramFiles& files = {});
  ChildProgram(const ChildProgram&) = delete;
  ChildProgram& operator=(const ChildProgram&) = delete;
  ~ChildProgram();

  /// Hands bytes to its standard input and returns whether it took them all: false if it reads no
  /// more. No signal comes of that.
  [[nodiscard]] bool Write(std::span<const std::uint8_t> bytes) noexcept;

  /// Tells it that its input ends.
  void EndInput() noexcept { input_.Close(); }

  /// Waits for its end, which does not come before that of its input for many programs. To be
  /// called once.
  [[nodiscard]] ChildEnd Wait() noexcept;

  /// Waits no longer than that; returns nothing if it still runs.
  [[nodiscard]] std::optional<ChildEnd> Wait(std::chrono::milliseconds longest) noexcept;

  /// Ends it, if it has not ended.
  void End() noexcept;

  /// What it has written to its standard error.
  [[nodiscard]] std::string Errors() const { return errors_.Content(); }

 private:
  MemoryFile errors_;
  Descriptor input_;  ///< our end
  pid_t child_ = -1;  ///< -1 after its end
};

}  // namespace girdle
