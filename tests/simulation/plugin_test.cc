// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The engine plugin, loaded by MuJoCo, against the inverse kinematics and against native servos.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "kinematics/model_names.h"
#include "mjcf/joint_dynamics.h"
#include "mjcf/shoulder_model.h"
#include "simulation/engine_fixture.h"
#include "tables/built_in.h"
#include "tables/input_error.h"

namespace girdle {
namespace {

constexpr int kControls = kCommandCount + kCoordinateCount;
constexpr int kPositions = kCoordinateCount;

std::string ShoulderXml(Actuation actuation = Actuation::kPlugin,
                        Interpolation interpolation = Interpolation::kSquad) {
  return ShoulderModelXml(BuiltInAnatomy(),
                          ShoulderRhythm(BuiltInRhythmTable(), {interpolation, Closure::kTable}),
                          {.actuation = actuation});
}

ModelPointer LoadedModel(const std::string& xml) { return LoadModel({{"shoulder.xml", xml}}); }

// A copy of `text` with the first `from` replaced; a test that looks for what is not there must
// fail.
std::string Replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) {
    throw std::logic_error("the model does not hold: " + from);
  }
  return text.replace(at, from.size(), to);
}

class PluginTest : public EngineTest {
 protected:
  explicit PluginTest(const std::string& xml = ShoulderXml())
      : model_(LoadedModel(xml)), data_(MakeData(*model_)) {}

  // Nine servos' outputs follow the three commands'.
  [[nodiscard]] const mjtNum* forces() const { return data_->actuator_force + kCommandCount; }

  // Commands within the measured domain, trims and joint positions around the targets.
  void Randomise(std::mt19937& random) {
    const auto draw = [&random](double lower, double upper) {
      return std::uniform_real_distribution(lower, upper)(random);
    };
    data_->ctrl[0] = RadiansFromDegrees(draw(15, 120));
    data_->ctrl[1] = RadiansFromDegrees(draw(0, 90));
    data_->ctrl[2] = RadiansFromDegrees(draw(-30, 30));
    for (int k = 0; k < kPositions; ++k) {
      data_->ctrl[kCommandCount + k] = draw(-0.3, 0.3);
      data_->qpos[k] = model_->qpos0[k] + draw(-0.05, 0.05);
      data_->qvel[k] = draw(-0.5, 0.5);
    }
  }

  ModelPointer model_;
  DataPointer data_;
};

TEST_F(PluginTest, ForceIsStiffnessTimesTargetPlusTrimMinusPosition) {
  const ShoulderRhythm rhythm(BuiltInRhythmTable());
  std::mt19937 random(1);
  for (int sample = 0; sample < 200; ++sample) {
    Randomise(random);
    mj_forward(model_.get(), data_.get());
    const JointAngles target_rad =
        AnglesFromPose(rhythm.Solve({data_->ctrl[0], data_->ctrl[1], data_->ctrl[2]}).pose);
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      const double expected = kJointDynamics[k / 3].stiffness_N_m_per_rad *
                              (target_rad[k] + data_->ctrl[kCommandCount + k] - data_->qpos[k]);
      // One rounding of a torque of some hundred newton meters.
      EXPECT_NEAR(forces()[k], expected, 1e-10)
          << "sample " << sample << ", " << kCoordinateNames[k];
    }
  }
}

TEST_F(PluginTest, CommandActuatorsExertNoForce) {
  std::mt19937 random(2);
  Randomise(random);
  mj_forward(model_.get(), data_.get());
  for (std::size_t i = 0; i < kCommandCount; ++i) {
    EXPECT_EQ(data_->actuator_force[i], 0) << kCommandNames[i];
  }
}

