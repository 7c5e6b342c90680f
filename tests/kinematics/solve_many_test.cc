// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/solve_many.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "kinematics/arm_commands.h"
#include "kinematics/assembled_rhythm.h"
#include "kinematics/shipped_data.h"

namespace girdle::solve_many_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr std::array kAllInstructions = {Instructions::kQuickest, Instructions::kPortable,
                                         Instructions::kAvx2};

const RhythmTable& Table() {
  static const RhythmTable kTable = TableOf(MeasuredRows());
  return kTable;
}

// Those that the joints' ranges bound as well.
const std::vector<ShoulderRhythm>& Rhythms() {
  static const std::vector<ShoulderRhythm> kRhythms = [] {
    std::vector<ShoulderRhythm> rhythms;
    for (const auto interpolation :
         {Interpolation::kSmooth, Interpolation::kSquad, Interpolation::kSlerp}) {
      for (const auto closure : {Closure::kExact, Closure::kTable}) {
        rhythms.emplace_back(Table(), RhythmOptions{interpolation, closure, {}},
                             ShippedJointRanges());
      }
    }
    rhythms.emplace_back(Table(),
                         RhythmOptions{Interpolation::kSmooth, Closure::kExact, Range::kClamp});
    return rhythms;
  }();
  return kRhythms;
}
const ShoulderRhythm& Default() { return Rhythms().front(); }

// One table with four planes: its patches are cubic in both directions.
ShoulderRhythm WithFourPlanes() {
  std::vector<double> planes_rad;
  std::vector<RhythmPosition> positions;
  const std::vector<double>& elevations_rad = Table().elevations_rad();
  for (std::size_t plane = 0; plane < Table().planes_rad().size(); ++plane) {
    planes_rad.push_back(Table().planes_rad()[plane]);
    for (std::size_t i = 0; i < elevations_rad.size(); ++i) {
      positions.push_back(Table().position(plane, i));
    }
  }
  planes_rad.push_back(RadiansFromDegrees(120));
  for (std::size_t i = 0; i < elevations_rad.size(); ++i) {
    RhythmPosition position = Table().position(planes_rad.size() - 2, i);
    position.angles_rad[0] += 0.1;
    position.angles_rad[4] -= 0.05 + 0.001 * static_cast<double>(i);
    positions.push_back(position);
  }
  return ShoulderRhythm(RhythmTable(planes_rad, elevations_rad, positions));
}

// Everything that is asked of a rhythm, and some things that nobody means.
rc::Gen<ArmCommand> AnyCommand() {
  const auto somewhere =
      rc::gen::exec([] { return Command_deg(*NumberWithin(-20, 200), *NumberWithin(-400, 400)); });
  const auto at_an_edge = rc::gen::exec([] {
    return Command_deg(*rc::gen::element(0., 15., 55., 90., 115., 120., 135., 150., 180.),
                       *rc::gen::element(-160., -95., -30., 0., 40., 90., 135., 200., 350.));
  });
  const auto added_to = rc::gen::exec([] {
    ArmCommand command =
        Command_deg(*NumberWithin(-20, 200), *NumberWithin(-400, 400), *NumberWithin(-90, 90),
                    *NumberWithin(-40, 40), *NumberWithin(-40, 40));
    command.axial_from = *AnyAxialFrom();
    return command;
  });
  const auto not_finite = rc::gen::exec([] {
    ArmCommand command = Command_deg(*NumberWithin(0, 180), *NumberWithin(-95, 135));
    const auto member = *rc::gen::element(&ArmCommand::elevation_rad, &ArmCommand::plane_rad,
                                          &ArmCommand::axial_rad, &ArmCommand::shrug_rad,
                                          &ArmCommand::protraction_rad);
    command.*member = *rc::gen::element(kNan, kInfinity, -kInfinity);
    command.axial_from = *AnyAxialFrom();
    return command;
  });
  return rc::gen::weightedOneOf<ArmCommand>(
      {{4, InnerCommand()}, {8, somewhere}, {2, at_an_edge}, {2, added_to}, {1, not_finite}});
}

