// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "plugin/rhythm_binding.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>
#include <functional>
#include <stdexcept>
#include <string>

#include "plugin/engine_layout.h"
#include "simulation/model_variants.h"

namespace girdle::rhythm_binding_test {
namespace {

// Instances of a model of both shoulders, in the order of their sides.
constexpr int kInstances[] = {0, 1};

RhythmConfig ConfigOf(const mjModel& model, int instance) {
  const auto text = [&](const char* key) {
    const char* const value = mj_getPluginConfig(&model, instance, key);
    return std::string(value == nullptr ? "" : value);
  };
  return ParseRhythmConfig({text(kInterpolationKey), text(kClosureKey), text(kRangeKey),
                            text(kTableKey), text(kStiffnessKey), text(kSideKey),
                            text(kTranslationStiffnessKey)});
}

RhythmBinding Bound(const mjModel& model, int instance) {
  return BindRhythm(ViewOf(model, *FindEngineLayout(mj_version())), instance,
                    ConfigOf(model, instance));
}

// What it says of a model that is changed after it was loaded: MuJoCo loads none that its plugin
// refuses. Empty if it has nothing against it.
std::string Complaint(const std::function<void(mjModel&)>& change) {
  const ModelPointer model = LoadedModel(ShoulderXml());
  change(*model);
  try {
    static_cast<void>(Bound(*model, 0));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

class RhythmBindingTest : public EngineTest, public testing::WithParamInterface<Variant> {
 protected:
  static void ExpectServo(const mjModel& model, const BoundServo& servo, const std::string& name) {
    const int joint = IdOf(model, mjOBJ_JOINT, name);
    const int actuator = IdOf(model, mjOBJ_ACTUATOR, name);
    EXPECT_EQ(servo.qpos_address, model.jnt_qposadr[joint]) << name;
    EXPECT_EQ(servo.dof_address, model.jnt_dofadr[joint]) << name;
    EXPECT_EQ(servo.force_address, model.actuator_outadr[actuator]) << name;
    EXPECT_EQ(servo.trim.address, model.actuator_ctrladr[actuator]) << name;
  }
};

TEST_P(RhythmBindingTest, FindsEachElementThatBearsTheNameOfItsRole) {
  const ModelPointer model = GetParam().Load(Sides::kBoth);
  for (const int instance : kInstances) {
    const RhythmBinding binding = Bound(*model, instance);
    const ShoulderNames names = {static_cast<Side>(instance)};
    EXPECT_EQ(binding.side, names.side);
    EXPECT_EQ(binding.assembly, GetParam().assembly);
    EXPECT_EQ(binding.has_place_servos, GetParam().lead == Lead::kScapula);
    EXPECT_FALSE(binding.has_rates);
    for (std::size_t i = 0; i < kAllCommandCount; ++i) {
      const bool is_there = i < kCommandCount;
      ASSERT_EQ(binding.commands[i].exists(), is_there) << kAllCommandNames[i];
      if (is_there) {
        const int actuator = IdOf(*model, mjOBJ_ACTUATOR, names.Of(kAllCommandNames[i]));
        EXPECT_EQ(binding.commands[i].address, model->actuator_ctrladr[actuator]);
      }
    }
    const auto driven = DrivenCoordinates(GetParam().assembly);
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      ExpectServo(*model, binding.servos[k], names.Of(driven[k]));
    }
    for (std::size_t i = 0; binding.has_place_servos && i < kTranslationNames.size(); ++i) {
      ExpectServo(*model, binding.place_servos[i], names.Of(kTranslationNames[i]));
    }
    EXPECT_EQ(binding.thorax_body, IdOf(*model, mjOBJ_BODY, "thorax"));
    EXPECT_EQ(binding.humerus_body, IdOf(*model, mjOBJ_BODY, names.Of("humerus")));
    ASSERT_EQ(binding.sensors.size(), 1U);
    const int sensor = IdOf(*model, mjOBJ_SENSOR, names.Of(kRhythmName));
    EXPECT_EQ(binding.sensors.front().address, model->sensor_adr[sensor]);
  }
}

TEST_P(RhythmBindingTest, HasTheRangesOfTheHingesThatAreDriven) {
  const ModelPointer model = GetParam().Load(Sides::kRight);
  const RhythmBinding binding = Bound(*model, 0);
  const auto driven = DrivenCoordinates(GetParam().assembly);
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    const int joint = IdOf(*model, mjOBJ_JOINT, SidedName(driven[k], Side::kRight));
    EXPECT_EQ(binding.ranges[k].lower_rad, model->jnt_range[2 * joint]) << driven[k];
    EXPECT_EQ(binding.ranges[k].upper_rad, model->jnt_range[2 * joint + 1]) << driven[k];
  }
}

INSTANTIATE_TEST_SUITE_P(Models, RhythmBindingTest, testing::ValuesIn(PluginVariants()),
                         [](const auto& tested) { return NameOf(tested); });

using RhythmBindingOfOneModel = EngineTest;

TEST_F(RhythmBindingOfOneModel, OfALeftShoulderHasTheClaviclesPlaceTakenToTheRight) {
  const Variant leads = {"ScapulaLeads", Assembly::kLoop, Lead::kScapula};
  const ModelPointer model = leads.Load(Sides::kBoth);
  const Anatomy anatomy = BuiltInAnatomy();
  for (const int instance : kInstances) {
    const RhythmBinding binding = Bound(*model, instance);
    EXPECT_EQ(binding.p_TC_m, anatomy.landmark_m(Landmark::kSC));
    EXPECT_EQ(binding.p_CS_m, anatomy.landmark_m(Landmark::kPAC));
  }
}

TEST_F(RhythmBindingOfOneModel, HasCommandsOfOffsetsAndRatesWhereTheModelHas) {
  const ModelPointer model = LoadedModel(FullShoulderXml());
  const RhythmBinding binding = Bound(*model, 0);
  EXPECT_TRUE(binding.has_rates);
  for (std::size_t i = 0; i < kAllCommandCount; ++i) {
    const int actuator = IdOf(*model, mjOBJ_ACTUATOR, SidedName(kAllCommandNames[i], Side::kRight));
    EXPECT_EQ(binding.commands[i].address, model->actuator_ctrladr[actuator]);
  }
}

// A model with one servo changed, and what is said of it.
struct WrongServo {
  const char* name;
  void (*change)(mjModel& model, int actuator);
  const char* message;
};

class RhythmBindingOfWrongServo : public EngineTest,
                                  public testing::WithParamInterface<WrongServo> {};

TEST_P(RhythmBindingOfWrongServo, NamesTheElementAndTheFix) {
  EXPECT_EQ(Complaint([](const mjModel&) {}), "");
  const std::string complaint = Complaint([](mjModel& model) {
    GetParam().change(model, IdOf(model, mjOBJ_ACTUATOR, "gh_flexion_r"));
  });
  EXPECT_NE(complaint.find(GetParam().message), std::string::npos) << complaint;
}

INSTANTIATE_TEST_SUITE_P(
    Servos, RhythmBindingOfWrongServo,
    testing::Values(
        WrongServo{"WithoutARole",
                   [](mjModel& model, int actuator) {
                     std::strcpy(model.names + model.name_actuatoradr[actuator], "twist");
                   },
                   "actuator \"twist\" is a servo, but its name has none of: sc_protraction"},
        WrongServo{"OfARoleThatIsTaken",
                   [](mjModel& model, int actuator) {
                     std::strcpy(model.names + model.name_actuatoradr[actuator], "gh_axial");
                   },
                   "actuator \"gh_axial_r\" is a second servo for gh_axial. Remove one of the two"},
        WrongServo{"OnASlide",
                   [](mjModel& model, int actuator) {
                     model.jnt_type[model.actuator_trnid[2 * actuator]] = mjJNT_SLIDE;
                   },
                   "actuator \"gh_flexion_r\" does not act on a hinge. Give it "
                   "joint=\"gh_flexion_r\", a hinge"},
        WrongServo{"WithAGear",
                   [](mjModel& model, int actuator) {
                     model.actuator_gear[6 * model.actuator_outadr[actuator]] = 2;
                   },
                   "actuator \"gh_flexion_r\" has gear 2"},
        WrongServo{"OfAnotherInstance",
                   [](mjModel& model, int actuator) { model.actuator_plugin[actuator] = -1; },
                   "no servo for gh_flexion. Add <plugin name=\"gh_flexion_r\""}),
    [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace girdle::rhythm_binding_test