TEST_F(PluginTest, MovesAsNativePositionServosAtTheSameTargets) {
  const ModelPointer native = LoadedModel(ShoulderXml(Actuation::kPosition));
  const DataPointer native_data = MakeData(*native);
  const ShoulderRhythm rhythm(BuiltInRhythmTable());
  constexpr int kSteps = 2000;
  for (int step = 0; step < kSteps; ++step) {
    const double share = static_cast<double>(step) / kSteps;
    const ArmCommand command{RadiansFromDegrees(15 + 105 * share),
                             RadiansFromDegrees(45 - 45 * std::cos(9 * share)),
                             0.3 * std::sin(20 * share)};
    data_->ctrl[0] = command.elevation_rad;
    data_->ctrl[1] = command.plane_rad;
    data_->ctrl[2] = command.axial_rad;
    const JointAngles target_rad = AnglesFromPose(rhythm.Solve(command).pose);
    std::copy(target_rad.begin(), target_rad.end(), native_data->ctrl);
    mj_step(model_.get(), data_.get());
    mj_step(native.get(), native_data.get());
    for (int k = 0; k < kPositions; ++k) {
      // kp (target - q) and kp target - kp q round differently; nothing may grow from it.
      ASSERT_NEAR(data_->qpos[k], native_data->qpos[k], 1e-11)
          << kCoordinateNames[k] << " at step " << step;
    }
  }
}

// Change of the next state per change of a control, from whole steps, central differences.
std::vector<double> StepDifference(const mjModel& model, const mjData& data, int control) {
  constexpr double kNudge = 1e-5;
  const DataPointer moved = MakeData(model);
  std::vector<double> difference(2 * kPositions);
  for (const double sign : {1.0, -1.0}) {
    mj_copyData(moved.get(), &model, &data);
    moved->ctrl[control] += sign * kNudge;
    mj_step(&model, moved.get());
    for (int k = 0; k < kPositions; ++k) {
      difference[k] += sign * moved->qpos[k] / (2 * kNudge);
      difference[kPositions + k] += sign * moved->qvel[k] / (2 * kNudge);
    }
  }
  return difference;
}

TEST_F(PluginTest, TransitionDerivativesAreThoseOfWholeStepsForAllControls) {
  std::mt19937 random(3);
  for (int sample = 0; sample < 5; ++sample) {
    Randomise(random);
    mj_forward(model_.get(), data_.get());
    std::vector<mjtNum> B(2 * kPositions * kControls);
    mjd_transitionFD(model_.get(), data_.get(), 1e-6, true, nullptr, B.data(), nullptr, nullptr);
    for (int control = 0; control < kControls; ++control) {
      const std::vector<double> expected = StepDifference(*model_, *data_, control);
      double largest = 0;
      for (const double entry : expected) {
        largest = std::max(largest, std::abs(entry));
      }
      ASSERT_GT(largest, 0.01) << "control " << control << " moves nothing";
      for (int row = 0; row < 2 * kPositions; ++row) {
        EXPECT_NEAR(B[row * kControls + control], expected[row], 1e-4 * largest)
            << "sample " << sample << ", control " << control << ", row " << row;
      }
    }
  }
}

TEST_F(PluginTest, SensorDerivativesAreThoseOfTheTargets) {
  const ShoulderRhythm rhythm(BuiltInRhythmTable());
  std::mt19937 random(4);
  Randomise(random);
  mj_forward(model_.get(), data_.get());
  std::vector<mjtNum> D(model_->nsensordata * kControls);
  mjd_transitionFD(model_.get(), data_.get(), 1e-6, true, nullptr, nullptr, nullptr, D.data());
  constexpr double kNudge = 1e-5;
  const auto targets = [&](double elevation_rad) {
    return AnglesFromPose(rhythm.Solve({elevation_rad, data_->ctrl[1], data_->ctrl[2]}).pose);
  };
  const JointAngles above = targets(data_->ctrl[0] + kNudge);
  const JointAngles below = targets(data_->ctrl[0] - kNudge);
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    // Two central differences of different width, over a curve whose third derivative is below 100.
    EXPECT_NEAR(D[(sensor_layout::kTarget + k) * kControls], (above[k] - below[k]) / (2 * kNudge),
                1e-6)
        << kCoordinateNames[k];
  }
}

