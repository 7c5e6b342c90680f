// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// One rhythm that many threads solve with, each with threads of its own. The thread sanitizer runs
/// this as well.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>
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

}  // namespace
}  // namespace girdle::solve_many_in_threads_test
