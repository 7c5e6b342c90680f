// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "engines/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>

#include "tables/input_error.h"

namespace girdle {
namespace {

constexpr int kThrew = 3;

void WriteAll(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(file, text.data(), text.size());
    if (written < 0 && errno != EINTR) {
      return;
    }
    text.remove_prefix(written < 0 ? 0 : static_cast<std::size_t>(written));
  }
}

[[noreturn]] void BeChild(
    int out, const std::function<void(const std::function<void(std::string_view)>&)>& work) {
  setpgid(0, 0);  // so that what it starts ends with it
  const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC);
  dup2(nowhere, STDIN_FILENO);
  dup2(nowhere, STDERR_FILENO);
  dup2(out, STDOUT_FILENO);
  try {
    work([](std::string_view text) { WriteAll(STDOUT_FILENO, text); });
  } catch (...) {
    _exit(kThrew);
  }
  _exit(0);  // without what the parent left to do at its exit
}

std::string HowItEnded(int status) {
  if (WIFSIGNALED(status)) {
    return "crashed: " + std::string(strsignal(WTERMSIG(status)));
  }
  return WEXITSTATUS(status) == 0 ? "" : "ended with status " + std::to_string(WEXITSTATUS(status));
}

using Clock = std::chrono::steady_clock;

// Reads until the other end is closed; returns whether that happened before `end`.
bool ReadAll(int file, Clock::time_point end, std::string& text) {
  std::array<char, 4096> buffer{};
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now());
    pollfd waiting{file, POLLIN, 0};
    const int ready = poll(&waiting, 1, static_cast<int>(std::max<long>(left.count(), 0)));
    if (ready < 0 && errno == EINTR) {
      continue;
    }
    if (ready <= 0) {
      return false;
    }
    const ssize_t size = read(file, buffer.data(), buffer.size());
    if (size > 0) {
      text.append(buffer.data(), static_cast<std::size_t>(size));
    } else if (size == 0 || errno != EINTR) {
      return true;
    }
  }
}

}  // namespace

ChildResult RunInChild(
    const std::function<void(const std::function<void(std::string_view)>& write)>& work,
    int limit_s) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw InputError("cannot make a pipe: " + std::string(std::strerror(errno)));
  }
  const pid_t child = fork();
  if (child < 0) {
    const std::string reason = std::strerror(errno);
    close(ends[0]);
    close(ends[1]);
    throw InputError("cannot start a process: " + reason);
  }
  if (child == 0) {
    close(ends[0]);
    BeChild(ends[1], work);
  }
  close(ends[1]);
  ChildResult result;
  const bool in_time =
      ReadAll(ends[0], Clock::now() + std::chrono::seconds(limit_s), result.output);
  close(ends[0]);
  if (!in_time) {
    // The group may not be there yet.
    kill(-child, SIGKILL);
    kill(child, SIGKILL);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  result.failure = in_time ? HowItEnded(status) : "did not answer in time";
  return result;
}

}  // namespace girdle
