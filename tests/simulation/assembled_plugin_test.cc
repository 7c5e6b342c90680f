// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The engine plugin in left shoulders, in loops, and in models of both: against the inverse
/// kinematics, and as MuJoCo's users handle models.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <glm/geometric.hpp>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "names/joint_dynamics.h"
#include "names/model_names.h"
#include "simulation/model_variants.h"
#include "simulation/plugin_fixture.h"
#include "text/input_error.h"

namespace girdle::assembled_plugin_test {
namespace {

double Draw(std::mt19937& random, double lower, double upper) {
  return std::uniform_real_distribution(lower, upper)(random);
}

double DrawDegrees(std::mt19937& random, double lower_deg, double upper_deg) {
  return RadiansFromDegrees(Draw(random, lower_deg, upper_deg));
}

// A side of a tree or of a loop with either lead.
struct SidedVariant {
  Variant variant;
  Side side;
};

void PrintTo(const SidedVariant& tested, std::ostream* out) {
  *out << tested.variant.name << " " << Name(tested.side);
}

std::vector<SidedVariant> SidedVariants() {
  std::vector<SidedVariant> all;
  for (const Variant& variant : PluginVariants()) {
    all.push_back({variant, Side::kRight});
    all.push_back({variant, Side::kLeft});
  }
  return all;
}

class AssembledPlugin : public EngineTest, public testing::WithParamInterface<SidedVariant> {
 protected:
  AssembledPlugin() {
    ShoulderModelOptions options =
        variant().Options(side() == Side::kRight ? Sides::kRight : Sides::kLeft);
    options.has_offsets = true;
    model_ = LoadedModel(ShoulderXml(options));
    data_ = MakeData(*model_);
  }

  static const Variant& variant() { return GetParam().variant; }
  static Side side() { return GetParam().side; }
  static std::string Name(std::string_view stem) { return SidedName(stem, side()); }
  static bool is_loop() { return variant().assembly == Assembly::kLoop; }
  static bool scapula_leads() { return variant().lead == Lead::kScapula; }

  // Stiffness that the plugin's servos have, joint by joint as JointStems.
  static double StiffnessOf(std::string_view stem) {
    if (stem == "st_anterior" || stem == "st_superior" || stem == "st_lateral") {
      return scapula_leads() ? kLeadingTranslation.stiffness_N_per_m : 0;
    }
    if (stem.starts_with("sc_")) {
      return scapula_leads() && stem != "sc_rotation" ? 0 : kJointDynamics[0].stiffness_N_m_per_rad;
    }
    return kJointDynamics[stem.starts_with("gh_") ? 2 : 1].stiffness_N_m_per_rad;
  }

  static bool HasServo(std::string_view stem) {
    return scapula_leads() ||
           (stem != "st_anterior" && stem != "st_superior" && stem != "st_lateral");
  }

  void SetCommand(const ArmCommand& command) const {
    ControlOf(*model_, *data_, Name("elevation")) = command.elevation_rad;
    ControlOf(*model_, *data_, Name("plane")) = command.plane_rad;
    ControlOf(*model_, *data_, Name("axial")) = command.axial_rad;
    ControlOf(*model_, *data_, Name("shrug")) = command.shrug_rad;
    ControlOf(*model_, *data_, Name("protraction")) = command.protraction_rad;
  }

  void PutAt(const ShoulderPose& pose) const {
    const JointAngles angles_rad = DrivenAngles(variant().assembly, pose);
    const auto driven = DrivenCoordinates(variant().assembly);
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      PositionOf(*model_, *data_, Name(driven[k])) = angles_rad[k];
    }
    const Vector3 place_m = PlaceOfScapula(pose);
    for (int i = 0; is_loop() && i < 3; ++i) {
      PositionOf(*model_, *data_, Name(kTranslationNames[static_cast<std::size_t>(i)])) =
          place_m[i];
    }
  }

  // SC, ST and the humerus's turn about itself are bounded by their joints, axial turn and offsets
  // though they may ask for more. GH is bounded before a loop's correction, up to 2.5 deg, moves
  // it.
  void ExpectWithinRanges(const JointAngles& target_rad, int sample) const {
    constexpr double kRounding_rad = 1e-9;
    const auto driven = DrivenCoordinates(variant().assembly);
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      if (k == kGhAxialIndex - 1 || k == kGhAxialIndex - 2) continue;
      const int joint = mj_name2id(model_.get(), mjOBJ_JOINT, Name(driven[k]).c_str());
      EXPECT_GE(target_rad[k], model_->jnt_range[2 * joint] - kRounding_rad)
          << driven[k] << " of sample " << sample;
      EXPECT_LE(target_rad[k], model_->jnt_range[2 * joint + 1] + kRounding_rad)
          << driven[k] << " of sample " << sample;
    }
  }