TEST_F(PluginTest, SensorReportsWhatTheBodiesDo) {
  const ShoulderRhythm rhythm(BuiltInRhythmTable());
  const ArmCommand command{RadiansFromDegrees(70), RadiansFromDegrees(30), 0.2};
  const ShoulderPose pose = rhythm.Solve(command).pose;
  const JointAngles angles_rad = AnglesFromPose(pose);
  data_->ctrl[0] = command.elevation_rad;
  data_->ctrl[1] = command.plane_rad;
  data_->ctrl[2] = command.axial_rad;
  std::copy(angles_rad.begin(), angles_rad.end(), data_->qpos);
  data_->qpos[kGhAxialIndex] -= 0.125;
  mj_forward(model_.get(), data_.get());
  const mjtNum* values = data_->sensordata;
  const ArmAngles arm = ArmAnglesFromRotation(pose.q_TH());
  constexpr double kRounding_rad = 1e-12;
  EXPECT_EQ(values[sensor_layout::kCommanded], command.elevation_rad);
  EXPECT_EQ(values[sensor_layout::kCommanded + 1], command.plane_rad);
  EXPECT_EQ(values[sensor_layout::kCommanded + 2], command.axial_rad);
  EXPECT_NEAR(values[sensor_layout::kReached], arm.elevation_rad, kRounding_rad);
  EXPECT_NEAR(values[sensor_layout::kReached + 1], arm.plane_rad, kRounding_rad);
  EXPECT_NEAR(values[sensor_layout::kReached + 2], command.axial_rad - 0.125, kRounding_rad);
  EXPECT_NEAR(values[sensor_layout::kError + kGhAxialIndex], 0.125, kRounding_rad);
  EXPECT_EQ(values[sensor_layout::kDistance], 0);
}

TEST_F(PluginTest, CommandsOutsideTheTableAreClampedAndTheirDistanceIsReported) {
  data_->ctrl[0] = RadiansFromDegrees(123);
  data_->ctrl[1] = RadiansFromDegrees(94);
  mj_forward(model_.get(), data_.get());
  const ShoulderRhythm rhythm(BuiltInRhythmTable());
  const JointAngles corner =
      AnglesFromPose(rhythm.Solve({RadiansFromDegrees(120), RadiansFromDegrees(90), 0}).pose);
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    EXPECT_EQ(data_->sensordata[sensor_layout::kTarget + k], corner[k]) << kCoordinateNames[k];
  }
  // 3 and 4 degrees outside: 5 by Pythagoras.
  EXPECT_NEAR(data_->sensordata[sensor_layout::kDistance], RadiansFromDegrees(5), 1e-12);
}

TEST_F(PluginTest, ControlsThatAreNotFiniteCountAsZero) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  mj_forward(model_.get(), data_.get());
  const std::vector<mjtNum> zero_forces(forces(), forces() + kCoordinateCount);
  const std::vector<mjtNum> zero_sensor(data_->sensordata, data_->sensordata + model_->nsensordata);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), kInfinity, -kInfinity}) {
    for (int control = 0; control < kControls; ++control) {
      mj_resetData(model_.get(), data_.get());
      data_->ctrl[control] = bad;
      mj_forward(model_.get(), data_.get());
      EXPECT_EQ(std::vector(forces(), forces() + kCoordinateCount), zero_forces)
          << bad << " in control " << control;
      EXPECT_EQ(std::vector(data_->sensordata, data_->sensordata + model_->nsensordata),
                zero_sensor)
          << bad << " in control " << control;
    }
  }
  // MuJoCo itself complains of such controls, and is meant to.
  EXPECT_THROW(EngineWatch::ExpectNoWarning("controls that are not finite"), InputError);
}

