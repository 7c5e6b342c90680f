// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Rates of the commands: what the plugin feeds forward, and how much less the joints lag for it.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include "motions/motion.h"
#include "names/joint_dynamics.h"
#include "rhythm_tables/built_in_tables.h"
#include "simulation/plugin_fixture.h"
#include "simulation/shoulder_simulation.h"

namespace girdle::feed_forward_test {
namespace {

constexpr int kFirstRate = kCommandCount + kOffsetCount;

// Forces of a few N m, and rounding.
constexpr double kSameForce_N_m = 1e-6;

class FeedForwardTest : public PluginTest {
 protected:
  explicit FeedForwardTest(const std::string& xml = FullShoulderXml()) : PluginTest(xml) {}

  void SetRates(const CommandRate& rates) const {
    std::copy(rates.begin(), rates.end(), data_->ctrl + kFirstRate);
  }

  // What the rates add to the forces.
  [[nodiscard]] std::array<double, kCoordinateCount> Added(const CommandRate& rates) const {
    SetRates({});
    mj_forward(model_.get(), data_.get());
    const std::vector<mjtNum> without(forces(), forces() + kPositions);
    SetRates(rates);
    mj_forward(model_.get(), data_.get());
    std::array<double, kCoordinateCount> added{};
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      added[k] = forces()[k] - without[k];
    }
    return added;
  }

  void ExpectNothingAdded(const CommandRate& rates, const std::string& when) const {
    for (const double force_N_m : Added(rates)) {
      EXPECT_EQ(force_N_m, 0) << when;
    }
  }

  const ShoulderRhythm rhythm_ = BuiltInRhythm();
};

TEST_F(FeedForwardTest, AddsDampingTimesTheRateOfTheTarget) {
  std::mt19937 random(21);
  for (int sample = 0; sample < 500; ++sample) {
    const ArmCommand command{DrawDegrees(random, 1, 179), DrawDegrees(random, -29, 134),
                             DrawDegrees(random, -10, 10), DrawDegrees(random, -5, 5),
                             DrawDegrees(random, -5, 5)};
    SetCommand(command);
    RandomisePositions(random);
    const CommandRate rates = {Draw(random, -3, 3), Draw(random, -3, 3), Draw(random, -3, 3)};
    const auto added = Added(rates);
    constexpr double kNudge_s = 1e-5;
    const auto targets_at = [&](double time_s) {
      ArmCommand moved = command;
      moved.elevation_rad += rates[0] * time_s;
      moved.plane_rad += rates[1] * time_s;
      moved.axial_rad += rates[2] * time_s;
      return TargetsOf(rhythm_, moved);
    };
    const JointAngles after_rad = targets_at(kNudge_s);
    const JointAngles before_rad = targets_at(-kNudge_s);
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      const double rate_rad_per_s = (after_rad[k] - before_rad[k]) / (2 * kNudge_s);
      // The difference leaves out rate^3 nudge^2 / 6 of a third derivative below 1e3.
      EXPECT_NEAR(added[k], kJointDynamics[k / 3].damping_N_m_s_per_rad * rate_rad_per_s, 1e-4)
          << "sample " << sample << ", " << kCoordinateNames[k];
    }
  }
}

TEST_F(FeedForwardTest, IsZeroWithoutRates) {
  SetCommand({1, 0.5});
  ExpectNothingAdded({0, 0, 0}, "no rates");
}

TEST_F(FeedForwardTest, AddsNothingForCommandsThatTheirRangesHoldBack) {
  SetCommand({RadiansFromDegrees(200), RadiansFromDegrees(40)});
  ExpectNothingAdded({1, 0, 0}, "elevation 200");
  // The nearest direction stays where it is: a level one on the last plane.
  SetCommand({RadiansFromDegrees(90), RadiansFromDegrees(150)});
  ExpectNothingAdded({0, 1, 0}, "plane 150");
  SetCommand({RadiansFromDegrees(90), RadiansFromDegrees(40), 3});
  ExpectNothingAdded({0, 0, 1}, "axial 3 rad");
}

// An elevation is no angle that goes round, and a turn on top of the rhythm's own neither: a whole
// turn beyond their ends they are beyond them.
TEST_F(FeedForwardTest, AddsNothingForAmountsAWholeTurnBeyondTheirEnds) {
  const mjtNum* const elevation = model_->actuator_ctrlrange;
  SetCommand({elevation[1] + 2 * kPi, RadiansFromDegrees(40)});
  ExpectNothingAdded({1, 0, 0}, "elevation 540");
  const mjtNum* const axial = model_->actuator_ctrlrange + 2 * 2;
  SetCommand({RadiansFromDegrees(60), RadiansFromDegrees(40), axial[1] + 2 * kPi});
  ExpectNothingAdded({0, 0, 1}, "axial, a turn beyond its end");
}

TEST_F(FeedForwardTest, AddsTheSameForAPlaneAWholeTurnOn) {
  SetCommand({RadiansFromDegrees(60), RadiansFromDegrees(40)});
  const auto added = Added({0, 1, 0});
  SetCommand({RadiansFromDegrees(60), RadiansFromDegrees(400)});
  const auto turned = Added({0, 1, 0});
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    EXPECT_NEAR(turned[k], added[k], kSameForce_N_m) << kCoordinateNames[k];
  }
  EXPECT_GT(std::abs(added[kGhAxialIndex]), kSameForce_N_m);
}