  // Commands, trims and positions, all of them off where they lead.
  void Randomise(std::mt19937& random) const {
    SetCommand({DrawDegrees(random, 20, 160), DrawDegrees(random, -25, 130),
                DrawDegrees(random, -20, 20), DrawDegrees(random, -5, 5),
                DrawDegrees(random, -5, 5)});
    for (const std::string_view stem : JointStems(variant().assembly)) {
      const double most =
          stem == "st_anterior" || stem == "st_superior" || stem == "st_lateral" ? 0.005 : 0.1;
      if (HasServo(stem)) {
        ControlOf(*model_, *data_, Name(stem)) = Draw(random, -most, most);
      }
      PositionOf(*model_, *data_, Name(stem)) += Draw(random, -most, most) / 100;
    }
    for (int i = 0; i < model_->nv; ++i) data_->qvel[i] = Draw(random, -0.3, 0.3);
  }

  ModelPointer model_;
  DataPointer data_;
  AssembledRhythm rhythm_{BuiltInRhythm(), GetParam().variant.assembly,
                          BuiltInAnatomy().scapulothoracic_ranges};
};

INSTANTIATE_TEST_SUITE_P(Variants, AssembledPlugin, testing::ValuesIn(SidedVariants()),
                         [](const auto& tested) {
                           return std::string(tested.param.variant.name) +
                                  (tested.param.side == Side::kRight ? "Right" : "Left");
                         });

TEST_P(AssembledPlugin, AimsWhereTheAssembledRhythmDoesWithEveryServosForce) {
  std::mt19937 random(1);
  for (int sample = 0; sample < 200; ++sample) {
    // Within the controls' ranges, beyond what an arm reaches and what joints allow.
    const ArmCommand command{DrawDegrees(random, 0, 180), DrawDegrees(random, -60, 135),
                             DrawDegrees(random, -60, 60), DrawDegrees(random, -15, 35),
                             DrawDegrees(random, -25, 30)};
    Randomise(random);
    SetCommand(command);
    mj_forward(model_.get(), data_.get());
    const ShoulderPose pose = rhythm_.SolvePose(command);
    const JointAngles target_rad = DrivenAngles(variant().assembly, pose);
    const mjtNum* values = SensorOf(*model_, *data_, Name("rhythm"));
    ASSERT_TRUE(std::equal(target_rad.begin(), target_rad.end(), values + sensor_layout::kTarget))
        << "sample " << sample;
    const auto driven = DrivenCoordinates(variant().assembly);
    ExpectWithinRanges(target_rad, sample);
    for (const std::string_view stem : JointStems(variant().assembly)) {
      if (!HasServo(stem)) continue;
      const auto* const found = std::find(driven.begin(), driven.end(), stem);
      const auto* const axis = std::find(kTranslationNames.begin(), kTranslationNames.end(), stem);
      const double target =
          found != driven.end()
              ? target_rad[static_cast<std::size_t>(found - driven.begin())]
              : PlaceOfScapula(pose)[static_cast<int>(axis - kTranslationNames.begin())];
      const double expected = StiffnessOf(stem) * (target + ControlOf(*model_, *data_, Name(stem)) -
                                                   PositionOf(*model_, *data_, Name(stem)));
      // One rounding of a force of some thousand newtons.
      ASSERT_NEAR(ForceOf(*model_, *data_, Name(stem)), expected, 1e-9)
          << stem << ", sample " << sample;
    }
  }
}

TEST_P(AssembledPlugin, ReachesWhatIsCommandedWhereTheJointsAreOnTheirTargets) {
  // A few roundings of angles through the bodies' rotations.
  constexpr double kRounding_rad = 1e-12;
  for (const ArmCommand& command :
       {ArmCommand{0.7, 0.5, 0.2}, ArmCommand{1.5, -0.3, -0.25}, ArmCommand{2.4, 1.9, 0}}) {
    SetCommand(command);
    PutAt(rhythm_.SolvePose(command));
    mj_forward(model_.get(), data_.get());
    const mjtNum* values = SensorOf(*model_, *data_, Name("rhythm"));
    EXPECT_NEAR(values[sensor_layout::kReached], command.elevation_rad, kRounding_rad);
    EXPECT_NEAR(values[sensor_layout::kReached + 1], command.plane_rad, kRounding_rad);
    EXPECT_NEAR(values[sensor_layout::kReached + 2], command.axial_rad, kRounding_rad);
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      EXPECT_NEAR(values[sensor_layout::kError + k], 0, kRounding_rad) << k;
    }
  }
}

