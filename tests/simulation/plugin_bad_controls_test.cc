// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The plugin under controls that are no numbers, or infinite.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "rhythm_tables/built_in_tables.h"
#include "simulation/plugin_fixture.h"

namespace girdle::plugin_bad_controls_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool AllFinite(const mjtNum* values, std::size_t count) {
  return std::all_of(values, values + count, [](mjtNum value) { return std::isfinite(value); });
}

class BadControlTest : public FullPluginTest {
 protected:
  // Stands at a command of all five angles.
  void StandStill() {
    mj_resetData(model_.get(), data_.get());
    SetCommand(kCommand);
    PutAt(TargetsOf(rhythm_, kCommand));
    mj_step(model_.get(), data_.get());
  }

  void StepFinitely(double duration_s, const std::string& name) const {
    const double end_s = data_->time + duration_s;
    while (data_->time < end_s) {
      mj_step(model_.get(), data_.get());
      ASSERT_TRUE(AllFinite(data_->actuator_force, model_->nactuator)) << name;
      ASSERT_TRUE(AllFinite(data_->sensordata, model_->nsensordata)) << name;
      ASSERT_TRUE(AllFinite(data_->qpos, model_->nq)) << name;
    }
  }

  [[nodiscard]] double FarthestFrom(const JointAngles& angles_rad) const {
    double farthest_rad = 0;
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      farthest_rad = std::max(farthest_rad, std::abs(data_->qpos[k] - angles_rad[k]));
    }
    return farthest_rad;
  }

  std::string NameOf(double bad, int control) const {
    return std::to_string(bad) + " in control " + std::to_string(control);
  }

  // MuJoCo warns of what is not a number. What is infinite it takes into the control's range first,
  // and is content.
  static void ExpectMujocosWarning(double bad, const std::string& name) {
    if (std::isnan(bad)) {
      ExpectOneWarning(name);
    } else {
      EXPECT_EQ(TakenWarnings(), "") << name;
    }
  }

  static void ExpectOneWarning(const std::string& name) {
    const std::string warnings = TakenWarnings();
    EXPECT_NE(warnings.find("in CTRL"), std::string::npos) << name << ": " << warnings;
    EXPECT_EQ(warnings.find("; "), std::string::npos) << name << ": " << warnings;
  }

  static constexpr ArmCommand kCommand = {1.1, 0.4, 0.1, 0.05, -0.04};
  const ShoulderRhythm rhythm_ = BuiltInRhythm();
};

TEST_F(BadControlTest, AnythingInAnyOfThemLeavesFiniteForcesAndOneWarningAtMost) {
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    for (int control = 0; control < static_cast<int>(model_->nu); ++control) {
      StandStill();
      data_->ctrl[control] = bad;
      ASSERT_NO_FATAL_FAILURE(StepFinitely(0.2, NameOf(bad, control)));
      ExpectMujocosWarning(bad, NameOf(bad, control));
    }
  }
}

TEST_F(BadControlTest, JointsHoldStillWhereAControlIsNotANumber) {
  const JointAngles start_rad = TargetsOf(rhythm_, kCommand);
  // Gravity is compensated and nothing pushes: only rounding moves them.
  constexpr double kStill_rad = 1e-10;
  for (int control = 0; control < static_cast<int>(model_->nu); ++control) {
    StandStill();
    data_->ctrl[control] = kNan;
    StepFinitely(1, NameOf(kNan, control));
    EXPECT_LT(FarthestFrom(start_rad), kStill_rad) << NameOf(kNan, control);
    ExpectOneWarning(NameOf(kNan, control));
  }
}

// Trims and rates belong to the command.
TEST_F(BadControlTest, NothingPushesWhereACommandIsNotANumber) {
  const int relaxed = mj_name2id(model_.get(), mjOBJ_KEY, "relaxed");
  for (int control = 0; control < static_cast<int>(kCommandCount + kOffsetCount); ++control) {
    mj_resetDataKeyframe(model_.get(), data_.get(), relaxed);
    data_->ctrl[control] = kNan;
    for (std::size_t rate = kCommandCount + kOffsetCount; rate < kAllCommandCount; ++rate) {
      data_->ctrl[rate] = 2;
    }
    mj_step(model_.get(), data_.get());
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      EXPECT_EQ(forces()[k], 0) << NameOf(kNan, control) << ", " << kCoordinateNames[k];
    }
    StepFinitely(1, NameOf(kNan, control));
    for (int k = 0; k < kPositions; ++k) {
      EXPECT_NEAR(data_->qpos[k], model_->key_qpos[relaxed * model_->nq + k], 1e-10)
          << NameOf(kNan, control) << ", " << kCoordinateNames[k];
    }
    ExpectOneWarning(NameOf(kNan, control));
  }
}

