// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// A program that runs beside this process and receives data through its standard input.
///
/// Use child_process.h for work whose result is waited for and which may crash, hang or be hostile.
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

/// Descriptor of ProgramFiles::extra in the program.
inline constexpr int kExtraDescriptor = 3;

/// Open files of this process that a program receives. ChildProgram sets its standard input and
/// standard error.
struct ProgramFiles {
  int output = -1;  ///< its standard output; -1 discards it
  int extra = -1;   ///< its kExtraDescriptor; -1 for none
};

/// A running program. The destructor ends it. May be used while this process has several threads.
class ChildProgram {
 public:
  /// Starts `program` with `arguments` and this process's environment. Throws InputError if it
  /// cannot be started.
  ChildProgram(const std::filesystem::path& program, std::vector<std::string> arguments,
               const ProgramFiles& files = {});
  ChildProgram(const ChildProgram&) = delete;
  ChildProgram& operator=(const ChildProgram&) = delete;
  ~ChildProgram();

  /// Writes bytes to the program's standard input. Returns false if the program no longer reads its
  /// input. No signal is raised in that case.
  [[nodiscard]] bool Write(std::span<const std::uint8_t> bytes) noexcept;

  /// Closes the program's standard input.
  void EndInput() noexcept { input_.Close(); }

  /// Waits for the program's end. Many programs do not end before their input does: call EndInput
  /// first. Call this at most once.
  [[nodiscard]] ChildEnd Wait() noexcept;

  /// Waits at most that long; returns nothing if the program still runs.
  [[nodiscard]] std::optional<ChildEnd> Wait(std::chrono::milliseconds longest) noexcept;

  /// Ends the program if it still runs.
  void End() noexcept;

  /// Returns the text that the program has written to its standard error.
  [[nodiscard]] std::string Errors() const { return errors_.Content(); }

 private:
  MemoryFile errors_;
  Descriptor input_;  ///< the end that this process writes to
  pid_t child_ = -1;  ///< -1 after its end
};

}  // namespace girdle