// An arm that is not where it was told to be, from where its elbow is in the world.
TEST_P(AssembledPlugin, SaysWhereTheHumerusPoints) {
  const ArmCommand command{1.1, 0.9};
  PutAt(rhythm_.SolvePose(command));
  SetCommand({0.3, 0.2});
  mj_forward(model_.get(), data_.get());
  const auto site = [this](const char* stem) {
    return VectorAt(data_->site_xpos + 3 * IdOf(*model_, mjOBJ_SITE, Name(stem)));
  };
  const Vector3 down_arm = (site("EM") + site("EL")) / 2.0 - site("GH");
  const double outward = side() == Side::kRight ? -down_arm.y : down_arm.y;
  const mjtNum* values = SensorOf(*model_, *data_, Name("rhythm"));
  EXPECT_NEAR(values[sensor_layout::kReached], std::acos(-down_arm.z / glm::length(down_arm)),
              1e-9);
  EXPECT_NEAR(values[sensor_layout::kReached + 1], std::atan2(down_arm.x, outward), 1e-9);
  EXPECT_EQ(values[sensor_layout::kCommanded], 0.3);
}

TEST_P(AssembledPlugin, ResetModelStandsStill) {
  const std::vector<mjtNum> begin(data_->qpos, data_->qpos + model_->nq);
  for (int step = 0; step < 500; ++step) mj_step(model_.get(), data_.get());
  for (int i = 0; i < model_->nq; ++i) {
    // Gravity is compensated and targets are where the joints stand: only rounding moves them.
    EXPECT_NEAR(data_->qpos[i], begin[static_cast<std::size_t>(i)], 1e-11) << i;
  }
}

TEST_P(AssembledPlugin, HoldsEveryKeyframe) {
  // Radians of a joint and meters of a place; a hundredth of a micrometer.
  constexpr double kHeld = 1e-8;
  for (int key = 0; key < model_->nkey; ++key) {
    mj_resetDataKeyframe(model_.get(), data_.get(), key);
    while (data_->time < 1) mj_step(model_.get(), data_.get());
    for (int i = 0; i < model_->nq; ++i) {
      EXPECT_NEAR(data_->qpos[i], model_->key_qpos[key * model_->nq + i], kHeld)
          << model_->names + model_->name_keyadr[key] << ", " << i;
    }
  }
}

// Change of the next state per change of a control, from whole steps, central differences.
std::vector<double> StepDifference(const mjModel& model, const mjData& data, int control) {
  constexpr double kNudge = 1e-5;
  const DataPointer moved = MakeData(model);
  std::vector<double> difference(static_cast<std::size_t>(2 * model.nv));
  for (const double sign : {1.0, -1.0}) {
    mj_copyData(moved.get(), &model, &data);
    moved->ctrl[control] += sign * kNudge;
    mj_step(&model, moved.get());
    for (int i = 0; i < model.nv; ++i) {
      difference[static_cast<std::size_t>(i)] += sign * moved->qpos[i] / (2 * kNudge);
      difference[static_cast<std::size_t>(model.nv + i)] += sign * moved->qvel[i] / (2 * kNudge);
    }
  }
  return difference;
}

TEST_P(AssembledPlugin, TransitionDerivativesAreThoseOfWholeStepsForAllControls) {
  // A solver that ends early would leave its own differences.
  model_->opt.tolerance = 0;
  const int controls = static_cast<int>(model_->nu);
  std::mt19937 random(3);
  for (int sample = 0; sample < 3; ++sample) {
    mj_resetData(model_.get(), data_.get());
    Randomise(random);
    mj_forward(model_.get(), data_.get());
    std::vector<mjtNum> B(static_cast<std::size_t>(2 * model_->nv * controls));
    mjd_transitionFD(model_.get(), data_.get(), 1e-6, true, nullptr, B.data(), nullptr, nullptr);
    for (int control = 0; control < controls; ++control) {
      const std::vector<double> expected = StepDifference(*model_, *data_, control);
      double largest = 0;
      for (const double entry : expected) largest = std::max(largest, std::abs(entry));
      // A servo of no stiffness is there to have a trim like the others; it moves nothing.
      const std::string name = model_->names + model_->name_actuatoradr[control];
      const bool is_soft =
          scapula_leads() && (name == Name("sc_protraction") || name == Name("sc_elevation"));
      ASSERT_EQ(largest > 0.01, !is_soft) << name << " moves by " << largest;
      for (int row = 0; row < 2 * model_->nv; ++row) {
        EXPECT_NEAR(B[static_cast<std::size_t>(row * controls + control)],
                    expected[static_cast<std::size_t>(row)], 1e-4 * largest)
            << "sample " << sample << ", " << name << ", row " << row;
      }
    }
  }
}

