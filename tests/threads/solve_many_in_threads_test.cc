// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// One rhythm that many threads solve with, each with threads of its own. The thread sanitizer runs
/// this as well.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <latch>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "kinematics/solve_many.h"
#include "rhythm_tables/built_in_tables.h"

namespace girdle::solve_many_in_threads_test {
namespace {

// More than one block for each thread.
constexpr std::size_t kCommands = 3000;
constexpr std::size_t kCallers = 3;
constexpr std::size_t kThreads = 4;

// All over the range and beyond it, some with offsets and an axial turn.
std::vector<ArmCommand> Commands() {
  std::vector<ArmCommand> commands;
  for (std::size_t i = 0; i < kCommands; ++i) {
    const auto step = static_cast<double>(i);
    commands.push_back({RadiansFromDegrees(0.063 * step), RadiansFromDegrees(140 - 0.07 * step),
                        i % 5 == 0 ? 0.2 : 0, i % 7 == 0 ? 0.1 : 0, i % 9 == 0 ? -0.1 : 0});
  }
  return commands;
}

struct Answers {
  std::vector<ShoulderPose> poses = std::vector<ShoulderPose>(kCommands);
  std::vector<JointAngles> angles_rad = std::vector<JointAngles>(kCommands);
  std::vector<ArmCommand> used = std::vector<ArmCommand>(kCommands);
  std::vector<Origin> origins = std::vector<Origin>(kCommands);
  std::vector<double> distances_rad = std::vector<double>(kCommands);

  [[nodiscard]] ManySolutions All() { return {poses, angles_rad, used, origins, distances_rad}; }
};

template <typename T>
bool SameBytes(const std::vector<T>& a, const std::vector<T>& b) {
  // The bytes are meant: NaNs, signs of zero and all.
  return std::memcmp(static_cast<const void*>(a.data()), static_cast<const void*>(b.data()),
                     kCommands * sizeof(T)) == 0;
}

TEST(SolveManyInThreads, ThreeCallersAtOnceEachGetTheBytesOfOneThread) {
  const ShoulderRhythm rhythm = BuiltInRhythm();
  const std::vector<ArmCommand> commands = Commands();
  Answers expected;
  SolveMany(rhythm, commands, expected.All());
  std::vector<Answers> answers(kCallers);
  {
    std::vector<std::jthread> callers;
    callers.reserve(kCallers);
    for (Answers& of_caller : answers) {
      callers.emplace_back([&rhythm, &commands, &of_caller] {
        SolveMany(rhythm, commands, of_caller.All(), {.threads = kThreads});
      });
    }
  }
  for (const Answers& of_caller : answers) {
    EXPECT_TRUE(SameBytes(of_caller.poses, expected.poses));
    EXPECT_TRUE(SameBytes(of_caller.angles_rad, expected.angles_rad));
    EXPECT_TRUE(SameBytes(of_caller.used, expected.used));
    EXPECT_TRUE(SameBytes(of_caller.origins, expected.origins));
    EXPECT_TRUE(SameBytes(of_caller.distances_rad, expected.distances_rad));
  }
}

// The system's numbers of all threads of this process.
std::set<std::string> ThreadNumbers() {
  std::set<std::string> numbers;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task")) {
    numbers.insert(entry.path().filename());
  }
  return numbers;
}

// How many threads there are during `call` that were not there before it.
template <typename Call>
std::size_t StartedBy(const Call& call) {
  std::set<std::string> before;
  std::set<std::string> seen;
  std::atomic<bool> is_over = false;
  {
    std::latch watches(1);
    const std::jthread watcher([&] {
      // Here, so that the watcher itself is among them.
      before = ThreadNumbers();
      watches.count_down();
      while (!is_over) {
        seen.merge(ThreadNumbers());
      }
    });
    watches.wait();
    call();
    is_over = true;
  }
  return static_cast<std::size_t>(std::ranges::count_if(
      seen, [&before](const std::string& number) { return !before.contains(number); }));
}

TEST(SolveManyInThreads, AsManyAreStartedAsAreAskedForBesideTheCaller) {
  // Tens of milliseconds: as a rule the watcher looks at them meanwhile.
  constexpr std::size_t kLongCommands = 100 * kCommands;
  constexpr int kAttempts = 20;
  const ShoulderRhythm rhythm = BuiltInRhythm();
  const std::vector<ArmCommand> commands(kLongCommands);
  std::vector<ShoulderPose> poses(kLongCommands);
  const auto started = [&](std::size_t threads) {
    return StartedBy([&] {
      SolveMany(rhythm, commands, {.poses = poses},
                {.threads = threads, .instructions = Instructions::kPortable});
    });
  };
  EXPECT_EQ(started(1), 0);
  std::size_t most = 0;
  for (int attempt = 0; attempt < kAttempts && most < kThreads - 1; ++attempt) {
    most = std::max(most, started(kThreads));
  }
  EXPECT_EQ(most, kThreads - 1);
}

}  // namespace
}  // namespace girdle::solve_many_in_threads_test
