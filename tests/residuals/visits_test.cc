// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// What the residual report looks at: a fault that is never visited is never found.

#include "residuals/visits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "residuals/report_lines.h"
#include "simulation/engine_fixture.h"

namespace girdle::visits_test {
namespace {

// Commands of one kind of visit, in their order.
struct Visits {
  std::vector<ArmCommand> commands;
  std::vector<int> numbers;  ///< of steps

  [[nodiscard]] std::size_t count() const { return commands.size(); }
};

// Lowest and highest value [deg].
using Extent = std::pair<double, double>;

Extent ExtentOf(const std::vector<ArmCommand>& commands, double ArmCommand::*angle_rad) {
  Extent extent_deg{std::numeric_limits<double>::infinity(),
                    -std::numeric_limits<double>::infinity()};
  for (const ArmCommand& command : commands) {
    const double angle_deg = DegreesFromRadians(command.*angle_rad);
    extent_deg = {std::min(extent_deg.first, angle_deg), std::max(extent_deg.second, angle_deg)};
  }
  return extent_deg;
}

void ExpectExtents(const std::vector<ArmCommand>& commands, const Extent& elevation_deg,
                   const Extent& plane_deg, double within_deg) {
  const Extent elevations_deg = ExtentOf(commands, &ArmCommand::elevation_rad);
  const Extent planes_deg = ExtentOf(commands, &ArmCommand::plane_rad);
  EXPECT_NEAR(elevations_deg.first, elevation_deg.first, within_deg);
  EXPECT_NEAR(elevations_deg.second, elevation_deg.second, within_deg);
  EXPECT_NEAR(planes_deg.first, plane_deg.first, within_deg);
  EXPECT_NEAR(planes_deg.second, plane_deg.second, within_deg);
}

using StepKey = std::pair<std::string, StepPhase>;
using PoseKey = std::pair<std::string, PoseKind>;

struct Recorded {
  std::map<StepKey, Visits> steps;
  std::map<PoseKey, Visits> poses;
  std::map<PoseKind, std::multiset<const RhythmPosition*>> positions;
  std::set<int> keys;
};

class RecordingGroup : public ResidualGroup {
 public:
  explicit RecordingGroup(Recorded& recorded) : recorded_(recorded) {}

  void TakeStep(const SteppedState& step) override {
    Visits& visits = recorded_.steps[{std::string(step.motion), step.phase}];
    visits.commands.push_back(step.state.command);
    visits.numbers.push_back(step.number);
  }
  void TakePose(const ShownPose& pose) override {
    recorded_.poses[{std::string(pose.name), pose.kind}].commands.push_back(pose.command);
    if (pose.position != nullptr) {
      recorded_.positions[pose.kind].insert(pose.position);
    }
    if (pose.kind == PoseKind::kKeyframe) {
      recorded_.keys.insert(pose.key);
    }
  }
  void AddLines(std::vector<Residual>& /*lines*/) override {}

 private:
  Recorded& recorded_;
};

struct Motion {
  std::string name;
  Extent elevation_deg;
  Extent plane_deg;
};

class VisitsTest : public EngineTest, public testing::WithParamInterface<ModelKind> {
 protected:
  VisitsTest() {
    std::vector<ResidualGroupPointer> groups;
    groups.push_back(std::make_unique<RecordingGroup>(recorded_));
    ShowVisits(simulation_, {simulation_, rhythm_, anatomy_}, groups, [](double) {});
  }

  // Steps of a time.
  [[nodiscard]] std::size_t Steps(double time_s) const {
    return static_cast<std::size_t>(std::lround(time_s / simulation_.timestep_s()));
  }
  [[nodiscard]] const Visits& Poses(const std::string& name, PoseKind kind) {
    return recorded_.poses[{name, kind}];
  }