TEST_P(AssembledPlugin, RepeatsItselfToTheLastBitWhateverWasCommandedBefore) {
  EXPECT_EQ(model_->npluginstate, 0);
  std::mt19937 random(8);
  const DataPointer used = MakeData(*model_);
  for (int sample = 0; sample < 30; ++sample) {
    Randomise(random);
    // The other state comes from elsewhere: from a command that differs in one of its parts.
    constexpr std::array<const char*, 5> kParts = {"elevation", "plane", "axial", "shrug",
                                                   "protraction"};
    std::copy_n(data_->ctrl, model_->nu, used->ctrl);
    ControlOf(*model_, *used, Name(kParts.at(static_cast<std::size_t>(sample) % kParts.size()))) +=
        0.05;
    mj_step(model_.get(), used.get());
    std::copy_n(data_->ctrl, model_->nu, used->ctrl);
    std::copy_n(data_->qpos, model_->nq, used->qpos);
    std::copy_n(data_->qvel, model_->nv, used->qvel);
    std::copy_n(data_->qacc_warmstart, model_->nv, used->qacc_warmstart);
    const DataPointer fresh(mj_copyData(nullptr, model_.get(), data_.get()));
    for (mjData* data : {data_.get(), used.get(), fresh.get()}) mj_step(model_.get(), data);
    for (const mjData* data : {used.get(), fresh.get()}) {
      EXPECT_TRUE(std::equal(data->qpos, data->qpos + model_->nq, data_->qpos)) << sample;
      EXPECT_TRUE(
          std::equal(data->sensordata, data->sensordata + model_->nsensordata, data_->sensordata))
          << sample;
    }
  }
}

// --- As users handle models ----------------------------------------------------------------------

class HandledModel : public EngineTest, public testing::WithParamInterface<Variant> {
 protected:
  // Some steps of a motion, each side its own.
  void Move(mjData& data, int from, int steps) const {
    for (int step = from; step < from + steps; ++step) {
      Command(*model_, data, GetParam(), {Side::kRight}, LivelyCommand(0.002 * step));
      Command(*model_, data, GetParam(), {Side::kLeft}, LivelyCommand(0.002 * step + 0.3));
      mj_step(model_.get(), &data);
    }
  }

  [[nodiscard]] std::vector<mjtNum> Positions(const mjData& data) const {
    return {data.qpos, data.qpos + model_->nq};
  }

  ModelPointer model_ = GetParam().Load(Sides::kBoth);
  DataPointer data_ = MakeData(*model_);
};

INSTANTIATE_TEST_SUITE_P(Variants, HandledModel, testing::ValuesIn(AllVariants()), NameOf);

TEST_P(HandledModel, CopiedStatesGoOnAsTheOriginal) {
  Move(*data_, 0, 50);
  const DataPointer made(mj_copyData(nullptr, model_.get(), data_.get()));
  const DataPointer reused = MakeData(*model_);
  Move(*reused, 400, 20);
  mj_copyData(reused.get(), model_.get(), data_.get());
  for (mjData* data : {data_.get(), made.get(), reused.get()}) Move(*data, 50, 50);
  EXPECT_EQ(Positions(*made), Positions(*data_));
  EXPECT_EQ(Positions(*reused), Positions(*data_));
  EXPECT_NE(Positions(*data_), Positions(*MakeData(*model_)));
}

TEST_P(HandledModel, ResetStatesGoOnAsFreshOnes) {
  Move(*data_, 100, 50);
  mj_resetData(model_.get(), data_.get());
  const DataPointer fresh = MakeData(*model_);
  EXPECT_EQ(Positions(*data_), Positions(*fresh));
  for (mjData* data : {data_.get(), fresh.get()}) Move(*data, 0, 50);
  EXPECT_EQ(Positions(*data_), Positions(*fresh));
}

