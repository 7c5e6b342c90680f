// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "child_programs/child_process.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <new>
#include <string>
#include <thread>

#include "text/input_error.h"

namespace girdle::child_process_test {
namespace {

constexpr int kAmple_s = 30;

// Runs a script of the shell.
ChildResult RunShell(const std::string& script, int limit_s = kAmple_s) {
  return RunProgramInChild("/bin/sh", {"-c", script}, {.time_s = limit_s});
}

// A file that is not there, for children to write.
class RunInChildMarked : public testing::Test {
 protected:
  RunInChildMarked() { std::filesystem::remove(marker_); }
  ~RunInChildMarked() override { std::filesystem::remove(marker_); }

  // Whether the file comes to be within twice the time that scripts below wait before they write.
  [[nodiscard]] bool IsWritten() const {
    for (int i = 0; i < 20 && !std::filesystem::exists(marker_); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    return std::filesystem::exists(marker_);
  }

  const std::string marker_ =
      std::filesystem::temp_directory_path() / ("girdle_child_" + std::to_string(getpid()));
};

TEST(RunInChild, ReturnsWhatTheChildWrote) {
  // More than a pipe holds at once.
  const std::string text(300000, 'x');
  const ChildResult child =
      RunInChild([&](const auto& write) { write(text); }, {.time_s = kAmple_s});
  EXPECT_EQ(child.output, text);
  EXPECT_EQ(child.failure, "");
}

TEST(RunInChild, ReturnsWhatAProgramPrintsThatTheChildBecomes) {
  testing::internal::CaptureStderr();
  const ChildResult child = RunShell("echo out; echo err >&2");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(child.output, "out\n");
  EXPECT_EQ(child.failure, "");
}

TEST(RunProgramInChild, SaysThatAProgramCannotBeRun) {
  EXPECT_EQ(RunProgramInChild("/nowhere/program", {}, {.time_s = kAmple_s}).failure,
            "ended with status 127");
}

TEST(RunInChild, OutlivesAChildThatCrashesAndKeepsWhatItWrote) {
  const ChildResult child = RunInChild(
      [](const auto& write) {
        write("before");
        std::signal(SIGSEGV, SIG_DFL);
        std::raise(SIGSEGV);
      },
      {.time_s = kAmple_s});
  EXPECT_EQ(child.output, "before");
  EXPECT_EQ(child.failure, "was ended by a signal: Segmentation fault");
}

TEST(RunInChild, ReadsNothingOfTheStandardInput) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  ASSERT_EQ(write(ends[1], "typed", 5), 5);
  close(ends[1]);
  const int stdin_before = dup(STDIN_FILENO);
  dup2(ends[0], STDIN_FILENO);
  EXPECT_EQ(RunShell("cat").output, "");
  dup2(stdin_before, STDIN_FILENO);
  close(stdin_before);
  close(ends[0]);
}

TEST(RunInChild, SaysTheSignalThatThisProcessHasBlocked) {
  sigset_t blocked;
  sigset_t before;
  sigemptyset(&blocked);
  sigaddset(&blocked, SIGABRT);
  sigprocmask(SIG_BLOCK, &blocked, &before);
  const ChildResult child = RunInChild([](const auto&) { std::abort(); }, {.time_s = kAmple_s});
  sigprocmask(SIG_SETMASK, &before, nullptr);
  EXPECT_EQ(child.failure, "was ended by a signal: Aborted");
}

TEST(RunInChild, SaysThatThereIsNoRoomForTheChild) {
  constexpr int kNoLimits = 77;
  const pid_t caller = fork();
  if (caller == 0) {
    if (getuid() == 0 && setuid(54321) != 0) {
      _exit(kNoLimits);  // they do not bind the superuser
    }
    rlimit processes{};
    getrlimit(RLIMIT_NPROC, &processes);
    // The child's parent finds room from some limit on, and the child from the next one on. Where
    // both find it, another process of this user has ended meanwhile.
    constexpr int kMostTries = 50;
    processes.rlim_cur = 1;
    for (int tries = 0; tries < kMostTries;) {
      setrlimit(RLIMIT_NPROC, &processes);
      try {
        static_cast<void>(RunInChild([](const auto&) {}, {.time_s = kAmple_s}));
        processes.rlim_cur = 1;
        ++tries;
      } catch (const InputError& error) {
        if (std::string(error.what()).find("no room for another one") != std::string::npos) {
          _exit(0);
        }
        ++processes.rlim_cur;
      }
    }
    _exit(1);
  }
  int status = -1;
  EXPECT_EQ(waitpid(caller, &status, 0), caller);
  if (WEXITSTATUS(status) == kNoLimits) {
    GTEST_SKIP() << "this superuser cannot become another user";
  }
  EXPECT_EQ(status, 0);
}

TEST(RunInChild, SaysTheStatusOfAChildThatFails) {
  const ChildResult child = RunInChild([](const auto&) { _exit(7); }, {.time_s = kAmple_s});
  EXPECT_EQ(child.failure, "ended with status 7");
  EXPECT_FALSE(child.is_late);
}

TEST(RunInChild, SaysTheStatusWhereThisProcessIgnoresItsChildren) {
  std::signal(SIGCHLD, SIG_IGN);
  const ChildResult child = RunInChild([](const auto&) { _exit(7); }, {.time_s = kAmple_s});
  EXPECT_EQ(child.failure, "ended with status 7");
}

TEST(RunInChild, NoExceptionOfTheChildLeavesIt) {
  const ChildResult child = RunInChild([](const auto&) { throw 1; }, {.time_s = kAmple_s});
  EXPECT_NE(child.failure, "");
}

TEST(RunInChild, RunsNothingInTheCurrentFolder) { EXPECT_EQ(RunShell("pwd").output, "/\n"); }

TEST(RunInChild, EndsAChildThatHangs) {
  const ChildResult child = RunShell("echo waiting; sleep 600; true", 1);
  EXPECT_EQ(child.output, "waiting\n");
  EXPECT_EQ(child.failure, "did not end within 1 s");
  EXPECT_TRUE(child.is_late);
}

TEST(RunInChild, EndsAChildThatClosesItsOutputAndGoesOn) {
  const ChildResult child = RunShell("exec >&-; sleep 600", 1);
  EXPECT_EQ(child.failure, "did not end within 1 s");
}

TEST(RunInChild, EndsAChildThatWritesWithoutEnd) {
  const ChildResult child = RunShell("exec yes");
  EXPECT_EQ(child.failure, "wrote more than 1 MB");
  EXPECT_LT(child.output.size(), 2'000'000U);
}

TEST(RunInChild, ReturnsMoreThanAMegabyteWhereItIsAskedTo) {
  const std::string text(3'000'000, 'x');
  const ChildResult child = RunInChild([&](const auto& write) { write(text); },
                                       {.time_s = kAmple_s, .output_bytes = text.size()});
  EXPECT_EQ(child.failure, "");
  EXPECT_TRUE(child.output == text);
}

// AddressSanitizer leaves no memory to limit.
#ifndef __SANITIZE_ADDRESS__
TEST(RunInChild, GivesTheChildNoMoreMemoryThanItMayHave) {
  constexpr std::size_t kMost = 200'000'000;
  const ChildResult child = RunInChild(
      [](const auto& write) {
        try {
          const std::string text(2 * kMost, 'x');
          write(text.substr(0, 1));
        } catch (const std::bad_alloc&) {
          write("none");
        }
      },
      {.time_s = kAmple_s, .memory_bytes = kMost});
  EXPECT_EQ(child.failure, "");
  EXPECT_EQ(child.output, "none");
}
#endif

TEST(RunInChild, WaitsForNoneThatTheChildLeavesBehind) {
  const ChildResult child = RunShell("sleep 600 & echo done");
  EXPECT_EQ(child.output, "done\n");
  EXPECT_EQ(child.failure, "");
}

TEST(RunInChild, OutlivesAChildThatKillsItsParent) {
  const ChildResult child = RunShell("kill -9 $PPID; sleep 600");
  EXPECT_EQ(child.failure, "was ended by a signal: Killed");
}

TEST(RunInChild, OutlivesAChildThatKillsEveryParentThatItComesToHave) {
  const ChildResult child = RunShell(
      "while read -r pid name state parent rest < /proc/$$/stat; do kill -9 $parent; done");
  EXPECT_EQ(child.failure, "was ended by a signal: Killed");
}

TEST(RunInChild, OutlivesAChildThatKillsItsGroup) {
  const ChildResult child = RunShell("kill -9 0; sleep 600");
  EXPECT_EQ(child.failure, "was ended by a signal: Killed");
}

TEST(RunInChild, OutlivesAChildThatStopsItsParent) {
  const ChildResult child = RunShell("kill -STOP $PPID; sleep 600", 1);
  EXPECT_EQ(child.failure, "did not end within 1 s");
}

TEST(RunInChild, NothingThatTheChildDoesIsDoneHere) {
  int value = 1;
  const ChildResult child = RunInChild([&](const auto&) { value = 2; }, {.time_s = kAmple_s});
  EXPECT_EQ(child.failure, "");
  EXPECT_EQ(value, 1);
}

TEST(RunInChild, LeavesOtherChildrenOfThisProcessAlone) {
  const pid_t other = fork();
  if (other == 0) {
    pause();
    _exit(0);
  }
  EXPECT_EQ(RunShell("true").failure, "");
  EXPECT_EQ(waitpid(other, nullptr, WNOHANG), 0) << "it ended";
  kill(other, SIGKILL);
  EXPECT_EQ(waitpid(other, nullptr, 0), other);
}

TEST_F(RunInChildMarked, LeavesAloneWhatAnotherChildStartsAndLeavesBehind) {
  const pid_t other = fork();
  if (other == 0) {
    const std::string script = "sleep 0.3; (sleep 1; touch " + marker_ + ") &";
    execl("/bin/sh", "sh", "-c", script.c_str(), static_cast<char*>(nullptr));
    _exit(1);
  }
  EXPECT_EQ(RunShell("sleep 0.8").failure, "");
  EXPECT_EQ(waitpid(other, nullptr, 0), other);
  EXPECT_TRUE(IsWritten());
}

TEST_F(RunInChildMarked, EndsWhatTheChildStarted) {
  EXPECT_EQ(RunShell("(sleep 1; touch " + marker_ + ") & exit 0").failure, "");
  EXPECT_FALSE(IsWritten());
}

TEST_F(RunInChildMarked, EndsWhatTheChildStartedInASessionOfItsOwn) {
  // The shell in between ends first: what goes on is an orphan.
  const std::string script = "(setsid sh -c 'sleep 1; touch " + marker_ + "' &) ; sleep 0.3";
  EXPECT_EQ(RunShell(script).failure, "");
  EXPECT_FALSE(IsWritten());
}

TEST_F(RunInChildMarked, EndsWhatTheChildStartedThoughItKilledItsParent) {
  const std::string script =
      "setsid sh -c 'sleep 1; touch " + marker_ + "' & sleep 0.3; kill -9 $PPID; sleep 600";
  EXPECT_EQ(RunShell(script).failure, "was ended by a signal: Killed");
  EXPECT_FALSE(IsWritten());
}

TEST_F(RunInChildMarked, EndsTheChildWithThisProcess) {
  const pid_t caller = fork();
  if (caller == 0) {
    static_cast<void>(RunShell("sleep 1; touch " + marker_));
    _exit(0);
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  kill(caller, SIGKILL);
  EXPECT_EQ(waitpid(caller, nullptr, 0), caller);
  EXPECT_FALSE(IsWritten());
}

TEST_F(RunInChildMarked, EndsWhatForksOnAndOn) {
  // Each process starts the next one in a session of its own and ends; the last one writes.
  std::ofstream(marker_ + ".sh") << "[ $1 = 0 ] && exec touch " << marker_
                                 << "\nsetsid sh $0 $(($1 - 1)) &\n";
  EXPECT_EQ(RunShell("sh " + marker_ + ".sh 300; sleep 0.1").failure, "");
  EXPECT_FALSE(IsWritten());
  std::filesystem::remove(marker_ + ".sh");
}

}  // namespace
}  // namespace girdle::child_process_test