  Anatomy anatomy_ = AnatomyOf(GetParam());
  AssembledRhythm rhythm_{BuiltInRhythm(RhythmOptionsOf(GetParam())),
                          ModelOptionsOf(GetParam()).assembly};
  ShoulderSimulation simulation_{
      LoadModel({{"shoulder.xml",
                  ShoulderModelXml(anatomy_, rhythm_.rhythm(), ModelOptionsOf(GetParam()))}}),
      "shoulder.xml"};
  Recorded recorded_;
};

// On the circle of arm_reach.h, of 45 deg about a centre at elevation 107.5, that touches plane
// -30.
const double kLowestPlaneOfALevelArm_deg =
    60 - 2 * DegreesFromRadians(
                 std::asin(std::sin(RadiansFromDegrees(45)) / std::sin(RadiansFromDegrees(107.5))));
const std::vector<Motion> kMotions = {
    {"abduction", {0, 150}, {0, 0}},
    {"scapular plane", {0, 150}, {40, 40}},
    {"flexion", {0, 150}, {90, 90}},
    // As far back as a level arm goes.
    {"protraction at 90", {90, 90}, {kLowestPlaneOfALevelArm_deg, 135}}};

// Numbers of steps are counted through all phases of a motion, from 0.
TEST_P(VisitsTest, GoThroughEveryMotionAndItsRest) {
  for (const Motion& motion : kMotions) {
    SCOPED_TRACE(motion.name);
    const Visits& moving = recorded_.steps[{motion.name, StepPhase::kMoving}];
    EXPECT_EQ(moving.count(), Steps(3));
    ExpectExtents(moving.commands, motion.elevation_deg, motion.plane_deg, 0.1);
    std::vector<int> numbers;
    for (const auto& [phase, time_s] :
         {std::pair(StepPhase::kMoving, 3.0), std::pair(StepPhase::kSettling, 3.0),
          std::pair(StepPhase::kSettled, 1.0)}) {
      const Visits& visits = recorded_.steps[{motion.name, phase}];
      EXPECT_EQ(visits.count(), Steps(time_s));
      numbers.insert(numbers.end(), visits.numbers.begin(), visits.numbers.end());
    }
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      ASSERT_EQ(numbers[i], static_cast<int>(i));
    }
    for (const StepPhase phase : {StepPhase::kSettling, StepPhase::kSettled}) {
      ExpectExtents(recorded_.steps[{motion.name, phase}].commands,
                    {motion.elevation_deg.second, motion.elevation_deg.second},
                    {motion.plane_deg.second, motion.plane_deg.second}, 1e-9);
    }
  }
}

// 128 parts of 165 deg, or of 150: in the middle of a motion they are longest.
TEST_P(VisitsTest, ShowPosesAllAlongEveryMotion) {
  for (const Motion& motion : kMotions) {
    SCOPED_TRACE(motion.name);
    const Visits& visits = Poses(motion.name, PoseKind::kAtTargets);
    EXPECT_EQ(visits.count(), 129U);
    ExpectExtents(visits.commands, motion.elevation_deg, motion.plane_deg, 1e-9);
    for (std::size_t i = 1; i < visits.count(); ++i) {
      const ArmCommand& from = visits.commands[i - 1];
      const ArmCommand& to = visits.commands[i];
      EXPECT_LT(DegreesFromRadians(std::hypot(to.elevation_rad - from.elevation_rad,
                                              to.plane_rad - from.plane_rad)),
                3);
    }
  }
}

// Two seconds each: over the elevations in three planes, and over the planes at two elevations.
TEST_P(VisitsTest, CycleOverTheWholeTable) {
  const Visits& cycling = recorded_.steps[{"1 Hz", StepPhase::kCycling}];
  const std::size_t each = Steps(2);
  ASSERT_EQ(cycling.count(), 5 * each);
  const std::vector<Motion> cycles = {{"frontal", {15, 120}, {0, 0}},
                                      {"scapular", {15, 120}, {40, 40}},
                                      {"sagittal", {15, 120}, {90, 90}},
                                      {"low", {60, 60}, {0, 90}},
                                      {"high", {100, 100}, {0, 90}}};
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    SCOPED_TRACE(cycles[i].name);
    const auto first = cycling.commands.begin() + static_cast<std::ptrdiff_t>(i * each);
    const std::vector<ArmCommand> commands(first, first + static_cast<std::ptrdiff_t>(each));
    ExpectExtents(commands, cycles[i].elevation_deg, cycles[i].plane_deg, 1e-6);
    // Halfway through a cycle it is at the end, and then at the beginning.
    const std::vector<ArmCommand> second_cycle(
        commands.begin() + static_cast<std::ptrdiff_t>(each / 2), commands.end());
    ExpectExtents(second_cycle, cycles[i].elevation_deg, cycles[i].plane_deg, 1e-6);
  }
}