TEST_P(HandledModel, SavedAsMjbGoesOnAsTheOriginal) {
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) /
      (std::string("girdle_") + GetParam().name + "_" + std::to_string(getpid()) + ".mjb");
  mj_saveModel(model_.get(), file.c_str(), nullptr, 0);
  const ModelPointer loaded = LoadModel(file.string());
  std::filesystem::remove(file);
  const DataPointer loaded_data = MakeData(*loaded);
  Move(*data_, 0, 50);
  std::swap(model_, const_cast<ModelPointer&>(loaded));
  Move(*loaded_data, 0, 50);
  EXPECT_EQ(Positions(*loaded_data), Positions(*data_));
}

TEST_P(HandledModel, OfWhichTwoAreInOneProcessDoNotDisturbEachOther) {
  const ModelPointer other = LoadedModel(ShoulderXml({.assembly = Assembly::kLoop}, kAsPublished));
  const DataPointer other_data = MakeData(*other);
  const DataPointer alone = MakeData(*model_);
  for (int step = 0; step < 60; ++step) {
    Move(*data_, step, 1);
    other_data->ctrl[0] = 0.3 + 0.02 * step;
    mj_step(other.get(), other_data.get());
  }
  Move(*alone, 0, 60);
  EXPECT_EQ(Positions(*alone), Positions(*data_));
}

// --- Attached to somebody else's torso -----------------------------------------------------------

struct SpecDeleter {
  void operator()(mjSpec* spec) const noexcept { mj_deleteSpec(spec); }
};
using SpecPointer = std::unique_ptr<mjSpec, SpecDeleter>;

SpecPointer Parsed(const std::string& xml) {
  std::array<char, 1000> error{};
  SpecPointer spec(mj_parseXMLString(xml.c_str(), nullptr, error.data(), error.size()));
  if (spec == nullptr) throw std::logic_error(error.data());
  return spec;
}

// A third party's torso: with joints, an actuator, a sensor and an equality of its own before ours.
constexpr const char* kTorso = R"(
<mujoco model="somebody's">
  <option timestep="0.002" integrator="implicitfast"/>
  <worldbody>
    <body name="nodding" pos="2 0 1">
      <joint name="nod" axis="0 1 0" damping="1" armature="0.1"/>
      <joint name="shake" axis="0 0 1" damping="1" armature="0.1"/>
      <geom size="0.1" mass="1"/>
    </body>
    <body name="torso" pos="0.3 -0.2 0.1">
      <geom type="capsule" size="0.05 0.1" contype="0" conaffinity="0"/>
    </body>
  </worldbody>
  <equality><joint joint1="nod" joint2="shake"/></equality>
  <actuator><motor name="nod" joint="nod" gear="2"/></actuator>
  <sensor><jointpos name="nod" joint="nod"/></sensor>
  <keyframe><key name="bowed" qpos="0.2 0.2" ctrl="0.1"/></keyframe>
</mujoco>)";

struct Attached {
  Variant variant;
  Sides sides;
  std::string prefix;
};

// All of them on the one torso.
ModelPointer TorsoWith(const std::vector<Attached>& shoulders) {
  const SpecPointer parent = Parsed(kTorso);
  std::vector<SpecPointer> children;
  double height_m = 0;
  for (const Attached& attached : shoulders) {
    children.push_back(Parsed(ShoulderXml(attached.variant.Options(attached.sides))));
    mjsFrame* frame = mjs_addFrame(mjs_findBody(parent.get(), "torso"), nullptr);
    frame->pos[2] = height_m;
    height_m += 0.5;
    if (mjs_attach(frame->element, mjs_findBody(children.back().get(), "thorax")->element,
                   attached.prefix.c_str(), "") == nullptr) {
      throw std::logic_error(mjs_getError(parent.get()));
    }
  }
  ModelPointer model(mj_compile(parent.get(), nullptr));
  if (model == nullptr) throw std::logic_error(mjs_getError(parent.get()));
  return model;
}