TEST_F(PluginTest, HeedsControlRangesAsTheModelHasThemNow) {
  data_->ctrl[kCommandCount] = 5;  // a trim far beyond its range
  mj_forward(model_.get(), data_.get());
  const double limited = forces()[0];
  model_->opt.disableflags |= mjDSBL_CLAMPCTRL;
  mj_forward(model_.get(), data_.get());
  const double stiffness = kJointDynamics[0].stiffness_N_m_per_rad;
  EXPECT_NEAR(forces()[0] - limited,
              stiffness * (5 - model_->actuator_ctrlrange[2 * kCommandCount + 1]), 1e-9);
  model_->opt.disableflags = 0;
  model_->actuator_ctrllimited[kCommandCount] = false;
  mj_forward(model_.get(), data_.get());
  EXPECT_NEAR(forces()[0], stiffness * 5, 1e-9);
}

TEST_F(PluginTest, TwoStatesOfOneModelDoNotDisturbEachOther) {
  const DataPointer other = MakeData(*model_);
  const DataPointer alone = MakeData(*model_);
  for (int step = 0; step < 300; ++step) {
    data_->ctrl[0] = alone->ctrl[0] = RadiansFromDegrees(15 + 0.3 * step);
    other->ctrl[0] = RadiansFromDegrees(120 - 0.3 * step);
    other->ctrl[1] = RadiansFromDegrees(0.3 * step);
    mj_step(model_.get(), data_.get());
    mj_step(model_.get(), other.get());
  }
  for (int step = 0; step < 300; ++step) {
    alone->ctrl[0] = RadiansFromDegrees(15 + 0.3 * step);
    mj_step(model_.get(), alone.get());
  }
  for (int k = 0; k < kPositions; ++k) {
    EXPECT_EQ(data_->qpos[k], alone->qpos[k]) << kCoordinateNames[k];
  }
}

TEST_F(PluginTest, CopiedAndResetStatesGoOnAsTheOriginal) {
  for (int step = 0; step < 100; ++step) {
    data_->ctrl[0] = RadiansFromDegrees(15 + step);
    mj_step(model_.get(), data_.get());
  }
  const DataPointer made(mj_copyData(nullptr, model_.get(), data_.get()));
  const DataPointer reused = MakeData(*model_);
  mj_copyData(reused.get(), model_.get(), data_.get());
  for (mjData* data : {data_.get(), made.get(), reused.get()}) {
    for (int step = 0; step < 100; ++step) {
      mj_step(model_.get(), data);
    }
  }
  for (int k = 0; k < kPositions; ++k) {
    EXPECT_EQ(made->qpos[k], data_->qpos[k]) << kCoordinateNames[k];
    EXPECT_EQ(reused->qpos[k], data_->qpos[k]) << kCoordinateNames[k];
  }
  mj_resetData(model_.get(), data_.get());
  const DataPointer fresh = MakeData(*model_);
  for (mjData* data : {data_.get(), fresh.get()}) {
    data->ctrl[0] = RadiansFromDegrees(50);
    mj_step(model_.get(), data);
  }
  for (int k = 0; k < kPositions; ++k) {
    EXPECT_EQ(data_->qpos[k], fresh->qpos[k]) << kCoordinateNames[k];
  }
}

TEST_F(PluginTest, ResetModelStandsStill) {
  for (int step = 0; step < 500; ++step) {
    mj_step(model_.get(), data_.get());
  }
  for (int k = 0; k < kPositions; ++k) {
    // Gravity is compensated and targets are where the joints stand: only rounding moves them.
    EXPECT_NEAR(data_->qpos[k], model_->qpos0[k], 1e-12) << kCoordinateNames[k];
  }
}

TEST_F(PluginTest, KeepsNoStateInTheModelsState) { EXPECT_EQ(model_->npluginstate, 0); }

