// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "simulation/shoulder_simulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "anatomy/built_in_anatomy.h"
#include "rhythm_tables/built_in_tables.h"
#include "simulation/plugin_fixture.h"
#include "text/input_error.h"

namespace girdle::shoulder_simulation_test {
namespace {

class ShoulderSimulationTest : public EngineTest {
 protected:
  static ShoulderSimulation Simulation(const ShoulderModelOptions& options = {}) {
    return {LoadedModel(ShoulderXml(options)), "shoulder.xml"};
  }

  static void ExpectTargets(const ShoulderState& state, const ArmCommand& command) {
    EXPECT_EQ(state.target_rad, TargetsOf(BuiltInRhythm(), command));
  }
};

TEST_F(ShoulderSimulationTest, StartsAtTheTargets) {
  ShoulderSimulation simulation = Simulation();
  const ArmCommand command{1.2, 0.6, 0.2};
  simulation.Start(command);
  const ShoulderState state = simulation.Observe(command);
  ExpectTargets(state, command);
  EXPECT_EQ(state.position_rad, state.target_rad);
  EXPECT_FALSE(state.clamped);
}

TEST_F(ShoulderSimulationTest, CommandsOffsetsWhereTheModelHasThem) {
  ShoulderSimulation simulation = Simulation({.has_offsets = true});
  const ArmCommand command{1.2, 0.6, 0, 0.1, -0.05};
  ExpectTargets(simulation.ObserveAtTargets(command), command);
  // And takes them back.
  ExpectTargets(simulation.ObserveAtTargets({1.2, 0.6}), {1.2, 0.6});
}

TEST_F(ShoulderSimulationTest, RefusesOffsetsThatTheModelDoesNotHave) {
  ShoulderSimulation simulation = Simulation();
  const auto message = [&simulation](const ArmCommand& command) -> std::string {
    try {
      simulation.Start(command);
    } catch (const InputError& error) {
      return error.what();
    }
    return "(nothing was thrown)";
  };
  EXPECT_EQ(message({1, 0.5, 0, 0.1, 0}),
            "shoulder.xml: shrug is commanded, and the model has no actuator \"shrug_r\". Make one "
            "that has with girdle generate --offsets");
  EXPECT_EQ(message({1, 0.5, 0, 0, 0.1}),
            "shoulder.xml: protraction is commanded, and the model has no actuator "
            "\"protraction_r\". Make one that has with girdle generate --offsets");
}

TEST_F(ShoulderSimulationTest, CommandsRatesWhereTheModelHasThem) {
  const ArmCommand command{1.2, 0.6};
  const CommandRate rate = {1, -1, 0.5};
  ShoulderSimulation without = Simulation();
  ShoulderSimulation with = Simulation({.has_rates = true});
  for (ShoulderSimulation* simulation : {&without, &with}) {
    simulation->Start(command);
    simulation->Step(command, rate);
  }
  // A model that has no rates stands still; one that has them begins to move.
  EXPECT_EQ(without.Observe(command).position_rad, without.Observe(command).target_rad);
  EXPECT_NE(with.Observe(command).position_rad, with.Observe(command).target_rad);
  // A rate is that of one step alone.
  with.Start(command);
  with.Step(command, rate);
  with.Start(command);
  with.Step(command);
  EXPECT_EQ(with.Observe(command).position_rad, with.Observe(command).target_rad);
}

TEST_F(ShoulderSimulationTest, SaysThatACommandWasClampedAndHowFarItIsFromMeasuredData) {
  ShoulderSimulation simulation = Simulation();
  const ArmCommand measured{RadiansFromDegrees(60), RadiansFromDegrees(40)};
  EXPECT_FALSE(simulation.ObserveAtTargets(measured).clamped);
  EXPECT_EQ(simulation.ObserveAtTargets(measured).distance_rad, 0);
  const ArmCommand overhead{RadiansFromDegrees(150), RadiansFromDegrees(40)};
  EXPECT_FALSE(simulation.ObserveAtTargets(overhead).clamped);
  EXPECT_NEAR(simulation.ObserveAtTargets(overhead).distance_rad, RadiansFromDegrees(30), 1e-12);
  const ArmCommand behind{RadiansFromDegrees(90), RadiansFromDegrees(-45)};
  EXPECT_TRUE(simulation.ObserveAtTargets(behind).clamped);
  EXPECT_NEAR(simulation.ObserveAtTargets(behind).distance_rad, RadiansFromDegrees(45), 1e-12);
}

TEST_F(ShoulderSimulationTest, HasTheJointRangesOfItsModel) {
  const JointRanges expected = BuiltInAnatomy().ranges;
  const ShoulderSimulation simulation = Simulation();
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    EXPECT_EQ(simulation.ranges()[k].lower_rad, expected[k].lower_rad) << kCoordinateNames[k];
    EXPECT_EQ(simulation.ranges()[k].upper_rad, expected[k].upper_rad) << kCoordinateNames[k];
  }
}

}  // namespace
}  // namespace girdle::shoulder_simulation_test