void ExpectMoveAsAlone(const std::vector<Attached>& shoulders) {
  const ModelPointer torso = TorsoWith(shoulders);
  const DataPointer data = MakeData(*torso);
  ControlOf(*torso, *data, "nod") = 1;
  std::vector<ModelPointer> alone;
  std::vector<DataPointer> alone_data;
  for (const Attached& attached : shoulders) {
    alone.push_back(attached.variant.Load(attached.sides));
    alone_data.push_back(MakeData(*alone.back()));
  }
  constexpr int kSteps = 300;
  // The solver ends by its tolerance for all constraints of a model together.
  constexpr double kSame = 1e-9;
  for (int step = 0; step < kSteps; ++step) {
    for (std::size_t i = 0; i < shoulders.size(); ++i) {
      const Attached& attached = shoulders[i];
      const ArmCommand command = LivelyCommand(0.002 * step + 0.2 * static_cast<double>(i));
      for (const Side side : SidesOf(attached.sides)) {
        Command(*torso, *data, attached.variant, {side, attached.prefix}, command);
        Command(*alone[i], *alone_data[i], attached.variant, {side}, command);
      }
      mj_step(alone[i].get(), alone_data[i].get());
    }
    mj_step(torso.get(), data.get());
    for (std::size_t i = 0; i < shoulders.size(); ++i) {
      const Attached& attached = shoulders[i];
      for (const Side side : SidesOf(attached.sides)) {
        const ShoulderNames names{side, attached.prefix};
        for (const std::string_view stem : JointStems(attached.variant.assembly)) {
          ASSERT_NEAR(PositionOf(*torso, *data, names.Of(stem)),
                      PositionOf(*alone[i], *alone_data[i], SidedName(stem, side)), kSame)
              << names.Of(stem) << " at step " << step;
        }
        if (!attached.variant.has_plugin()) continue;
        const mjtNum* values = SensorOf(*torso, *data, names.Of("rhythm"));
        const mjtNum* own = SensorOf(*alone[i], *alone_data[i], SidedName("rhythm", side));
        // Near hanging the plane reached is nothing but rounding.
        constexpr double kPlaneless_rad = 0.01;
        for (std::size_t k = 0; k < sensor_layout::kSize; ++k) {
          // ISB's axial rotation is as ill determined as the plane.
          const bool is_plane = k == sensor_layout::kReached + 1 || k == sensor_layout::kReachedIsb;
          if (is_plane && own[sensor_layout::kReached] < kPlaneless_rad) continue;
          ASSERT_NEAR(values[k], own[k], is_plane ? kSame / kPlaneless_rad : kSame)
              << names.Of("rhythm") << " " << k;
        }
      }
    }
  }
  EXPECT_GT(std::abs(PositionOf(*torso, *data, "nod")), 0.1) << "the torso's own joint";
}

const Variant kTree = {"Tree"};
const Variant kLoop = {"Loop", Assembly::kLoop};
const Variant kScapulaLeads = {"ScapulaLeads", Assembly::kLoop, Lead::kScapula};
const Variant kServos = {"LoopPosition", Assembly::kLoop, Lead::kClavicle, Actuation::kPosition};

class AttachedShoulders : public EngineTest {};

TEST_F(AttachedShoulders, ARightTreeAndALeftLoopMoveAsAlone) {
  ExpectMoveAsAlone({{kTree, Sides::kRight, "his_"}, {kLoop, Sides::kLeft, "hers_"}});
}

TEST_F(AttachedShoulders, BothOfALoopMoveAsAlone) {
  ExpectMoveAsAlone({{kLoop, Sides::kBoth, "plane_st_tilt_"}});
}

TEST_F(AttachedShoulders, OfTwoLeadsAndWithServosMoveAsAlone) {
  ExpectMoveAsAlone({{kScapulaLeads, Sides::kBoth, "a_"}, {kServos, Sides::kLeft, "b_"}});
}

TEST_F(AttachedShoulders, KeepTheirConnectsAndTheirKeyframes) {
  const ModelPointer torso =
      TorsoWith({{kTree, Sides::kRight, "his_"}, {kLoop, Sides::kBoth, "hers_"}});
  EXPECT_EQ(torso->neq, 3);
  for (const char* const name : {"hers_AC_r", "hers_AC_l"}) {
    const int connect = IdOf(*torso, mjOBJ_EQUALITY, name);
    EXPECT_EQ(torso->eq_type[connect], mjEQ_CONNECT) << name;
    EXPECT_TRUE(torso->eq_active0[connect]) << name;
  }
  const DataPointer data = MakeData(*torso);
  const ModelPointer alone = kLoop.Load(Sides::kBoth);
  const DataPointer alone_data = MakeData(*alone);
  for (const NamedPose& named : kKeyframes) {
    const std::string name(named.name);
    mj_resetDataKeyframe(torso.get(), data.get(), IdOf(*torso, mjOBJ_KEY, "hers_" + name));
    mj_resetDataKeyframe(alone.get(), alone_data.get(), IdOf(*alone, mjOBJ_KEY, name));
    for (const Side side : {Side::kRight, Side::kLeft}) {
      for (const std::string_view stem : JointStems(Assembly::kLoop)) {
        const ShoulderNames names{side, "hers_"};
        EXPECT_EQ(PositionOf(*torso, *data, names.Of(stem)),
                  PositionOf(*alone, *alone_data, SidedName(stem, side)))
            << name << ", " << names.Of(stem);
      }
    }
  }
}

