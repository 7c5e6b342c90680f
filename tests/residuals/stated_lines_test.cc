// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Lines of the residual report that are stated only: nobody would see that they are wrong. Each is
// held here against what it must be.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "anatomy/posed_bones.h"
#include "kinematics/lengths.h"
#include "residuals/report_lines.h"
#include "residuals/residual_groups.h"
#include "simulation/engine_fixture.h"

namespace girdle::stated_lines_test {
namespace {

class StatedLinesTest : public EngineTest {
 protected:
  static ModelPointer Load(ModelKind kind) {
    return LoadModel({{"shoulder.xml",
                       ShoulderModelXml(BuiltInAnatomy(), BuiltInRhythm(), ModelOptionsOf(kind))}});
  }

  static Residual Line(ResidualGroup& group, const std::string& item) {
    std::vector<Residual> lines;
    group.AddLines(lines);
    const auto found = std::find_if(lines.begin(), lines.end(), [&](const Residual& line) {
      return line.item.starts_with(item);
    });
    if (found == lines.end()) {
      ADD_FAILURE() << "no line for " << item;
      return {};
    }
    return *found;
  }
};

// The oracle for lengths knows no tendons: the anatomy's attachments in the rhythm's poses.
TEST_F(StatedLinesTest, OfALigamentAreThoseOfAKnownStretch) {
  constexpr double kStretch_m = 0.003;
  constexpr double kRounding = 1e-6;
  const std::array<ArmCommand, 3> commands = {
      ArmCommand{RadiansFromDegrees(20), 0},
      ArmCommand{RadiansFromDegrees(70), RadiansFromDegrees(40)},
      ArmCommand{RadiansFromDegrees(110), RadiansFromDegrees(90)}};
  const Anatomy anatomy = BuiltInAnatomy();
  const AssembledRhythm rhythm(BuiltInRhythm(), Assembly::kTree);
  for (std::size_t i = 0; i < kLigamentCount; ++i) {
    const std::string name(kLigamentNames[i]);
    SCOPED_TRACE(name);
    const Ligament& ligament = anatomy.ligaments[i];
    std::vector<double> lengths_m;
    lengths_m.reserve(commands.size());
    for (const ArmCommand& command : commands) {
      lengths_m.push_back(LigamentLength_m(ligament, anatomy, rhythm.SolvePose(command)));
    }
    const auto [shortest_m, longest_m] = std::minmax_element(lengths_m.begin(), lengths_m.end());
    ASSERT_GT(*longest_m - *shortest_m, 0.0005);

    ModelPointer model = Load(ModelKind::kTree);
    const int tendon = mj_name2id(model.get(), mjOBJ_TENDON, (name + "_r").c_str());
    ASSERT_GE(tendon, 0);
    model->tendon_lengthspring[2 * tendon + 1] = *longest_m - kStretch_m;
    ShoulderSimulation simulation(std::move(model), "shoulder.xml");
    const ResidualGroupPointer group = MakeLigamentsGroup({simulation, rhythm, anatomy});
    for (const ArmCommand& command : commands) {
      const ShoulderState state = simulation.ObserveAtTargets(command);
      group->TakePose(
          {"pose", PoseKind::kAtTargets, command, state, rhythm.SolvePose(command), nullptr});
    }
    EXPECT_NEAR(Line(*group, name + ", shortest").value, kMillimetersPerMeter * *shortest_m,
                kRounding);
    EXPECT_NEAR(Line(*group, name + ", longest").value, kMillimetersPerMeter * *longest_m,
                kRounding);
    EXPECT_NEAR(Line(*group, name + ", beyond slack").value, kMillimetersPerMeter * kStretch_m,
                kRounding);
    const double force_N = ligament.stiffness_N_per_m * kStretch_m;
    ASSERT_GT(force_N, 10);
    EXPECT_NEAR(Line(*group, name + ", force").value, force_N, kRounding * force_N);
  }
}

// In a loop the scapula hangs from the thorax on three slides at right angles. The connect of AC
// pushes it with the force that those slides feel of constraints.
TEST_F(StatedLinesTest, OfTheForceInAcAreWhatTheScapulasSlidesFeel) {
  const Anatomy anatomy = BuiltInAnatomy();
  const AssembledRhythm rhythm(BuiltInRhythm(), Assembly::kLoop);
  ShoulderSimulation simulation(Load(ModelKind::kLoop), "shoulder.xml");
  const MeasuredShoulder shoulder{simulation, rhythm, anatomy};
  const auto felt_N = [&simulation] {
    double squared = 0;
    for (const std::string_view slide : kTranslationNames) {
      const int joint =
          mj_name2id(&simulation.model(), mjOBJ_JOINT, SidedName(slide, Side::kRight).c_str());
      if (joint < 0) {
        ADD_FAILURE() << "no slide " << slide;
        continue;
      }
      const double force_N =
          simulation.data().qfrc_constraint[simulation.model().jnt_dofadr[joint]];
      squared += force_N * force_N;
    }
    return std::sqrt(squared);
  };
  const auto expect_line = [](ResidualGroup& group, const std::string& item, double force_N) {
    EXPECT_GT(force_N, 1) << item;
    EXPECT_NEAR(Line(group, item).value, force_N, 1e-6 * force_N) << item;
  };

  const ResidualGroupPointer group = MakeJointConstraintGroup(shoulder);
  double cycling_N = 0;
  double settled_N = 0;
  simulation.Start({});
  constexpr int kSteps = 300;
  for (int step = 0; step < kSteps; ++step) {
    const ArmCommand command{RadiansFromDegrees(0.3 * step), RadiansFromDegrees(40)};
    const ShoulderState state = simulation.Step(command);
    // In turns: each of the two lines has steps of its own.
    const bool is_cycling = step % 2 == 0;
    double& largest_N = is_cycling ? cycling_N : settled_N;
    largest_N = std::max(largest_N, felt_N());
    group->TakeStep(
        {"raising", is_cycling ? StepPhase::kCycling : StepPhase::kSettled, step, state});
  }
  const ArmCommand held{RadiansFromDegrees(60), 0};
  // Where it rests there is no force: it is on its way.
  simulation.Start({});
  for (int step = 0; step < kSteps / 10; ++step) {
    simulation.Step(held);
  }
  const ShoulderState state = simulation.Observe(held);
  group->TakePose({"pose", PoseKind::kGridHeld, held, state, rhythm.SolvePose(held), nullptr});
  expect_line(*group, "AC force at rest", settled_N);
  expect_line(*group, "AC force at the worst pose", felt_N());
  expect_line(*group, "AC force at 1 Hz", cycling_N);
  EXPECT_NE(settled_N, cycling_N);
}

}  // namespace
}  // namespace girdle::stated_lines_test