TEST_F(PluginTest, FollowsTheInterpolationOfItsConfiguration) {
  const ModelPointer slerp = LoadedModel(ShoulderXml(Actuation::kPlugin, Interpolation::kSlerp));
  const DataPointer slerp_data = MakeData(*slerp);
  const ArmCommand command{RadiansFromDegrees(22.5), RadiansFromDegrees(20), 0};
  for (mjData* data : {data_.get(), slerp_data.get()}) {
    data->ctrl[0] = command.elevation_rad;
    data->ctrl[1] = command.plane_rad;
  }
  mj_forward(slerp.get(), slerp_data.get());
  const JointAngles expected =
      AnglesFromPose(ShoulderRhythm(BuiltInRhythmTable(), {Interpolation::kSlerp, Closure::kTable})
                         .Solve(command)
                         .pose);
  mj_forward(model_.get(), data_.get());
  double largest_difference = 0;
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    const double target = slerp_data->sensordata[sensor_layout::kTarget + k];
    EXPECT_EQ(target, expected[k]) << kCoordinateNames[k];
    largest_difference = std::max(largest_difference,
                                  std::abs(target - data_->sensordata[sensor_layout::kTarget + k]));
  }
  EXPECT_GT(largest_difference, RadiansFromDegrees(0.01)) << "slerp and squad are the same";
}

TEST_F(PluginTest, WorksAttachedWithAPrefixThatLooksLikeARole) {
  std::array<char, 1000> error{};
  mjSpec* child = mj_parseXMLString(ShoulderXml().c_str(), nullptr, error.data(), error.size());
  ASSERT_NE(child, nullptr) << error.data();
  mjSpec* parent = mj_makeSpec();
  parent->option.timestep = child->option.timestep;
  parent->option.integrator = child->option.integrator;
  mjsFrame* frame = mjs_addFrame(mjs_findBody(parent, "world"), nullptr);
  mjs_attach(frame->element, mjs_findBody(child, "thorax")->element, "plane_gh_axial_", "");
  const ModelPointer attached(mj_compile(parent, nullptr));
  ASSERT_NE(attached, nullptr) << mjs_getError(parent);
  const DataPointer attached_data = MakeData(*attached);
  ASSERT_EQ(attached->nu, model_->nu);
  data_->ctrl[0] = attached_data->ctrl[0] = 1;
  data_->ctrl[1] = attached_data->ctrl[1] = 0.5;
  mj_forward(model_.get(), data_.get());
  mj_forward(attached.get(), attached_data.get());
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    EXPECT_EQ(attached_data->actuator_force[kCommandCount + k], forces()[k]) << kCoordinateNames[k];
  }
  mj_deleteSpec(parent);
  mj_deleteSpec(child);
}

// A model that the plugin refuses: one thing changed, and what the message says of it.
struct BadModel {
  const char* name;
  const char* from;
  const char* to;
  const char* message;
};

class PluginRefusal : public EngineTest, public testing::WithParamInterface<BadModel> {};

