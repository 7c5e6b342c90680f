// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The plugin's sensor in every way that MuJoCo comes by it, and its derivatives.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/gtc/quaternion.hpp>
#include <random>
#include <string>
#include <vector>

#include "rhythm_tables/built_in_tables.h"
#include "simulation/plugin_fixture.h"

namespace girdle::plugin_sensor_test {
namespace {

constexpr const char* kSensor = "<plugin name=\"rhythm_r\" instance=\"rhythm_r\"/>";

Quaternion BodyRotation(const mjModel& model, const mjData& data, const char* body) {
  const mjtNum* q = data.xquat + 4 * mj_name2id(&model, mjOBJ_BODY, body);
  return {q[0], q[1], q[2], q[3]};
}

class SensorTest : public FullPluginTest {
 protected:
  // What the sensor is to hold, without the plugin: commands by the rhythm, the arm by MuJoCo's
  // bodies.
  [[nodiscard]] std::vector<double> Expected() const {
    const ShoulderSolution solution = rhythm_.Solve(CommandRead());
    const JointAngles target_rad = AnglesFromPose(solution.pose);
    const ArmAngles reached =
        ArmAnglesFromRotation(glm::conjugate(BodyRotation(*model_, *data_, "thorax")) *
                              BodyRotation(*model_, *data_, "humerus_r"));
    std::vector<double> values = {solution.used.elevation_rad, solution.used.plane_rad,
                                  solution.used.axial_rad, reached.elevation_rad,
                                  reached.plane_rad};
    values.push_back(solution.used.axial_rad -
                     (target_rad[kGhAxialIndex] - data_->qpos[kGhAxialIndex]));
    values.insert(values.end(), target_rad.begin(), target_rad.end());
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      values.push_back(target_rad[k] - data_->qpos[k]);
    }
    values.push_back(solution.distance_rad);
    // Third angles of Y-X'-Y'', of where the command leads and of where the arm is.
    values.push_back(ArmAnglesFromRotation(solution.pose.q_TH()).axial_rad);
    values.push_back(reached.axial_rad);
    return values;
  }

  void ExpectSensor(const std::string& when) const {
    const std::vector<double> expected = Expected();
    ASSERT_EQ(static_cast<std::size_t>(model_->nsensordata), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      // The same formulas on the same numbers; the commanded third angle by another one.
      EXPECT_NEAR(data_->sensordata[i], expected[i],
                  i == sensor_layout::kCommandedIsb ? 1e-11 : 1e-14)
          << when << ", value " << i;
    }
  }

  const ShoulderRhythm rhythm_ = BuiltInRhythm();
};

TEST_F(SensorTest, ShowsTheCommandsThatWereForwarded) {
  std::mt19937 random(11);
  for (int sample = 0; sample < 50; ++sample) {
    Randomise(random);
    mj_forward(model_.get(), data_.get());
    ExpectSensor("sample " + std::to_string(sample));
  }
}

TEST_F(SensorTest, ShowsAChangeOfTheControlsAlone) {
  std::mt19937 random(12);
  Randomise(random);
  mj_forward(model_.get(), data_.get());
  for (int control = 0; control < static_cast<int>(kCommandCount + kOffsetCount); ++control) {
    data_->ctrl[control] += 0.01;
    mj_forwardSkip(model_.get(), data_.get(), mjSTAGE_VEL, 0);
    ExpectSensor(std::string(kAllCommandNames[control]));
  }
}

// Distance is that of the control itself, and may change while the pose does not.
// Also at the controls that a model begins with.
TEST_F(SensorTest, ShowsTheSameAfterOtherCommandsAsBefore) {
  const ModelPointer model = LoadedModel(ShoulderXml({}, kAsPublished));
  const DataPointer data = MakeData(*model);
  const auto sensed = [&](double elevation_rad) {
    data->ctrl[0] = elevation_rad;
    mj_forward(model.get(), data.get());
    return std::vector<double>(data->sensordata, data->sensordata + model->nsensordata);
  };
  const std::vector<double> first = sensed(0);
  static_cast<void>(sensed(1));
  EXPECT_EQ(sensed(0), first);
}

TEST_F(SensorTest, ShowsAChangeOfTheDistanceAlone) {
  SetCommand({RadiansFromDegrees(90), RadiansFromDegrees(-40)});
  mj_forward(model_.get(), data_.get());
  const double before_rad = data_->sensordata[sensor_layout::kDistance];
  data_->ctrl[1] = RadiansFromDegrees(-45);
  mj_forwardSkip(model_.get(), data_.get(), mjSTAGE_VEL, 0);
  EXPECT_NEAR(data_->sensordata[sensor_layout::kDistance] - before_rad, RadiansFromDegrees(5),
              1e-12);
}

TEST_F(SensorTest, ShowsControlsThatAreSetBetweenTheHalvesOfAStep) {
  std::mt19937 random(13);
  Randomise(random);
  for (int step = 0; step < 20; ++step) {
    mj_step1(model_.get(), data_.get());
    data_->ctrl[0] += RadiansFromDegrees(0.5);
    data_->ctrl[1] -= RadiansFromDegrees(0.5);
    // The second half moves the joints: what it is to show belongs to where they were.
    const std::vector<double> expected = Expected();
    mj_step2(model_.get(), data_.get());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_NEAR(data_->sensordata[i], expected[i], 1e-14) << "step " << step << ", value " << i;
    }
  }
}