class FeedForwardFromIsbTest : public FeedForwardTest {
 protected:
  FeedForwardFromIsbTest()
      : FeedForwardTest(
            ShoulderXml({.axial_from = AxialFrom::kIsb, .has_offsets = true, .has_rates = true})) {}
};

TEST_F(FeedForwardFromIsbTest, AddsTheSameForAnAxialAngleAWholeTurnOn) {
  SetCommand({RadiansFromDegrees(60), RadiansFromDegrees(40), RadiansFromDegrees(-45)});
  const auto added = Added({0, 0, 1});
  SetCommand({RadiansFromDegrees(60), RadiansFromDegrees(40), RadiansFromDegrees(315)});
  const auto turned = Added({0, 0, 1});
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    EXPECT_NEAR(turned[k], added[k], kSameForce_N_m) << kCoordinateNames[k];
  }
  EXPECT_GT(std::abs(added[kGhAxialIndex]), kSameForce_N_m);
}

// Where the answer is far from the direction that is asked for a share of ISB's turn counts, and of
// its rate.
TEST_F(FeedForwardFromIsbTest, AddsTheShareOfAnAxialRateThatCounts) {
  const ShoulderRhythm rhythm = BuiltInRhythm();
  ArmCommand command = {RadiansFromDegrees(80), RadiansFromDegrees(-160), RadiansFromDegrees(-20)};
  command.axial_from = AxialFrom::kIsb;
  SetCommand(command);
  const double added_N_m = Added({0, 0, 1})[kGhAxialIndex];
  constexpr double kNudge_rad = 1e-6;
  ArmCommand moved = command;
  moved.axial_rad += kNudge_rad;
  const double rate =
      (TargetsOf(rhythm, moved)[kGhAxialIndex] - TargetsOf(rhythm, command)[kGhAxialIndex]) /
      kNudge_rad;
  EXPECT_GT(rate, 0.2);
  EXPECT_LT(rate, 0.8);
  EXPECT_NEAR(added_N_m, kJointDynamics[2].damping_N_m_s_per_rad * rate, kSameForce_N_m);
}

TEST_F(FeedForwardTest, AddsNothingToAHumerusAtTheEndOfItsRange) {
  // The control's own end, behind the body, where the hinge ends earlier.
  SetCommand({RadiansFromDegrees(50), RadiansFromDegrees(-55), model_->actuator_ctrlrange[2 * 2]});
  mj_forward(model_.get(), data_.get());
  ASSERT_NE(data_->sensordata[sensor_layout::kCommanded + 2], data_->ctrl[2]);
  EXPECT_EQ(Added({0.5, 0.5, 1})[kGhAxialIndex], 0);
}

TEST_F(FeedForwardTest, AddsNothingWhereDampingIsDisabled) {
  model_->opt.disableflags |= mjDSBL_DAMPER;
  SetCommand({1, 0.5});
  ExpectNothingAdded({1, 1, 1}, "no damping");
}

TEST_F(FeedForwardTest, RatesThatAreNoNumbersAddNothing) {
  SetCommand({1, 0.5});
  for (const double bad : {std::nan(""), -std::nan("")}) {
    ExpectNothingAdded({bad, bad, bad}, "NaN");
  }
  EXPECT_NE(TakenWarnings().find("in CTRL"), std::string::npos);
}

// Largest tracking error of any joint while the arm is raised and lowered [rad].
double LargestLag(bool has_rates) {
  ShoulderSimulation simulation(LoadedModel(ShoulderXml({.has_rates = has_rates})), "shoulder.xml");
  const Motion raise = ReachingMotion("raise", {0, RadiansFromDegrees(40)},
                                      {RadiansFromDegrees(150), RadiansFromDegrees(40)}, 2);
  simulation.Start(raise.command(0));
  double largest_rad = 0;
  for (double time_s = 0; time_s < raise.duration_s; time_s += simulation.timestep_s()) {
    const ShoulderState state =
        simulation.Step(raise.command(time_s), RateOf(raise, time_s, simulation.timestep_s()));
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      largest_rad = std::max(largest_rad, std::abs(state.target_rad[k] - state.position_rad[k]));
    }
  }
  return largest_rad;
}

// Damping over stiffness is a lag of 20 ms, 2.8 deg at the 140 deg/s of this raise. Fed forward,
// what is left is inertia times acceleration over stiffness: of the whole arm 0.2 kg m^2 times 4
// rad/s^2 over 500 N m/rad, 0.1 deg.
TEST_F(EngineTest, RatesMakeARaiseLagTenTimesLess) {
  const double without_rad = LargestLag(false);
  const double with_rad = LargestLag(true);
  RecordProperty("without_deg", std::to_string(DegreesFromRadians(without_rad)));
  RecordProperty("with_deg", std::to_string(DegreesFromRadians(with_rad)));
  EXPECT_GT(without_rad, 10 * with_rad) << "without " << DegreesFromRadians(without_rad)
                                        << " deg, with " << DegreesFromRadians(with_rad) << " deg";
}

}  // namespace
}  // namespace girdle::feed_forward_test
