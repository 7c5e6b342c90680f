// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "residuals/residual_groups.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "residuals/report_lines.h"
#include "simulation/engine_fixture.h"

namespace girdle::residual_groups_test {
namespace {

using Lines = std::set<std::string>;

constexpr std::array kPhases = {StepPhase::kMoving, StepPhase::kSettling, StepPhase::kSettled,
                                StepPhase::kCycling};
constexpr std::array kKinds = {PoseKind::kAtTargets, PoseKind::kTableHeld, PoseKind::kTableOnThorax,
                               PoseKind::kGridHeld, PoseKind::kGridCommand};

// Read from the model, not from a state.
const Lines kOfTheModel = {"bones: masses",
                           "bones: centres of mass",
                           "bones: moments of inertia",
                           "kinematic consistency: keyframes",
                           "kinematic consistency: keyframes, scapula's place",
                           "ligaments: slack against the anatomy's",
                           "ligaments: stiffness against the anatomy's",
                           "ligaments: range against the anatomy's",
                           "thorax contact: armature against the built-in's"};

// A state of which nothing is known.
ShoulderState Unknown(const ArmCommand& command) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  ShoulderState state;
  state.command = command;
  state.target_rad.fill(kNaN);
  state.position_rad.fill(kNaN);
  state.fastest_rad_per_s = kNaN;
  state.fastest_m_per_s = kNaN;
  state.distance_rad = kNaN;
  state.connect_force_N = kNaN;
  state.ligament_m.fill(kNaN);
  state.ligament_force_N.fill(kNaN);
  state.contact_force_N = kNaN;
  state.contact_depth_m = kNaN;
  state.pushed_rad.fill(kNaN);
  state.q_WB.fill({kNaN, kNaN, kNaN, kNaN});
  state.site_m.fill({kNaN, kNaN, kNaN});
  return state;
}

class ResidualGroupsTest : public EngineTest, public testing::WithParamInterface<ModelKind> {
 protected:
  ResidualGroupsTest()
      : options_(ModelOptionsOf(GetParam())),
        rhythm_(BuiltInRhythm(RhythmOptionsOf(GetParam())), options_.assembly),
        simulation_(
            LoadModel({{"shoulder.xml", ShoulderModelXml(anatomy_, rhythm_.rhythm(), options_)}}),
            "shoulder.xml"),
        groups_(MakeResidualGroups(simulation_, shoulder_, GirdleMotion::kMeasured)) {}

  // Shows one state as every step and every pose that there is.
  void Show(const ShoulderState& state) {
    const ShoulderPose wanted = rhythm_.SolvePose(kCommand);
    const RhythmPosition& position = rhythm_.rhythm().table().position(0, 0);
    for (const ResidualGroupPointer& group : groups_) {
      for (const StepPhase phase : kPhases) {
        group->TakeStep({"motion", phase, 0, state});
      }
      for (const PoseKind kind : kKinds) {
        group->TakePose({"pose", kind, kCommand, state, wanted, &position});
      }
    }
  }

  [[nodiscard]] std::vector<Residual> Report() {
    std::vector<Residual> lines;
    for (const ResidualGroupPointer& group : groups_) {
      group->AddLines(lines);
    }
    return lines;
  }

  // Where the table begins. There the plane has a meaning.
  static constexpr ArmCommand kCommand = {RadiansFromDegrees(15), 0};

  Anatomy anatomy_ = AnatomyOf(GetParam());
  ShoulderModelOptions options_;
  AssembledRhythm rhythm_;
  ShoulderSimulation simulation_;
  MeasuredShoulder shoulder_{simulation_, rhythm_, anatomy_};
  std::vector<ResidualGroupPointer> groups_;
};

TEST_P(ResidualGroupsTest, FailInEveryCheckedLineIfAnythingIsNoNumber) {
  const ShoulderState sound = simulation_.ObserveAtTargets(kCommand);
  Show(sound);
  Show(Unknown(kCommand));
  Show(sound);
  for (const Residual& line : Report()) {
    const std::string name = LineName(line);
    // A landmark on a bone is looked at once, in the first pose, which was sound.
    if (line.tolerance && !kOfTheModel.contains(name) && name != "bones: landmarks") {
      EXPECT_TRUE(std::isnan(line.value)) << name << " " << line.value;
      EXPECT_FALSE(line.passed()) << name;
    }
  }
}

TEST_P(ResidualGroupsTest, FailInEveryCheckedLineIfNothingIsVisited) {
  Lines failed;
  for (const Residual& line : Report()) {
    if (!line.passed()) {
      failed.insert(LineName(line));
    }
  }
  Lines checked;
  for (const ReportLine& line : LinesOf(GetParam())) {
    // A model may have no keyframes; then there is no line on them.
    if (line.is_checked() && !line.name.starts_with("kinematic consistency: keyframes")) {
      checked.insert(line.name);
    }
  }
  EXPECT_EQ(failed, checked);
}

// A scapula that hardly touches the thorax says nothing of how hard the thorax pushes.
TEST_P(ResidualGroupsTest, DoNotPassAThoraxThatIsNotPushedInFarEnough) {
  ShoulderState state = simulation_.ObserveAtTargets(kCommand);
  state.contact_depth_m = 0.0009;
  state.contact_force_N = 18;
  Show(state);
  Lines unmeasured;
  for (const Residual& line : Report()) {
    if (line.where.starts_with("not measured")) {
      EXPECT_TRUE(std::isnan(line.value)) << line.value;
      EXPECT_FALSE(line.passed());
      EXPECT_EQ(line.where, "not measured: no contact is deeper than 1 mm");
      unmeasured.insert(LineName(line));
    }
  }
  EXPECT_EQ(unmeasured, HasContact(GetParam()) ? Lines{kContactStiffnessLine} : Lines{});
}

INSTANTIATE_TEST_SUITE_P(Kinds, ResidualGroupsTest, testing::ValuesIn(kModelKinds),
                         [](const testing::TestParamInfo<ModelKind>& kind) {
                           return std::string(Name(kind.param));
                         });

}  // namespace
}  // namespace girdle::residual_groups_test