std::vector<ArmCommand> AnyCommands(std::size_t count) {
  return *rc::gen::container<std::vector<ArmCommand>>(count, AnyCommand());
}

struct Answers {
  explicit Answers(std::size_t count)
      : poses(count), angles_rad(count), used(count), origins(count), distances_rad(count) {}

  [[nodiscard]] ManySolutions All() { return {poses, angles_rad, used, origins, distances_rad}; }

  std::vector<ShoulderPose> poses;
  std::vector<JointAngles> angles_rad;
  std::vector<ArmCommand> used;
  std::vector<Origin> origins;
  std::vector<double> distances_rad;
};

Answers OneByOne(const ShoulderRhythm& rhythm, const std::vector<ArmCommand>& commands) {
  Answers answers(commands.size());
  for (std::size_t i = 0; i < commands.size(); ++i) {
    const ShoulderSolution solution = rhythm.Solve(commands[i]);
    answers.poses[i] = solution.pose;
    answers.angles_rad[i] = AnglesFromPose(solution.pose);
    answers.used[i] = solution.used;
    answers.origins[i] = solution.origin;
    answers.distances_rad[i] = solution.distance_rad;
  }
  return answers;
}

Answers OneByOne(const AssembledRhythm& rhythm, const std::vector<ArmCommand>& commands) {
  Answers answers = OneByOne(rhythm.rhythm(), commands);
  for (std::size_t i = 0; i < commands.size(); ++i) {
    answers.poses[i] = rhythm.SolvePose(commands[i], &answers.used[i]);
    answers.angles_rad[i] = rhythm.SolveAngles(commands[i]);
  }
  return answers;
}

// As memory: a zero's sign counts too.
template <typename T>
bool SameBytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(static_cast<const void*>(a.data()),
                                   static_cast<const void*>(b.data()), a.size() * sizeof(T)) == 0);
}

// Of commands by their members: there is padding behind the last one.
bool SameBytes(const std::vector<ArmCommand>& a, const std::vector<ArmCommand>& b) {
  const auto bytes_of = [](const ArmCommand& command) {
    return std::bit_cast<std::array<std::byte, 5 * sizeof(double)>>(
        std::array{command.elevation_rad, command.plane_rad, command.axial_rad, command.shrug_rad,
                   command.protraction_rad});
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](const ArmCommand& one, const ArmCommand& other) {
                      return bytes_of(one) == bytes_of(other) && one.axial_from == other.axial_from;
                    });
}

void ExpectSame(const Answers& answers, const Answers& expected,
                const std::vector<ArmCommand>& commands) {
  for (std::size_t i = 0; i < commands.size(); ++i) {
    if (!SameBits(answers.poses[i], expected.poses[i])) {
      RC_LOG() << i << ": " << commands[i] << '\n';
    }
  }
  RC_ASSERT(SameBytes(answers.poses, expected.poses));
  RC_ASSERT(SameBytes(answers.angles_rad, expected.angles_rad));
  RC_ASSERT(SameBytes(answers.used, expected.used));
  RC_ASSERT(SameBytes(answers.origins, expected.origins));
  RC_ASSERT(SameBytes(answers.distances_rad, expected.distances_rad));
}

template <typename Rhythm>
void ExpectTheBitsOfOneByOne(const Rhythm& rhythm, const std::vector<ArmCommand>& commands,
                             const SolveManyOptions& options) {
  if (!HasInstructions(options.instructions)) return;
  Answers answers(commands.size());
  SolveMany(rhythm, commands, answers.All(), options);
  ExpectSame(answers, OneByOne(rhythm, commands), commands);
}

RC_GTEST_PROP(SolveMany, GivesTheBitsOfOneByOneWithEveryRhythmAndInstructions, ()) {
  const std::vector<ArmCommand> commands =
      AnyCommands(*rc::gen::element<std::size_t>(0, 1, 2, 3, 4, 5, 8, 60));
  for (const ShoulderRhythm& rhythm : Rhythms()) {
    for (const Instructions instructions : kAllInstructions) {
      ExpectTheBitsOfOneByOne(rhythm, commands, {.instructions = instructions});
    }
  }
}

