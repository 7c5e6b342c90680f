// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "engines/child_process.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <string>

namespace girdle::child_process_test {
namespace {

constexpr int kAmple_s = 30;

TEST(RunInChild, ReturnsWhatTheChildWrote) {
  // More than a pipe holds at once.
  const std::string text(300000, 'x');
  const ChildResult child = RunInChild([&](const auto& write) { write(text); }, kAmple_s);
  EXPECT_EQ(child.output, text);
  EXPECT_EQ(child.failure, "");
}

TEST(RunInChild, ReturnsWhatAProgramPrintsThatTheChildBecomes) {
  const ChildResult child = RunInChild(
      [](const auto&) {
        execl("/bin/sh", "sh", "-c", "echo out; echo err >&2", static_cast<char*>(nullptr));
      },
      kAmple_s);
  EXPECT_EQ(child.output, "out\n");
  EXPECT_EQ(child.failure, "");
}

TEST(RunInChild, OutlivesAChildThatCrashesAndKeepsWhatItWrote) {
  const ChildResult child = RunInChild(
      [](const auto& write) {
        write("before");
        std::signal(SIGSEGV, SIG_DFL);
        std::raise(SIGSEGV);
      },
      kAmple_s);
  EXPECT_EQ(child.output, "before");
  EXPECT_NE(child.failure.find("crashed"), std::string::npos) << child.failure;
}

TEST(RunInChild, SaysTheStatusOfAChildThatFails) {
  const ChildResult child = RunInChild([](const auto&) { _exit(7); }, kAmple_s);
  EXPECT_EQ(child.failure, "ended with status 7");
}

TEST(RunInChild, NoExceptionOfTheChildLeavesIt) {
  const ChildResult child = RunInChild([](const auto&) { throw 1; }, kAmple_s);
  EXPECT_NE(child.failure, "");
}

TEST(RunInChild, EndsAChildThatHangsWithAllThatItStarted) {
  const ChildResult child = RunInChild(
      [](const auto& write) {
        write("waiting");
        // The shell waits for a process of its own, which keeps the output open.
        execl("/bin/sh", "sh", "-c", "sleep 600; true", static_cast<char*>(nullptr));
      },
      1);
  EXPECT_EQ(child.output, "waiting");
  EXPECT_EQ(child.failure, "did not answer in time");
}

TEST(RunInChild, NothingThatTheChildDoesIsDoneHere) {
  int value = 1;
  const ChildResult child = RunInChild([&](const auto&) { value = 2; }, kAmple_s);
  EXPECT_EQ(child.failure, "");
  EXPECT_EQ(value, 1);
}

}  // namespace
}  // namespace girdle::child_process_test