TEST_F(BadControlTest, AMovingArmComesToRestWhereACommandIsNotANumber) {
  mj_resetData(model_.get(), data_.get());
  while (data_->time < 0.5) {
    data_->ctrl[0] = 2 * data_->time;
    mj_step(model_.get(), data_.get());
  }
  const double speed_rad_per_s =
      *std::max_element(data_->qvel, data_->qvel + model_->nv,
                        [](mjtNum a, mjtNum b) { return std::abs(a) < std::abs(b); });
  ASSERT_GT(std::abs(speed_rad_per_s), 0.1);
  data_->ctrl[0] = kNan;
  StepFinitely(0.5, "moving");
  for (int k = 0; k < kPositions; ++k) {
    // Damping alone brakes: inertia / damping is 10 ms at most, so that this is 50 of them.
    EXPECT_LT(std::abs(data_->qvel[k]), 1e-6) << kCoordinateNames[k];
  }
  ExpectOneWarning("moving");
}

TEST_F(BadControlTest, TheSensorShowsWhereTheArmIsWhereACommandIsNotANumber) {
  StandStill();
  data_->ctrl[0] = kNan;
  mj_forward(model_.get(), data_.get());
  const mjtNum* values = data_->sensordata;
  EXPECT_EQ(values[sensor_layout::kCommanded], values[sensor_layout::kReached]);
  EXPECT_EQ(values[sensor_layout::kCommanded + 1], values[sensor_layout::kReached + 1]);
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    EXPECT_EQ(values[sensor_layout::kTarget + k], data_->qpos[k]) << kCoordinateNames[k];
    EXPECT_EQ(values[sensor_layout::kError + k], 0) << kCoordinateNames[k];
  }
  ExpectOneWarning("sensor");
}

TEST_F(BadControlTest, InfiniteCommandsAreThoseAtTheEndOfTheirRange) {
  for (const double bad : {kInfinity, -kInfinity}) {
    for (int control = 0; control < static_cast<int>(model_->nu); ++control) {
      StandStill();
      data_->ctrl[control] = model_->actuator_ctrlrange[2 * control + (bad > 0 ? 1 : 0)];
      mj_forward(model_.get(), data_.get());
      const std::vector<mjtNum> expected(forces(), forces() + kPositions);
      data_->ctrl[control] = bad;
      mj_forward(model_.get(), data_.get());
      EXPECT_EQ(std::vector(forces(), forces() + kPositions), expected) << NameOf(bad, control);
      ExpectMujocosWarning(bad, NameOf(bad, control));
    }
  }
}

TEST_F(BadControlTest, TheArmFollowsAgainOnceAllAreNumbers) {
  constexpr ArmCommand kNext = {1.3, 0.5, -0.1, 0, 0.05};
  const JointAngles next_rad = TargetsOf(rhythm_, kNext);
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    for (int control = 0; control < static_cast<int>(model_->nu); ++control) {
      StandStill();
      data_->ctrl[control] = bad;
      StepFinitely(0.1, NameOf(bad, control));
      data_->ctrl[control] = 0;
      SetCommand(kNext);
      StepFinitely(2, NameOf(bad, control));
      // A hundred times the lag of 20 ms.
      EXPECT_LT(FarthestFrom(next_rad), 1e-9) << NameOf(bad, control);
      ExpectMujocosWarning(bad, NameOf(bad, control));
    }
  }
}

// Without ranges for its controls a model has nothing to clamp an infinite one to.
TEST_F(BadControlTest, InfiniteOnesWithoutRangesLeaveFiniteForcesToo) {
  for (int control = 0; control < static_cast<int>(model_->nu); ++control) {
    model_->actuator_ctrllimited[control] = false;
  }
  for (const double bad : {kInfinity, -kInfinity}) {
    for (int control = 0; control < static_cast<int>(model_->nu); ++control) {
      StandStill();
      data_->ctrl[control] = bad;
      ASSERT_NO_FATAL_FAILURE(StepFinitely(0.1, NameOf(bad, control)));
      ExpectOneWarning(NameOf(bad, control));
    }
  }
}

}  // namespace
}  // namespace girdle::plugin_bad_controls_test
