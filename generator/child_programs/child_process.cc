// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "child_programs/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "child_programs/child_end.h"
#include "child_programs/descriptor.h"
#include "text/input_error.h"
#include "text/number_text.h"

namespace girdle {
namespace {

constexpr int kThrew = 3;
// Shells report a signal as this number plus the signal's.
constexpr int kSignalled = 128;
// Pause between two checks of a child that writes nothing.
constexpr int kPause_ms = 5;
// Killed processes are gone in milliseconds, unless the kernel waits for a device.
constexpr std::chrono::seconds kLongestEnd(2);

using Clock = std::chrono::steady_clock;
using Work = std::function<void(const std::function<void(std::string_view)>&)>;

void WriteAll(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(file, text.data(), text.size());
    if (written < 0 && errno != EINTR) {
      return;
    }
    text.remove_prefix(written < 0 ? 0 : static_cast<std::size_t>(written));
  }
}

void LimitMemory([[maybe_unused]] std::size_t bytes) {
#ifndef __SANITIZE_ADDRESS__
  // RLIMIT_AS would count room that threads and libraries reserve and never use.
  const rlimit most{bytes, bytes};
  setrlimit(RLIMIT_DATA, &most);
#endif
}

[[noreturn]] void BeChild(int out, const Work& work, const ChildLimits& limits) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (limits.memory_bytes != 0) {
    LimitMemory(limits.memory_bytes);
  }
  const int nowhere = open("/dev/null", O_RDWR | O_CLOEXEC);
  if (nowhere >= 0) {  // a root without /dev has no such file
    dup2(nowhere, STDIN_FILENO);
    dup2(nowhere, STDERR_FILENO);
  }
  dup2(out, STDOUT_FILENO);
  if (chdir("/") != 0) {
    _exit(kThrew);
  }
  try {
    work([](std::string_view text) { WriteAll(STDOUT_FILENO, text); });
  } catch (...) {
    _exit(kThrew);
  }
  _exit(0);  // the parent's exit handlers must not run here
}

// Ends this process by the signal, even if the signal was blocked or ignored when it started.
[[noreturn]] void EndBy(int signal) {
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
  _exit(kSignalled + signal);
}

// Starts the child and ends in the way that the child ends. If the child cannot be started, ends by
// SIGRTMAX, which nothing else sends.
[[noreturn]] void BeParent(int out, const Work& work, const ChildLimits& limits) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  setsid();  // a group to kill at once, without a terminal
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  const pid_t child = fork();
  if (child == 0) {
    BeChild(out, work, limits);
  }
  if (child < 0) {
    EndBy(SIGRTMAX);
  }
  const ChildEnd end = WaitForEnd(child);
  if (end.by_signal) {
    EndBy(end.number);
  }
  _exit(end.number);
}

// Returns the children of this process, which has one thread, with the number of the process.
std::set<pid_t> ChildrenOfThisProcess() {
  std::ifstream in("/proc/self/task/" + std::to_string(getpid()) + "/children");
  return {std::istream_iterator<pid_t>(in), {}};
}

// Returns the sessions of all processes. A process can leave its session only for a new one.
std::set<pid_t> Sessions() {
  std::set<pid_t> sessions;
  std::error_code error;
  for (std::filesystem::directory_iterator entry("/proc", error), end; !error && entry != end;
       entry.increment(error)) {
    if (const int process = std::atoi(entry->path().filename().c_str()); process > 0) {
      sessions.insert(getsid(process));
    }
  }
  return sessions;
}

// Kills the group, and all children except those in a session of `earlier`. Children of a killed
// process become children of this one.
void KillAll(pid_t group, const std::set<pid_t>& earlier) {
  kill(-group, SIGKILL);
  const Clock::time_point end = Clock::now() + kLongestEnd;
  bool is_left = true;
  while (is_left && Clock::now() < end) {
    is_left = false;
    for (const pid_t child : ChildrenOfThisProcess()) {
      if (child == group || !earlier.contains(getsid(child))) {
        is_left = true;
        kill(child, SIGKILL);
        waitpid(child, nullptr, WNOHANG);
      }
    }
  }
}

// Appends the bytes that can be read without waiting, up to a little more than `most`.
void ReadReady(int file, std::size_t most, std::string& text) {
  std::array<char, 4096> buffer{};
  while (text.size() <= most) {
    const ssize_t size = read(file, buffer.data(), buffer.size());
    if (size == 0 || (size < 0 && errno != EINTR)) {
      return;
    }
    text.append(buffer.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
  }
}

std::string MegabytesText(std::size_t bytes) {
  constexpr double kBytesPerMegabyte = 1e6;
  constexpr int kDigits = 3;
  return SignificantText(static_cast<double>(bytes) / kBytesPerMegabyte, kDigits) + " MB";
}

}  // namespace

ChildResult RunInChild(const Work& work, const ChildLimits& limits) {
  HearHowChildrenEnd();
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  const std::set<pid_t> earlier = Sessions();
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw InputError("cannot make a pipe: " + std::string(std::strerror(errno)));
  }
  Descriptor ours(ends[0]);
  Descriptor theirs(ends[1]);
  const pid_t parent = fork();
  if (parent < 0) {
    throw InputError("cannot start a process: " + std::string(std::strerror(errno)));
  }
  if (parent == 0) {
    ours.Close();
    BeParent(theirs.get(), work, limits);
  }
  theirs.Close();
  fcntl(ours.get(), F_SETFL, O_NONBLOCK);
  ChildResult result;
  bool is_started = true;
  const Clock::time_point end = Clock::now() + std::chrono::seconds(limits.time_s);
  for (;;) {
    pollfd waiting{ours.get(), POLLIN, 0};
    poll(&waiting, 1, kPause_ms);
    siginfo_t ended{};
    // The process stays a zombie, so that its number still means its group until the group is
    // killed.
    waitid(P_PID, static_cast<id_t>(parent), &ended, WEXITED | WNOHANG | WNOWAIT);
    ReadReady(ours.get(), limits.output_bytes, result.output);
    if (ended.si_pid != 0) {
      const ChildEnd how{ended.si_code != CLD_EXITED, ended.si_status};
      is_started = !how.by_signal || how.number != SIGRTMAX;
      result.failure = how.text();
      break;
    }
    if (result.output.size() > limits.output_bytes) {
      result.failure = "wrote more than " + MegabytesText(limits.output_bytes);
      break;
    }
    if (Clock::now() > end) {
      result.is_late = true;
      result.failure = "did not end within " + std::to_string(limits.time_s) + " s";
      break;
    }
  }
  ours.Close();
  KillAll(parent, earlier);
  if (!is_started) {
    throw InputError("cannot start a process: the system has no room for another one");
  }
  return result;
}

ChildResult RunProgramInChild(const std::filesystem::path& program,
                              std::vector<std::string> arguments, const ChildLimits& limits) {
  std::string name = program.string();
  std::vector<char*> words = {name.data()};
  for (std::string& argument : arguments) {
    words.push_back(argument.data());
  }
  words.push_back(nullptr);
  return RunInChild(
      [&](const auto&) {
        execv(program.c_str(), words.data());
        _exit(kCannotRun);
      },
      limits);
}

}  // namespace girdle