RC_GTEST_PROP(SolveMany, GivesTheBitsOfOneByOneWithATableOfFourPlanes, ()) {
  static const ShoulderRhythm kRhythm = WithFourPlanes();
  const std::vector<ArmCommand> commands = AnyCommands(50);
  ExpectTheBitsOfOneByOne(kRhythm, commands, {});
}

// All that each region of the rule holds, so that no region is left to chance.
TEST(SolveMany, GivesTheBitsOfOneByOneAllOverTheRange) {
  std::vector<ArmCommand> commands;
  for (const double plane_deg : Steps(-195, 235, 86)) {
    for (const double elevation_deg : Steps(-5, 185, 95)) {
      commands.push_back(Command_deg(elevation_deg, plane_deg));
    }
  }
  const Answers expected = OneByOne(Default(), commands);
  for (const Instructions instructions : kAllInstructions) {
    if (!HasInstructions(instructions)) continue;
    Answers answers(commands.size());
    SolveMany(Default(), commands, answers.All(), {.instructions = instructions});
    EXPECT_TRUE(SameBytes(answers.poses, expected.poses));
    EXPECT_TRUE(SameBytes(answers.angles_rad, expected.angles_rad));
    EXPECT_TRUE(SameBytes(answers.distances_rad, expected.distances_rad));
  }
}

TEST(SolveMany, GivesTheSameBytesWithAnyNumberOfThreads) {
  for (const std::size_t size : {0, 1, 3, 4, 5, 1000}) {
    std::vector<ArmCommand> commands;
    for (std::size_t i = 0; i < size; ++i) {
      const auto step = static_cast<double>(i);
      commands.push_back(Command_deg(0.19 * step, 140 - 0.21 * step, i % 7 == 0 ? 10 : 0,
                                     i % 11 == 0 ? 5 : 0, i % 13 == 0 ? -5 : 0));
    }
    const Answers expected = OneByOne(Default(), commands);
    for (const std::size_t threads : {1, 2, 3, 8}) {
      for (const Instructions instructions : kAllInstructions) {
        if (!HasInstructions(instructions)) continue;
        Answers answers(size);
        SolveMany(Default(), commands, answers.All(), {threads, instructions});
        EXPECT_TRUE(SameBytes(answers.poses, expected.poses)) << size << ", " << threads;
        EXPECT_TRUE(SameBytes(answers.angles_rad, expected.angles_rad)) << size << ", " << threads;
        EXPECT_TRUE(SameBytes(answers.used, expected.used)) << size << ", " << threads;
        EXPECT_TRUE(SameBytes(answers.origins, expected.origins)) << size << ", " << threads;
        EXPECT_TRUE(SameBytes(answers.distances_rad, expected.distances_rad))
            << size << ", " << threads;
      }
    }
  }
}

RC_GTEST_PROP(SolveMany, GivesEachAnswerAloneAsItDoesWithTheOthers, ()) {
  const std::vector<ArmCommand> commands = AnyCommands(20);
  Answers all(commands.size());
  SolveMany(Default(), commands, all.All());
  Answers alone(commands.size());
  SolveMany(Default(), commands, {.poses = alone.poses});
  SolveMany(Default(), commands, {.angles_rad = alone.angles_rad});
  SolveMany(Default(), commands, {.used = alone.used});
  SolveMany(Default(), commands, {.origins = alone.origins});
  SolveMany(Default(), commands, {.distances_rad = alone.distances_rad});
  ExpectSame(alone, all, commands);
}

RC_GTEST_PROP(SolveMany, GivesTheBitsOfAnAssembledRhythm, ()) {
  const std::vector<ArmCommand> commands = AnyCommands(30);
  for (const Assembly assembly : {Assembly::kTree, Assembly::kLoop}) {
    const AssembledRhythm rhythm(Default(), assembly);
    ExpectTheBitsOfOneByOne(rhythm, commands, {.threads = 2});
  }
}