// --- Models that the plugin refuses --------------------------------------------------------------

// One thing changed in a sound model, and what the message says of it.
struct Flaw {
  const char* name;
  Variant variant;
  std::vector<std::pair<std::string, std::string>> changes;
  const char* message;
};

void PrintTo(const Flaw& flaw, std::ostream* out) { *out << flaw.name; }

class AssembledPluginRefusal : public EngineTest, public testing::WithParamInterface<Flaw> {};

TEST_P(AssembledPluginRefusal, NamesTheInstanceAndTheFix) {
  const Flaw& flaw = GetParam();
  std::string xml = ShoulderXml(flaw.variant.Options(Sides::kLeft));
  for (const auto& [from, to] : flaw.changes) xml = Replaced(xml, from, to);
  try {
    (void)LoadedModel(xml);
    FAIL() << "loaded";
  } catch (const InputError& error) {
    const std::string reason = error.what();
    EXPECT_NE(reason.find("girdle.rhythm instance \"rhythm_l\""), std::string::npos) << reason;
    EXPECT_NE(reason.find(flaw.message), std::string::npos) << reason;
  }
}

std::string Servo(const std::string& stem) {
  return "<plugin name=\"" + stem + "_l\" joint=\"" + stem + "_l\" instance=\"rhythm_l\"";
}
// The same actuator as something that is none of the plugin's.
std::string Motor(const std::string& stem) {
  return "<motor name=\"" + stem + "_l\" joint=\"" + stem + "_l\"";
}
std::pair<std::string, std::string> Without(const std::string& stem) {
  return {Servo(stem), Motor(stem)};
}
// Puts an actuator before the last one of all variants.
std::pair<std::string, std::string> With(const std::string& actuator) {
  return {Servo("gh_axial"), actuator + Servo("gh_axial")};
}

