// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "child_programs/child_program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <utility>

#include "text/input_error.h"

namespace girdle {
namespace {

[[noreturn]] void FailStarting(const std::filesystem::path& program, int error) {
  throw InputError("cannot start " + program.filename().string() + ": " +
                   std::string(std::strerror(error)));
}

// Descriptors of this process that become the program's 0 to kExtraDescriptor. -1 means /dev/null;
// for the last one it means none.
using OwnFiles = std::array<int, kExtraDescriptor + 1>;

pid_t Spawn(const std::filesystem::path& program, std::vector<std::string> arguments,
            const OwnFiles& files) {
  // The copies have numbers above all targets, so that none is overwritten before it is in place.
  // They are closed when the program starts.
  std::array<Descriptor, std::tuple_size_v<OwnFiles>> sources;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (files[i] >= 0) {
      sources[i] = Descriptor(fcntl(files[i], F_DUPFD_CLOEXEC, kExtraDescriptor + 1));
      if (sources[i].get() < 0) {
        FailStarting(program, errno);
      }
    }
  }
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (int target = 0; target <= kExtraDescriptor; ++target) {
    const int source = sources[static_cast<std::size_t>(target)].get();
    if (source >= 0) {
      posix_spawn_file_actions_adddup2(&actions, source, target);
    } else if (target != kExtraDescriptor) {
      posix_spawn_file_actions_addopen(&actions, target, "/dev/null", O_RDWR, 0);
    }
  }
  arguments.insert(arguments.begin(), program.filename().string());
  std::vector<char*> words;
  words.reserve(arguments.size() + 1);
  for (std::string& argument : arguments) {
    words.push_back(argument.data());
  }
  words.push_back(nullptr);
  pid_t child = -1;
  const int error = posix_spawn(&child, program.c_str(), &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) {
    FailStarting(program, error);
  }
  return child;
}

}  // namespace

ChildProgram::ChildProgram(const std::filesystem::path& program, std::vector<std::string> arguments,
                           const ProgramFiles& files)
    : errors_("errors") {
  HearHowChildrenEnd();
  // A socket is used in place of a pipe, because a write to a socket without a reader can be made
  // not to raise SIGPIPE.
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    FailStarting(program, errno);
  }
  input_ = Descriptor(ends[0]);
  const Descriptor theirs(ends[1]);
  child_ = Spawn(program, std::move(arguments),
                 {theirs.get(), files.output, errors_.descriptor(), files.extra});
}

ChildProgram::~ChildProgram() { End(); }

bool ChildProgram::Write(std::span<const std::uint8_t> bytes) noexcept {
  while (!bytes.empty()) {
    const ssize_t sent = send(input_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno != EINTR) {
      return false;
    }
    bytes = bytes.subspan(sent < 0 ? 0 : static_cast<std::size_t>(sent));
  }
  return true;
}

ChildEnd ChildProgram::Wait() noexcept { return WaitForEnd(std::exchange(child_, -1)); }

std::optional<ChildEnd> ChildProgram::Wait(std::chrono::milliseconds longest) noexcept {
  const std::optional<ChildEnd> end = WaitForEnd(child_, longest);
  if (end) {
    child_ = -1;
  }
  return end;
}

void ChildProgram::End() noexcept {
  input_.Close();
  if (child_ >= 0) {
    kill(child_, SIGKILL);
    static_cast<void>(Wait());
  }
}

}  // namespace girdle
