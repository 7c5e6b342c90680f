// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "child_programs/child_end.h"

#include <sys/wait.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <thread>

namespace girdle {
namespace {

// Returns the end that a status of waitpid means.
ChildEnd EndOf(int status) noexcept {
  return WIFSIGNALED(status) ? ChildEnd{true, WTERMSIG(status)}
                             : ChildEnd{false, WEXITSTATUS(status)};
}

}  // namespace

std::string ChildEnd::text() const {
  if (by_signal) {
    return "was ended by a signal: " + std::string(strsignal(number));
  }
  return number == 0 ? "" : "ended with status " + std::to_string(number);
}

void HearHowChildrenEnd() noexcept {
  struct sigaction action {};
  if (sigaction(SIGCHLD, nullptr, &action) == 0 && action.sa_handler == SIG_IGN) {
    std::signal(SIGCHLD, SIG_DFL);
  }
}

ChildEnd WaitForEnd(pid_t child) noexcept {
  int status = 0;
  pid_t ended = -1;
  do {
    ended = waitpid(child, &status, 0);
  } while (ended < 0 && errno == EINTR);
  return ended == child ? EndOf(status) : ChildEnd{false, kCannotRun};
}

std::optional<ChildEnd> WaitForEnd(pid_t child, std::chrono::milliseconds longest) noexcept {
  constexpr std::chrono::milliseconds kStep(10);
  for (std::chrono::milliseconds waited(0);; waited += kStep) {
    int status = 0;
    const pid_t ended = waitpid(child, &status, WNOHANG);
    if (ended == child) {
      return EndOf(status);
    }
    if ((ended < 0 && errno != EINTR) || waited >= longest) {
      return std::nullopt;
    }
    std::this_thread::sleep_for(kStep);
  }
}

}  // namespace girdle