TEST_F(SensorTest, IsLeftAloneWhereSensorsAreDisabled) {
  std::mt19937 random(14);
  Randomise(random);
  mj_forward(model_.get(), data_.get());
  const std::vector<mjtNum> before = SensorValues();
  model_->opt.disableflags |= mjDSBL_SENSOR;
  data_->ctrl[0] += 0.1;
  mj_forward(model_.get(), data_.get());
  mj_forwardSkip(model_.get(), data_.get(), mjSTAGE_VEL, 0);
  EXPECT_EQ(SensorValues(), before);
}

// Of the sensors' derivatives by the controls. Central differences have it wrong in MuJoCo before
// 4, of native sensors too; one-sided ones and all other derivatives are right in both.
constexpr double kSignOfMujoco = mjVERSION_HEADER < 4000000 ? -1 : 1;

TEST_F(SensorTest, DerivativesAreThoseOfWholeStepsForAllControls) {
  const int controls = static_cast<int>(model_->nu);
  const int values = static_cast<int>(model_->nsensordata);
  const DataPointer moved = MakeData(*model_);
  constexpr double kNudge = 1e-5;
  std::mt19937 random(15);
  for (int sample = 0; sample < 5; ++sample) {
    Randomise(random);
    mj_forward(model_.get(), data_.get());
    std::vector<mjtNum> D(static_cast<std::size_t>(values * controls));
    mjd_transitionFD(model_.get(), data_.get(), 1e-6, true, nullptr, nullptr, nullptr, D.data());
    for (int control = 0; control < controls; ++control) {
      std::vector<double> expected(static_cast<std::size_t>(values));
      for (const double sign : {1.0, -1.0}) {
        mj_copyData(moved.get(), model_.get(), data_.get());
        moved->ctrl[control] += sign * kNudge;
        mj_step(model_.get(), moved.get());
        for (int i = 0; i < values; ++i) {
          expected[i] += sign * moved->sensordata[i] / (2 * kNudge);
        }
      }
      for (int i = 0; i < values; ++i) {
        // Central differences of two widths, over a curve whose third derivatives are below 1e4.
        EXPECT_NEAR(kSignOfMujoco * D[i * controls + control], expected[i], 1e-6)
            << "sample " << sample << ", control " << control << ", value " << i;
      }
    }
  }
}

// One sensor alone, and the same two beside each other.
class CutSensorTest : public SensorTest, public testing::WithParamInterface<const char*> {
 protected:
  static constexpr double kCutoff = 0.3;

  CutSensorTest() {
    model_ = LoadedModel(Replaced(FullShoulderXml(), kSensor, GetParam()));
    data_ = MakeData(*model_);
    cut_ = model_->sensor_adr[mj_name2id(model_.get(), mjOBJ_SENSOR, "cut")];
  }

  void ExpectCutSensor(const std::vector<double>& expected, const std::string& when) const {
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_NEAR(data_->sensordata[cut_ + static_cast<int>(i)],
                  std::clamp(expected[i], -kCutoff, kCutoff), 1e-14)
          << when << ", value " << i;
    }
  }

  int cut_ = 0;
};

TEST_P(CutSensorTest, IsCutHoweverItIsWritten) {
  std::mt19937 random(16);
  for (int sample = 0; sample < 20; ++sample) {
    const std::string name = "sample " + std::to_string(sample);
    Randomise(random);
    mj_forward(model_.get(), data_.get());
    ExpectCutSensor(Expected(), name + ", forward");
    // Around the cutoff itself, too.
    SetCommand({Draw(random, 0.2, 0.4), Draw(random, -0.4, 0.4), Draw(random, -0.3, 0.3)});
    mj_forwardSkip(model_.get(), data_.get(), mjSTAGE_VEL, 0);
    ExpectCutSensor(Expected(), name + ", controls alone");
    mj_step1(model_.get(), data_.get());
    data_->ctrl[0] += 0.5;
    const std::vector<double> expected = Expected();
    mj_step2(model_.get(), data_.get());
    ExpectCutSensor(expected, name + ", between the halves of a step");
  }
}

INSTANTIATE_TEST_SUITE_P(
    Alone, CutSensorTest,
    testing::Values("<plugin name=\"cut\" instance=\"rhythm_r\" cutoff=\"0.3\"/>"));
INSTANTIATE_TEST_SUITE_P(
    BesideOneThatIsNot, CutSensorTest,
    testing::Values("<plugin name=\"cut\" instance=\"rhythm_r\" cutoff=\"0.3\"/>"
                    "<plugin name=\"rhythm_r\" instance=\"rhythm_r\"/>",
                    "<plugin name=\"rhythm_r\" instance=\"rhythm_r\"/>"
                    "<plugin name=\"cut\" instance=\"rhythm_r\" cutoff=\"0.3\"/>"));

}  // namespace
}  // namespace girdle::plugin_sensor_test