TEST_P(VisitsTest, ShowEveryPositionOfTheTableOnce) {
  const RhythmTable& table = rhythm_.rhythm().table();
  std::multiset<const RhythmPosition*> all;
  for (std::size_t plane = 0; plane < 3; ++plane) {
    for (std::size_t elevation = 0; elevation < 22; ++elevation) {
      all.insert(&table.position(plane, elevation));
    }
  }
  std::map<PoseKind, std::multiset<const RhythmPosition*>> expected = {{PoseKind::kAtTargets, all}};
  if (IsLoop(GetParam())) {
    expected[PoseKind::kTableHeld] = all;
  }
  if (HasContact(GetParam())) {
    expected[PoseKind::kTableOnThorax] = all;
  }
  EXPECT_EQ(recorded_.positions, expected);
  for (const auto& [kind, positions] : expected) {
    const Visits& visits = Poses("table", kind);
    EXPECT_EQ(visits.count(), 66U);
    ExpectExtents(visits.commands, {15, 120}, {0, 90}, 1e-9);
  }
}

// Of 19 elevations and 24 planes; an arm that does not go so far goes as far as it does.
TEST_P(VisitsTest, ShowAGridOverAllThatTheArmReaches) {
  for (const PoseKind kind : {PoseKind::kGridHeld, PoseKind::kGridCommand}) {
    const Visits& visits = Poses("grid", kind);
    EXPECT_EQ(visits.count(), 19U * 24U);
    ExpectExtents(visits.commands, {0, 180}, {-95, 135}, 1e-9);
  }
}

TEST_P(VisitsTest, ShowEveryKeyframe) {
  std::set<int> keys;
  for (int key = 0; key < simulation_.model().nkey; ++key) {
    keys.insert(key);
  }
  EXPECT_EQ(keys.size(), kKeyframes.size());
  EXPECT_EQ(recorded_.keys, keys);
  for (const NamedPose& named : kKeyframes) {
    const Visits& visits = Poses(std::string(named.name), PoseKind::kKeyframe);
    ASSERT_EQ(visits.count(), 1U) << named.name;
    ExpectExtents(visits.commands, {named.elevation_deg, named.elevation_deg},
                  {named.plane_deg, named.plane_deg}, 1e-9);
  }
}

TEST_P(VisitsTest, AreNoOthers) {
  std::set<StepKey> steps = {{"1 Hz", StepPhase::kCycling}};
  std::set<PoseKey> poses = {{"table", PoseKind::kAtTargets},
                             {"grid", PoseKind::kGridHeld},
                             {"grid", PoseKind::kGridCommand}};
  for (const Motion& motion : kMotions) {
    for (const StepPhase phase : {StepPhase::kMoving, StepPhase::kSettling, StepPhase::kSettled}) {
      steps.insert({motion.name, phase});
    }
    poses.insert({motion.name, PoseKind::kAtTargets});
  }
  for (const NamedPose& named : kKeyframes) {
    poses.insert({std::string(named.name), PoseKind::kKeyframe});
  }
  if (IsLoop(GetParam())) {
    poses.insert({"table", PoseKind::kTableHeld});
  }
  if (HasContact(GetParam())) {
    poses.insert({"table", PoseKind::kTableOnThorax});
  }
  const auto keys_of = [](const auto& map) {
    std::set<typename std::decay_t<decltype(map)>::key_type> keys;
    for (const auto& [key, visits] : map) {
      keys.insert(key);
    }
    return keys;
  };
  EXPECT_EQ(keys_of(recorded_.steps), steps);
  EXPECT_EQ(keys_of(recorded_.poses), poses);
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, VisitsTest, testing::Values(ModelKind::kTree, ModelKind::kLoop, ModelKind::kLoopContact),
    [](const testing::TestParamInfo<ModelKind>& kind) { return std::string(Name(kind.param)); });

}  // namespace
}  // namespace girdle::visits_test