// Each changes one thing of a call that is right.
struct Refusal {
  const char* name;
  std::function<void(ManySolutions&, SolveManyOptions&)> spoil;
  std::string message;
};
void PrintTo(const Refusal& refusal, std::ostream* out) { *out << refusal.name; }

class SolveManyRefuses : public testing::TestWithParam<Refusal> {};

TEST_P(SolveManyRefuses, AndWritesNothing) {
  const std::vector<ArmCommand> commands(5, Command_deg(60, 30, 5));
  const AssembledRhythm assembled(Default(), Assembly::kLoop);
  Answers answers(commands.size());
  const Answers untouched = answers;
  ManySolutions solutions = answers.All();
  SolveManyOptions options;
  GetParam().spoil(solutions, options);
  const auto expect_refused = [&](const auto& rhythm) {
    try {
      SolveMany(rhythm, commands, solutions, options);
      ADD_FAILURE() << "nothing was thrown";
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(error.what(), GetParam().message);
    }
    EXPECT_TRUE(SameBytes(answers.poses, untouched.poses));
    EXPECT_TRUE(SameBytes(answers.angles_rad, untouched.angles_rad));
    EXPECT_TRUE(SameBytes(answers.used, untouched.used));
    EXPECT_TRUE(SameBytes(answers.origins, untouched.origins));
    EXPECT_TRUE(SameBytes(answers.distances_rad, untouched.distances_rad));
  };
  expect_refused(Default());
  expect_refused(assembled);
}

std::string SizeMessage(const char* name, int size) {
  return "SolveMany: " + std::string(name) + " has " + std::to_string(size) +
         " elements for 5 commands. Give one element for each command";
}

INSTANTIATE_TEST_SUITE_P(
    Calls, SolveManyRefuses,
    testing::Values(
        Refusal{"fewer poses", [](auto& s, auto&) { s.poses = s.poses->first(4); },
                SizeMessage("poses", 4)},
        Refusal{"fewer angles", [](auto& s, auto&) { s.angles_rad = s.angles_rad->first(3); },
                SizeMessage("angles_rad", 3)},
        Refusal{"no used commands in a span", [](auto& s, auto&) { s.used = s.used->first(0); },
                SizeMessage("used", 0)},
        Refusal{"fewer origins", [](auto& s, auto&) { s.origins = s.origins->first(1); },
                SizeMessage("origins", 1)},
        Refusal{"fewer distances",
                [](auto& s, auto&) { s.distances_rad = s.distances_rad->first(4); },
                SizeMessage("distances_rad", 4)},
        Refusal{"no threads", [](auto&, auto& o) { o.threads = 0; },
                "SolveMany: 0 threads. Give at least 1"}));

TEST(SolveMany, RefusesMoreElementsThanCommands) {
  const std::vector<ArmCommand> commands(3);
  std::vector<double> distances_rad(4, -1);
  EXPECT_THROW(SolveMany(Default(), commands, {.distances_rad = distances_rad}),
               std::invalid_argument);
  EXPECT_EQ(distances_rad, std::vector<double>(4, -1));
}

TEST(SolveMany, RefusesInstructionsThatTheProcessorDoesNotHave) {
  EXPECT_TRUE(HasInstructions(Instructions::kQuickest));
  EXPECT_TRUE(HasInstructions(Instructions::kPortable));
  const std::vector<ArmCommand> commands(3);
  std::vector<double> distances_rad(3);
  const auto solve = [&] {
    SolveMany(Default(), commands, {.distances_rad = distances_rad},
              {.instructions = Instructions::kAvx2});
  };
  if (HasInstructions(Instructions::kAvx2)) {
    EXPECT_NO_THROW(solve());
  } else {
    EXPECT_THROW(solve(), std::invalid_argument);
  }
}

}  // namespace
}  // namespace girdle::solve_many_test
