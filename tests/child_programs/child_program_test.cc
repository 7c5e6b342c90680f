// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "child_programs/child_program.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <string_view>

#include "child_programs/program_search.h"
#include "text/input_error.h"

namespace girdle::child_program_test {
namespace {

constexpr const char* kShell = "/bin/sh";
// More than a socket holds at once.
constexpr std::size_t kMany = 2'000'000;

std::span<const std::uint8_t> Bytes(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

// Whatever a test starts is gone at its end, also what has ended and nobody has waited for. Other
// tests of this process may have left children.
class ChildProgramTest : public testing::Test {
 protected:
  void TearDown() override { EXPECT_EQ(Children(), before_); }

 private:
  static std::set<pid_t> Children() {
    std::ifstream in("/proc/self/task/" + std::to_string(getpid()) + "/children");
    return {std::istream_iterator<pid_t>(in), {}};
  }

  std::set<pid_t> before_ = Children();
};

TEST_F(ChildProgramTest, GetsItsInputAndTheFilesThatItIsGiven) {
  const MemoryFile output("output");
  const MemoryFile extra("extra");
  const std::string text(kMany, 'x');
  ChildProgram program(kShell, {"-c", "cat; echo out; echo more >&3; echo err >&2"},
                       {output.descriptor(), extra.descriptor()});
  EXPECT_TRUE(program.Write(Bytes(text)));
  program.EndInput();
  EXPECT_TRUE(program.Wait().is_fine());
  EXPECT_EQ(output.Content(), text + "out\n");
  EXPECT_EQ(extra.Content(), "more\n");
  EXPECT_EQ(program.Errors(), "err\n");
}

TEST_F(ChildProgramTest, HasEachOfItsFilesOnce) {
  const MemoryFile output("output");
  ChildProgram program("/bin/ls", {"-l", "/proc/self/fd"}, {.output = output.descriptor()});
  EXPECT_TRUE(program.Wait().is_fine());
  const std::string files = output.Content();
  for (const std::string file : {"memfd:output", "memfd:errors", "socket:"}) {
    EXPECT_NE(files.find(file), std::string::npos) << file;
    EXPECT_EQ(files.find(file), files.rfind(file)) << file;
  }
}

TEST_F(ChildProgramTest, SaysHowItEnded) {
  ChildProgram failing(kShell, {"-c", "exit 7"});
  EXPECT_EQ(failing.Wait().text(), "ended with status 7");
  ChildProgram killed(kShell, {"-c", "kill -9 $$"});
  EXPECT_EQ(killed.Wait().text(), "was ended by a signal: Killed");
}

TEST_F(ChildProgramTest, SaysHowItEndedToAProcessThatIgnoresItsChildren) {
  const auto before = std::signal(SIGCHLD, SIG_IGN);
  ChildProgram program(kShell, {"-c", "exit 7"});
  const ChildEnd end = program.Wait();
  std::signal(SIGCHLD, before);
  EXPECT_EQ(end.text(), "ended with status 7");
}

// SIGPIPE would end this process.
TEST_F(ChildProgramTest, ThatReadsNoMoreTakesNoMore) {
  ChildProgram program(kShell, {"-c", "exec < /dev/null; sleep 0.1"});
  EXPECT_FALSE(program.Write(Bytes(std::string(kMany, 'x'))));
  EXPECT_TRUE(program.Wait(std::chrono::seconds(30)));
}

TEST_F(ChildProgramTest, IsWaitedForNoLongerThanAsked) {
  ChildProgram program(kShell, {"-c", "exec sleep 1000"});
  EXPECT_FALSE(program.Wait(std::chrono::milliseconds(20)));
  program.End();
}

TEST_F(ChildProgramTest, IsEndedWithItsObject) {
  const ChildProgram program(kShell, {"-c", "exec sleep 1000"});
}

TEST_F(ChildProgramTest, ThatIsNotThereIsRefusedByName) {
  try {
    const ChildProgram program("/nowhere/ffmpeg", {});
    FAIL() << "started";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "cannot start ffmpeg: No such file or directory");
  }
}

TEST(FindProgram, FindsWhatPathHasAndMayBeRun) {
  EXPECT_EQ(FindProgram("sh").filename(), "sh");
  EXPECT_EQ(FindProgram("no program of this name"), "");
  EXPECT_FALSE(IsProgram("/bin"));
  EXPECT_FALSE(IsProgram("/etc/passwd"));
}

TEST(FoldersOf, LeavesOutWhatDependsOnTheCurrentFolder) {
  constexpr const char* kVariable = "GIRDLE_TEST_FOLDERS";
  setenv(kVariable, "/a:relative::./b:/c/d", 1);
  EXPECT_EQ(FoldersOf(kVariable), (std::vector<std::filesystem::path>{"/a", "/c/d"}));
  unsetenv(kVariable);
  EXPECT_TRUE(FoldersOf(kVariable).empty());
}

}  // namespace
}  // namespace girdle::child_program_test
