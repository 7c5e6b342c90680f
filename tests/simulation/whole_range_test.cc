// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The simulated arm everywhere that an arm reaches.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "rhythm_tables/built_in_tables.h"
#include "simulation/plugin_fixture.h"

namespace girdle::whole_range_test {
namespace {

class WholeRangeTest : public PluginTest {
 protected:
  // From MuJoCo's bodies.
  [[nodiscard]] ArmAngles Reached() const {
    const auto rotation = [&](const char* body) -> Quaternion {
      const mjtNum* q = data_->xquat + 4 * mj_name2id(model_.get(), mjOBJ_BODY, body);
      return {q[0], q[1], q[2], q[3]};
    };
    return ArmAnglesFromRotation(glm::conjugate(rotation("thorax")) * rotation("humerus_r"));
  }
};

TEST_F(WholeRangeTest, TheArmStandsWhereItIsToldToEverywhere) {
  constexpr double kExact_deg = 1e-6;
  constexpr int kSteps = 3;
  const ShoulderRhythm rhythm = BuiltInRhythm();
  double worst_deg = 0;
  int poses = 0;
  for (int elevation_deg = 0; elevation_deg <= 180; ++elevation_deg) {
    for (int plane_deg = -95; plane_deg <= 135; ++plane_deg) {
      const ArmCommand command{RadiansFromDegrees(elevation_deg), RadiansFromDegrees(plane_deg)};
      if (command.plane_rad < rhythm.LowestPlaneAt(command.elevation_rad)) {
        continue;
      }
      SetCommand(command);
      PutAt(TargetsOf(rhythm, command));
      std::fill_n(data_->qacc_warmstart, model_->nv, 0);
      for (int step = 0; step < kSteps; ++step) {
        mj_step(model_.get(), data_.get());
      }
      mj_kinematics(model_.get(), data_.get());
      const ArmAngles reached = Reached();
      const double elevation_off_deg =
          DegreesFromRadians(std::abs(reached.elevation_rad - command.elevation_rad));
      const bool has_plane = elevation_deg > 0 && elevation_deg < 180;
      const double plane_off_deg = has_plane ? DegreesFromRadians(std::abs(std::remainder(
                                                   reached.plane_rad - command.plane_rad, 2 * kPi)))
                                             : 0;
      ASSERT_LT(elevation_off_deg, kExact_deg)
          << "elevation " << elevation_deg << ", plane " << plane_deg;
      ASSERT_LT(plane_off_deg, kExact_deg)
          << "elevation " << elevation_deg << ", plane " << plane_deg;
      worst_deg = std::max({worst_deg, elevation_off_deg, plane_off_deg});
      ++poses;
    }
  }
  EXPECT_GT(poses, 30000);
  RecordProperty("poses", poses);
  RecordProperty("worst_deg", std::to_string(worst_deg * 1e12) + "e-12");
}

}  // namespace
}  // namespace girdle::whole_range_test
