// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The engine plugin, loaded by MuJoCo, against the inverse kinematics and against native servos.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "names/joint_dynamics.h"
#include "names/model_names.h"
#include "rhythm_tables/built_in_tables.h"
#include "simulation/plugin_fixture.h"
#include "text/input_error.h"

namespace girdle::plugin_test {
namespace {

TEST_F(FullPluginTest, ForceIsStiffnessTimesTargetPlusTrimMinusPosition) {
  const ShoulderRhythm rhythm = BuiltInRhythm();
  std::mt19937 random(1);
  int clamped = 0;
  for (int sample = 0; sample < 500; ++sample) {
    // Beyond all ranges, too: of the controls, of what an arm reaches, and of the hinges.
    SetCommand({DrawDegrees(random, -30, 210), DrawDegrees(random, -90, 160),
                DrawDegrees(random, -120, 120), DrawDegrees(random, -40, 60),
                DrawDegrees(random, -40, 60)});
    RandomisePositions(random);
    mj_forward(model_.get(), data_.get());
    const ShoulderSolution solution = rhythm.Solve(CommandRead());
    clamped += solution.clamped ? 1 : 0;
    const JointAngles target_rad = AnglesFromPose(solution.pose);
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      const double expected = kJointDynamics[k / 3].stiffness_N_m_per_rad *
                              (target_rad[k] + trims()[k] - data_->qpos[k]);
      // One rounding of a torque of some thousand newton meters.
      EXPECT_NEAR(forces()[k], expected, 1e-9)
          << "sample " << sample << ", " << kCoordinateNames[k];
    }
    const mjtNum* values = data_->sensordata;
    EXPECT_EQ(values[sensor_layout::kCommanded], solution.used.elevation_rad);
    EXPECT_EQ(values[sensor_layout::kCommanded + 1], solution.used.plane_rad);
    EXPECT_EQ(values[sensor_layout::kCommanded + 2], solution.used.axial_rad);
    EXPECT_TRUE(std::equal(target_rad.begin(), target_rad.end(), values + sensor_layout::kTarget))
        << "sample " << sample;
  }
  EXPECT_GT(clamped, 100) << "the samples do not reach the hinges' ends";
}

TEST_F(FullPluginTest, OffsetsMoveTheClavicleAndLeaveTheArmItsDirection) {
  const ShoulderRhythm rhythm = BuiltInRhythm();
  const ArmCommand plain{RadiansFromDegrees(70), RadiansFromDegrees(40)};
  ArmCommand offset = plain;
  offset.shrug_rad = RadiansFromDegrees(8);
  offset.protraction_rad = RadiansFromDegrees(6);
  SetCommand(offset);
  mj_forward(model_.get(), data_.get());
  const mjtNum* target_rad = data_->sensordata + sensor_layout::kTarget;
  const JointAngles without_rad = TargetsOf(rhythm, plain);
  constexpr double kRounding_rad = 1e-12;
  // Protraction is +, elevation of the clavicle is -.
  EXPECT_NEAR(target_rad[0], without_rad[0] + offset.protraction_rad, kRounding_rad);
  EXPECT_NEAR(target_rad[1], without_rad[1] - offset.shrug_rad, kRounding_rad);
  for (const std::size_t k : {2, 3, 4, 5}) {
    EXPECT_NEAR(target_rad[k], without_rad[k], kRounding_rad) << kCoordinateNames[k];
  }
  std::copy_n(target_rad, kPositions, data_->qpos);
  mj_forward(model_.get(), data_.get());
  EXPECT_NEAR(data_->sensordata[sensor_layout::kReached], plain.elevation_rad, kRounding_rad);
  EXPECT_NEAR(data_->sensordata[sensor_layout::kReached + 1], plain.plane_rad, kRounding_rad);
}

TEST_F(FullPluginTest, OffsetsEndAtTheHingesRanges) {
  const int joint = mj_name2id(model_.get(), mjOBJ_JOINT, "sc_elevation_r");
  // The clavicle is raised by the arm already; a shrug as far as its control goes is too much.
  SetCommand({RadiansFromDegrees(150), RadiansFromDegrees(40), 0, RadiansFromDegrees(35)});
  mj_forward(model_.get(), data_.get());
  EXPECT_DOUBLE_EQ(data_->sensordata[sensor_layout::kTarget + 1], model_->jnt_range[2 * joint]);
}

TEST_F(PluginTest, AnAxialTurnEndsAtTheHingesRange) {
  const ShoulderRhythm rhythm = BuiltInRhythm();
  const int joint = mj_name2id(model_.get(), mjOBJ_JOINT, "gh_axial_r");
  const mjtNum* range_rad = model_->jnt_range + 2 * joint;
  // At the ends of its control, which are made for the measured positions, behind the body and
  // across the chest.
  int bounded = 0;
  for (const double plane_deg : {-55.0, 130.0}) {
    for (const int end : {0, 1}) {
      const ArmCommand command{RadiansFromDegrees(50), RadiansFromDegrees(plane_deg),
                               model_->actuator_ctrlrange[2 * 2 + end]};
      SetCommand(command);
      mj_forward(model_.get(), data_.get());
      const double target_rad = data_->sensordata[sensor_layout::kTarget + kGhAxialIndex];
      const double used_rad = data_->sensordata[sensor_layout::kCommanded + 2];
      // Rounding of an angle taken from a rotation.
      constexpr double kRounding_rad = 1e-12;
      EXPECT_GE(target_rad, range_rad[0] - kRounding_rad) << plane_deg << ", end " << end;
      EXPECT_LE(target_rad, range_rad[1] + kRounding_rad) << plane_deg << ", end " << end;
      const JointAngles without_rad =
          TargetsOf(rhythm, {command.elevation_rad, command.plane_rad, 0});
      EXPECT_NEAR(target_rad - without_rad[kGhAxialIndex], used_rad, kRounding_rad);
      if (used_rad != command.axial_rad) {
        EXPECT_NEAR(target_rad, range_rad[end], kRounding_rad) << plane_deg << ", end " << end;
        ++bounded;
      }
    }
  }
  EXPECT_GT(bounded, 0);
}

TEST_F(FullPluginTest, CommandActuatorsExertNoForce) {
  std::mt19937 random(2);
  Randomise(random);
  data_->ctrl[kCommandCount + kOffsetCount] = 1;  // a rate
  mj_forward(model_.get(), data_.get());
  for (std::size_t i = 0; i < kAllCommandCount; ++i) {
    EXPECT_EQ(data_->actuator_force[i], 0) << kAllCommandNames[i];
  }
}

TEST_F(PluginTest, MovesAsNativePositionServosAtTheSameTargets) {
  const ModelPointer native = LoadedModel(ShoulderXml({.actuation = Actuation::kPosition}));
  const DataPointer native_data = MakeData(*native);
  const ShoulderRhythm rhythm = BuiltInRhythm();
  constexpr int kSteps = 2000;
  for (int step = 0; step < kSteps; ++step) {
    const double share = static_cast<double>(step) / kSteps;
    const ArmCommand command{RadiansFromDegrees(170 * share),
                             RadiansFromDegrees(50 - 70 * std::cos(9 * share)),
                             0.3 * std::sin(20 * share)};
    data_->ctrl[0] = command.elevation_rad;
    data_->ctrl[1] = command.plane_rad;
    data_->ctrl[2] = command.axial_rad;
    const JointAngles target_rad = TargetsOf(rhythm, command);
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

TEST_F(FullPluginTest, TransitionDerivativesAreThoseOfWholeStepsForAllControls) {
  const int controls = static_cast<int>(model_->nu);
  std::mt19937 random(3);
  for (int sample = 0; sample < 5; ++sample) {
    Randomise(random);
    for (std::size_t rate = kCommandCount + kOffsetCount; rate < kAllCommandCount; ++rate) {
      data_->ctrl[rate] = Draw(random, -1, 1);
    }
    mj_forward(model_.get(), data_.get());
    std::vector<mjtNum> B(static_cast<std::size_t>(2 * kPositions * controls));
    mjd_transitionFD(model_.get(), data_.get(), 1e-6, true, nullptr, B.data(), nullptr, nullptr);
    for (int control = 0; control < controls; ++control) {
      const std::vector<double> expected = StepDifference(*model_, *data_, control);
      double largest = 0;
      for (const double entry : expected) {
        largest = std::max(largest, std::abs(entry));
      }
      ASSERT_GT(largest, 0.01) << "control " << control << " moves nothing";
      for (int row = 0; row < 2 * kPositions; ++row) {
        EXPECT_NEAR(B[row * controls + control], expected[row], 1e-4 * largest)
            << "sample " << sample << ", control " << control << ", row " << row;
      }
    }
  }
}

TEST_F(PluginTest, CommandsBehindTheReachAreAnsweredByTheRhythm) {
  const ShoulderRhythm rhythm = BuiltInRhythm();
  const ArmCommand command{RadiansFromDegrees(90), RadiansFromDegrees(-60)};
  const ShoulderSolution answer = rhythm.Solve(command);
  ASSERT_TRUE(answer.clamped);
  SetCommand(command);
  mj_forward(model_.get(), data_.get());
  EXPECT_EQ(data_->sensordata[sensor_layout::kCommanded], answer.used.elevation_rad);
  EXPECT_EQ(data_->sensordata[sensor_layout::kCommanded + 1], answer.used.plane_rad);
  const JointAngles expected = TargetsOf(rhythm, answer.used);
  EXPECT_TRUE(
      std::equal(expected.begin(), expected.end(), data_->sensordata + sensor_layout::kTarget));
  // The distance is that of the command itself: 60 deg from the frontal plane, in the horizontal.
  EXPECT_NEAR(data_->sensordata[sensor_layout::kDistance], RadiansFromDegrees(60), 1e-12);
}

TEST_F(PluginTest, WholeTurnsOfThePlaneDoNotMatter) {
  const std::vector<std::pair<double, double>> same_planes_deg = {
      {400, 40}, {350, -10}, {265, -95}, {-240, 120}, {181, -179}};
  for (const auto& [turned_deg, plane_deg] : same_planes_deg) {
    SetCommand({RadiansFromDegrees(50), RadiansFromDegrees(plane_deg)});
    mj_forward(model_.get(), data_.get());
    const std::vector<double> expected(data_->sensordata, data_->sensordata + model_->nsensordata);
    SetCommand({RadiansFromDegrees(50), RadiansFromDegrees(turned_deg)});
    mj_forward(model_.get(), data_.get());
    for (std::size_t k = 0; k < expected.size(); ++k) {
      EXPECT_NEAR(data_->sensordata[k], expected[k], 1e-12) << turned_deg << " " << k;
    }
  }
}

class PublishedPluginTest : public PluginTest {
 protected:
  PublishedPluginTest() : PluginTest(ShoulderXml({}, kAsPublished)) {}
};

TEST_F(PublishedPluginTest, CommandsOutsideTheTableAreClampedAndTheirDistanceIsReported) {
  SetCommand({RadiansFromDegrees(123), RadiansFromDegrees(94)});
  mj_forward(model_.get(), data_.get());
  const JointAngles corner =
      TargetsOf(BuiltInRhythm(kAsPublished), {RadiansFromDegrees(120), RadiansFromDegrees(90)});
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    EXPECT_EQ(data_->sensordata[sensor_layout::kTarget + k], corner[k]) << kCoordinateNames[k];
  }
  // Along a meridian, and along the equator.
  SetCommand({RadiansFromDegrees(123), RadiansFromDegrees(90)});
  mj_forward(model_.get(), data_.get());
  EXPECT_NEAR(data_->sensordata[sensor_layout::kDistance], RadiansFromDegrees(3), 1e-12);
  SetCommand({RadiansFromDegrees(90), RadiansFromDegrees(94)});
  mj_forward(model_.get(), data_.get());
  EXPECT_NEAR(data_->sensordata[sensor_layout::kDistance], RadiansFromDegrees(4), 1e-12);
}

TEST_F(PluginTest, HeedsControlRangesAsTheModelHasThemNow) {
  trims()[0] = 5;  // a trim far beyond its range
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

TEST_F(PluginTest, HeedsDisabledActuatorGroups) {
  constexpr int kGroup = 3;
  for (int actuator = commands_ + 4; actuator < model_->nactuator; ++actuator) {
    model_->actuator_group[actuator] = kGroup;
  }
  const DataPointer data = MakeData(*model_);
  data->ctrl[0] = 1;
  mj_forward(model_.get(), data.get());
  const std::vector<mjtNum> all(data->actuator_force + commands_,
                                data->actuator_force + model_->nactuator);
  model_->opt.disableactuator = 1 << kGroup;
  mj_forward(model_.get(), data.get());
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    EXPECT_NE(all[k], 0) << kCoordinateNames[k];
    EXPECT_EQ(data->actuator_force[commands_ + static_cast<int>(k)], k < 4 ? all[k] : 0)
        << kCoordinateNames[k];
  }
}

TEST_F(FullPluginTest, RepeatsItselfToTheLastBitWhateverWasCommandedBefore) {
  std::mt19937 random(8);
  const DataPointer used = MakeData(*model_);
  for (int sample = 0; sample < 50; ++sample) {
    Randomise(random);
    data_->ctrl[kCommandCount + kOffsetCount] = Draw(random, -2, 2);
    // The other state comes from elsewhere.
    used->ctrl[0] = Draw(random, 0, 3);
    used->ctrl[1] = Draw(random, -1, 2);
    mj_step(model_.get(), used.get());
    std::copy_n(data_->ctrl, model_->nu, used->ctrl);
    std::copy_n(data_->qpos, model_->nq, used->qpos);
    std::copy_n(data_->qvel, model_->nv, used->qvel);
    std::copy_n(data_->qacc_warmstart, model_->nv, used->qacc_warmstart);
    const DataPointer fresh(mj_copyData(nullptr, model_.get(), data_.get()));
    for (mjData* data : {data_.get(), used.get(), fresh.get()}) {
      mj_step(model_.get(), data);
    }
    for (const mjData* data : {used.get(), fresh.get()}) {
      EXPECT_TRUE(std::equal(data->qpos, data->qpos + model_->nq, data_->qpos)) << sample;
      EXPECT_TRUE(std::equal(data->actuator_force, data->actuator_force + model_->nactuator,
                             data_->actuator_force))
          << sample;
      EXPECT_TRUE(
          std::equal(data->sensordata, data->sensordata + model_->nsensordata, data_->sensordata))
          << sample;
    }
  }
}

// A state written over one with another command has the targets of the command it got.
TEST_F(PluginTest, StatesCopiedOverOthersForgetTheirCommands) {
  const DataPointer other = MakeData(*model_);
  SetCommand({RadiansFromDegrees(100), RadiansFromDegrees(20)});
  other->ctrl[0] = RadiansFromDegrees(40);
  mj_forward(model_.get(), data_.get());
  mj_forward(model_.get(), other.get());
  mj_copyData(other.get(), model_.get(), data_.get());
  mj_forward(model_.get(), other.get());
  EXPECT_TRUE(std::equal(other->actuator_force, other->actuator_force + model_->nactuator,
                         data_->actuator_force));
  EXPECT_EQ(std::vector(other->sensordata, other->sensordata + model_->nsensordata),
            SensorValues());
}

TEST_F(FullPluginTest, HoldsEveryKeyframe) {
  constexpr double kHeld_deg = 1e-6;
  for (int key = 0; key < model_->nkey; ++key) {
    mj_resetDataKeyframe(model_.get(), data_.get(), key);
    while (data_->time < 2) {
      mj_step(model_.get(), data_.get());
    }
    for (int k = 0; k < kPositions; ++k) {
      EXPECT_NEAR(DegreesFromRadians(data_->qpos[k]),
                  DegreesFromRadians(model_->key_qpos[key * model_->nq + k]), kHeld_deg)
          << model_->names + model_->name_keyadr[key] << ", " << kCoordinateNames[k];
    }
  }
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

TEST_F(PublishedPluginTest, FollowsTheInterpolationOfItsConfiguration) {
  constexpr RhythmOptions kSlerp = {Interpolation::kSlerp, Closure::kTable};
  const ModelPointer slerp = LoadedModel(ShoulderXml({}, kSlerp));
  const DataPointer slerp_data = MakeData(*slerp);
  const ArmCommand command{RadiansFromDegrees(22.5), RadiansFromDegrees(20), 0};
  for (mjData* data : {data_.get(), slerp_data.get()}) {
    data->ctrl[0] = command.elevation_rad;
    data->ctrl[1] = command.plane_rad;
  }
  mj_forward(slerp.get(), slerp_data.get());
  const JointAngles expected = TargetsOf(BuiltInRhythm(kSlerp), command);
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
    EXPECT_EQ(attached_data->actuator_force[commands_ + static_cast<int>(k)], forces()[k])
        << kCoordinateNames[k];
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
  RhythmOptions options = {};
};

class PluginRefusal : public EngineTest, public testing::WithParamInterface<BadModel> {};

TEST_P(PluginRefusal, NamesTheInstanceAndTheFix) {
  const BadModel& bad = GetParam();
  try {
    (void)LoadedModel(Replaced(ShoulderXml({}, bad.options), bad.from, bad.to));
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
        BadModel{"UnknownInterpolation", "value=\"smooth\"", "value=\"cubic\"",
                 "interpolation is \"cubic\", expected \"smooth\" or \"squad\" or \"slerp\""},
        BadModel{"UnknownClosure", "key=\"closure\" value=\"exact\"",
                 "key=\"closure\" value=\"open\"",
                 "closure is \"open\", expected \"exact\" or \"table\""},
        BadModel{"UnknownRange", "key=\"range\" value=\"whole\"", "key=\"range\" value=\"half\"",
                 "range is \"half\", expected \"whole\" or \"clamp\""},
        BadModel{
            "WholeRangeOfSquad", "key=\"range\" value=\"clamp\"", "key=\"range\" value=\"whole\"",
            "the range whole needs the interpolation smooth and the closure exact", kAsPublished},
        BadModel{"RatesOfSquad", "<plugin name=\"plane_r\"",
                 "<plugin name=\"plane_rate_r\" joint=\"gh_axial_r\" instance=\"rhythm_r\" "
                 "gear=\"0\"/><plugin name=\"plane_r\"",
                 "there are rate commands (elevation_rate and so on), and the interpolation is "
                 "squad, which has no rates. Remove them, or use the interpolation smooth",
                 kAsPublished},
        BadModel{"TwoShrugs", "<plugin name=\"plane_r\"",
                 "<plugin name=\"shrug_r\" joint=\"gh_axial_r\" instance=\"rhythm_r\" "
                 "gear=\"0\"/><plugin name=\"left_shrug\" joint=\"gh_axial_r\" "
                 "instance=\"rhythm_r\" gear=\"0\"/><plugin name=\"plane_r\"",
                 "is a second command actuator (gear 0) for shrug. Remove one"},
        BadModel{"StiffnessOfTwoNumbers", "key=\"kp\" value=\"1500 1500", "key=\"kp\" value=\"1500",
                 "kp is"},
        BadModel{"NegativeStiffness", "key=\"kp\" value=\"1500", "key=\"kp\" value=\"-1500",
                 "expected one positive number"},
        BadModel{"BrokenTable", "key=\"table\" value=\"smoothed\"",
                 "key=\"table\" value=\"plane_deg;0\"", "column 'elevation_deg' is missing"},
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

// An actuator that names no instance has one of its own, without a name.
TEST_F(PluginTest, AnInstanceWithoutANameIsRefusedWithTheFixToo) {
  try {
    (void)LoadedModel(Replaced(ShoulderXml(), "<plugin name=\"ac_tilt_r\"",
                               "<plugin name=\"own\" joint=\"ac_tilt_r\" plugin=\"girdle.rhythm\"/>"
                               "<plugin name=\"ac_tilt_r\""));
    FAIL() << "loaded";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("instance \"\": actuator \"own\" is a servo"),
              std::string::npos)
        << error.what();
  }
}

TEST_F(PluginTest, UnknownConfigurationIsRefusedByMuJoCo) {
  try {
    (void)LoadedModel(Replaced(ShoulderXml(), "key=\"kp\"", "key=\"stiffness\""));
    FAIL() << "loaded";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("unrecognized attribute"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace girdle::plugin_test