INSTANTIATE_TEST_SUITE_P(
    Models, AssembledPluginRefusal,
    testing::Values(
        Flaw{"UnknownSide",
             kTree,
             {{"key=\"side\" value=\"left\"", "key=\"side\" value=\"sinister\""}},
             "side is \"sinister\", expected \"right\" or \"left\""},
        Flaw{"PlaceStiffnessOfNoNumber",
             kScapulaLeads,
             {{"key=\"kp_translation\" value=\"10000\"", "key=\"kp_translation\" value=\"stiff\""}},
             "kp_translation is \"stiff\", expected a positive number of N/m"},
        Flaw{"PlaceStiffnessOfZero",
             kScapulaLeads,
             {{"key=\"kp_translation\" value=\"10000\"", "key=\"kp_translation\" value=\"0\""}},
             "kp_translation is \"0\", expected a positive number of N/m"},
        Flaw{"OneServoOfAcInALoop",
             kLoop,
             {With("<plugin name=\"ac_tilt_l\" joint=\"st_tilt_l\" instance=\"rhythm_l\"/>")},
             "servos of both ac_tilt and st_internal_rotation: the scapula hangs either from the "
             "clavicle (ac_ servos) or from the thorax (st_ servos). Remove one kind"},
        Flaw{"OneServoOfStInATree",
             kTree,
             {With("<plugin name=\"st_tilt_l\" joint=\"ac_tilt_l\" instance=\"rhythm_l\"/>")},
             "servos of both ac_internal_rotation and st_tilt: the scapula hangs either from the "
             "clavicle (ac_ servos) or from the thorax (st_ servos). Remove one kind"},
        Flaw{"ALoopWithoutOneOfSt",
             kLoop,
             {Without("st_upward_rotation")},
             "no servo for st_upward_rotation. Add <plugin name=\"st_upward_rotation_l\""},
        Flaw{"PlaceInATree",
             kTree,
             {With("<plugin name=\"st_lateral_l\" joint=\"gh_axial_l\" instance=\"rhythm_l\"/>")},
             "st_lateral_l\" does not act on a slide. Give it joint=\"st_lateral_l\", a slide"},
        Flaw{"PlaceWithoutOrientation",
             kScapulaLeads,
             {Without("st_internal_rotation"), Without("st_upward_rotation"), Without("st_tilt")},
             "servos for the scapula's place (st_lateral and so on), but none for its orientation. "
             "Add st_internal_rotation, st_upward_rotation and st_tilt"},
        Flaw{"OnlyTwoOfThePlace",
             kScapulaLeads,
             {Without("st_superior")},
             "no servo for st_superior. Add <plugin name=\"st_superior_l\""},
        Flaw{"NoConnect",
             kScapulaLeads,
             {{"<connect name=\"AC_l\" site1=\"PAC_l\" site2=\"PAC_scapula_l\"",
               "<weld name=\"AC_l\" site1=\"PAC_l\" site2=\"PAC_scapula_l\""}},
             "no <connect site1=\"...\" site2=\"...\"/> of clavicle and scapula in <equality>, "
             "which says where the AC joint is. Add one"},
        Flaw{"ConnectOfOtherBones",
             kScapulaLeads,
             {{"site2=\"PAC_scapula_l\"", "site2=\"GH_humerus_l\""}},
             "no <connect site1=\"...\" site2=\"...\"/> of clavicle and scapula"},
        Flaw{"SlideWhereAHingeIsNeeded",
             kLoop,
             {{Servo("st_tilt"),
               "<plugin name=\"st_tilt_l\" joint=\"st_lateral_l\" instance=\"rhythm_l\""}},
             "actuator \"st_tilt_l\" does not act on a hinge. Give it joint=\"st_tilt_l\", a "
             "hinge"},
        Flaw{"HingeWhereASlideIsNeeded",
             kScapulaLeads,
             {{Servo("st_lateral"),
               "<plugin name=\"st_lateral_l\" joint=\"st_tilt_l\" instance=\"rhythm_l\""}},
             "actuator \"st_lateral_l\" does not act on a slide. Give it joint=\"st_lateral_l\", a "
             "slide"},
        Flaw{"TwoOfOnePlace",
             kScapulaLeads,
             {With("<plugin name=\"second_st_lateral\" joint=\"st_lateral_l\" "
                   "instance=\"rhythm_l\"/>")},
             "is a second servo for st_lateral. Remove one"},
        Flaw{"RatesInALoop",
             kLoop,
             {With("<plugin name=\"plane_rate_l\" joint=\"gh_axial_l\" instance=\"rhythm_l\" "
                   "gear=\"0\"/>")},
             "there are rate commands (elevation_rate and so on), and the scapula hangs from the "
             "thorax (st_ servos), where they are not known. Remove them"}),
    [](const auto& tested) { return tested.param.name; });

// A loop that asks for more than a table can say.
TEST_F(EngineTest, ALoopOfATableOfTwoPlanesIsRefusedByThePlugin) {
  const std::string table =
      "plane_deg,elevation_deg,sc_protraction_deg,sc_elevation_deg,sc_rotation_deg,"
      "ac_internal_rotation_deg,ac_upward_rotation_deg,ac_tilt_deg,gh_elevation_deg,"
      "gh_flexion_deg,gh_axial_deg;0,15,-20,-8,0,50,-4,-3,3,0,-51;0,20,-20,-8,0,50,-4,-3,-1,-3,-58;"
      "90,15,-20,-8,0,50,-4,-3,3,0,-51;90,20,-20,-8,0,50,-4,-3,-1,-3,-58";
  const auto reason = [&table](const Variant& variant) -> std::string {
    std::string xml = ShoulderXml(variant.Options(Sides::kRight), kAsPublished);
    xml = Replaced(xml, "value=\"squad\"", "value=\"slerp\"");
    xml =
        Replaced(xml, "key=\"table\" value=\"measured\"", "key=\"table\" value=\"" + table + "\"");
    try {
      (void)LoadedModel(xml);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(reason(kTree), "");
  EXPECT_NE(reason(kLoop).find("girdle.rhythm instance \"rhythm_r\": st_ servos: the assembly loop "
                               "needs a table of at least 3 planes and 3 elevations, this one has "
                               "2 and 2"),
            std::string::npos)
      << reason(kLoop);
}

}  // namespace
}  // namespace girdle::assembled_plugin_test