TEST_P(PluginRefusal, NamesTheInstanceAndTheFix) {
  const BadModel& bad = GetParam();
  try {
    (void)LoadedModel(Replaced(ShoulderXml(), bad.from, bad.to));
    FAIL() << "loaded";
  } catch (const InputError& error) {
    const std::string reason = error.what();
    EXPECT_NE(reason.find("girdle.rhythm instance \"rhythm_r\""), std::string::npos) << reason;
    EXPECT_NE(reason.find(bad.message), std::string::npos) << reason;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Models, PluginRefusal,
    testing::Values(
        BadModel{"UnknownInterpolation", "value=\"squad\"", "value=\"cubic\"",
                 "interpolation is \"cubic\", expected \"squad\" or \"slerp\""},
        BadModel{"UnknownClosure", "key=\"closure\" value=\"table\"",
                 "key=\"closure\" value=\"open\"", "closure is \"open\", expected \"table\""},
        BadModel{"StiffnessOfTwoNumbers", "key=\"kp\" value=\"1500 1500", "key=\"kp\" value=\"1500",
                 "kp is"},
        BadModel{"NegativeStiffness", "key=\"kp\" value=\"1500", "key=\"kp\" value=\"-1500",
                 "expected one positive number"},
        BadModel{"BrokenTable", "<config key=\"closure\"",
                 "<config key=\"table\" value=\"plane_deg;0\"/><config key=\"closure\"",
                 "column 'elevation_deg' is missing"},
        BadModel{"NoElevationCommand",
                 "<plugin name=\"elevation_r\" joint=\"gh_axial_r\" instance=\"rhythm_r\" "
                 "gear=\"0\"",
                 "<motor name=\"elevation_r\" joint=\"gh_axial_r\" gear=\"0\"",
                 "no command actuator for elevation. Add <plugin name=\"elevation_r\""},
        BadModel{"TwoElevationCommands", "<plugin name=\"plane_r\"",
                 "<plugin name=\"second_elevation_r\" joint=\"gh_axial_r\" instance=\"rhythm_r\" "
                 "gear=\"0\"/><plugin name=\"plane_r\"",
                 "is a second command actuator (gear 0) for elevation. Remove one"},
        BadModel{"NoServoForAHinge",
                 "<plugin name=\"ac_tilt_r\" joint=\"ac_tilt_r\" instance=\"rhythm_r\"",
                 "<motor name=\"ac_tilt_r\" joint=\"ac_tilt_r\"",
                 "no servo for ac_tilt. Add <plugin name=\"ac_tilt_r\""},
        BadModel{"TwoServosForAHinge", "<plugin name=\"ac_tilt_r\"",
                 "<plugin name=\"second_gh_axial_r\" joint=\"gh_axial_r\" instance=\"rhythm_r\"/>"
                 "<plugin name=\"ac_tilt_r\"",
                 "is a second servo for gh_axial"},
        BadModel{"UnknownServo", "<plugin name=\"ac_tilt_r\"",
                 "<plugin name=\"knee\" joint=\"ac_tilt_r\" instance=\"rhythm_r\"/>"
                 "<plugin name=\"ac_tilt_r\"",
                 "actuator \"knee\" is a servo, but its name has none of:"},
        BadModel{"ServoWithGear", "joint=\"ac_tilt_r\" instance=\"rhythm_r\"",
                 "joint=\"ac_tilt_r\" gear=\"2\" instance=\"rhythm_r\"",
                 "actuator \"ac_tilt_r\" has gear 2"},
        BadModel{"ServoOnASite", "joint=\"ac_tilt_r\" instance=\"rhythm_r\"",
                 "site=\"TS_r\" instance=\"rhythm_r\"",
                 "actuator \"ac_tilt_r\" does not act on a hinge"}),
    [](const auto& parameter) { return parameter.param.name; });

TEST_F(PluginTest, UnknownConfigurationIsRefusedByMuJoCo) {
  try {
    (void)LoadedModel(Replaced(ShoulderXml(), "key=\"kp\"", "key=\"stiffness\""));
    FAIL() << "loaded";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("unrecognized attribute"), std::string::npos)
        << error.what();
  }
}

TEST_F(EngineTest, PluginForAnotherVersionSaysSoAndHowToMendIt) {
  try {
    LoadPlugin(GIRDLE_BINARY_DIR "/tests/libgirdle_rhythm_3_17_0.so");
    FAIL() << "loaded";
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("is built for MuJoCo 3.17.0, this process runs " +
                           std::string(mj_versionString())),
              std::string::npos)
        << message;
    EXPECT_NE(message.find("Run MuJoCo 3.17.0, or build Girdle with MUJOCO_ROOT"),
              std::string::npos)
        << message;
  }
}

}  // namespace
}  // namespace girdle
