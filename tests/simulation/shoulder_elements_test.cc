// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// What the simulation finds in models of left shoulders, of both, and of loops; how it tells what
/// is missing; and how it turns a left shoulder's state into a right one's.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <string>
#include <utility>
#include <vector>

#include "simulation/model_variants.h"
#include "simulation/plugin_fixture.h"
#include "simulation/shoulder_simulation.h"
#include "simulation/trace.h"
#include "text/input_error.h"

namespace girdle::shoulder_elements_test {
namespace {

// --- Tables --------------------------------------------------------------------------------------

TEST(ControlsHeader, NamesEachActuatorWithItsUnit) {
  EXPECT_EQ(ControlsHeader({"sc_rotation_r", "st_tilt_l", "st_anterior_l", "st_superior_r",
                            "st_lateral_r", "gh_axial_r"}),
            "time_s,sc_rotation_r_rad,st_tilt_l_rad,st_anterior_l_m,st_superior_r_m,"
            "st_lateral_r_m,gh_axial_r_rad\n");
}

TEST(ControlsRow, HasTheTimeAndNumbersThatReadBack) {
  std::string row = "before";
  AppendControlsRow(row, 0.002, {0.1, -1.5, 1.0 / 3});
  EXPECT_EQ(row, "before0.002,0.1,-1.5,0.3333333333333333\n");
}

std::vector<std::string> Columns(std::string header) {
  std::vector<std::string> columns;
  header.back() = ',';
  for (std::size_t at = 0; at < header.size();) {
    const std::size_t comma = header.find(',', at);
    columns.push_back(header.substr(at, comma - at));
    at = comma + 1;
  }
  return columns;
}

TEST(TraceHeader, OfALoopHasTheScapulaOnTheThoraxInThePlacesOfAc) {
  std::vector<std::string> expected = Columns(TraceHeader(Assembly::kTree));
  for (const auto& [ac, st] :
       {std::pair("ac_internal_rotation", "st_internal_rotation"),
        std::pair("ac_upward_rotation", "st_upward_rotation"), std::pair("ac_tilt", "st_tilt")}) {
    for (const char* const prefix : {"target_", ""}) {
      const auto found =
          std::find(expected.begin(), expected.end(), prefix + std::string(ac) + "_deg");
      ASSERT_NE(found, expected.end());
      *found = prefix + std::string(st) + "_deg";
    }
  }
  EXPECT_EQ(Columns(TraceHeader(Assembly::kLoop)), expected);
}

// --- Mirrored states -----------------------------------------------------------------------------

Matrix3 Diagonal(double x, double y, double z) { return {{x, 0, 0}, {0, y, 0}, {0, 0, z}}; }

TEST(MirroredToRight, IsTheMirrorImageByMatrices) {
  ShoulderState left;
  left.time_s = 1.5;
  left.command = {1, 0.5, 0.25};
  left.position_rad = {1, 2, 3, 4, 5, 6, 7, 8, 9};
  left.connect_force_N = 3;
  for (std::size_t i = 0; i < kSegmentCount; ++i) {
    const double turn = static_cast<double>(i);
    left.q_WB[i] = glm::normalize(Quaternion(0.3 + turn, -0.5, 0.2 * turn, 0.7));
  }
  for (std::size_t i = 0; i < kSiteCount; ++i) {
    left.site_m[i] = {0.1 * static_cast<double>(i), 0.3, -0.2};
  }
  const ShoulderState right = MirroredToRight(left);
  for (std::size_t i = 0; i < kSegmentCount; ++i) {
    // The world is mirrored across y, a bone's own frame across z.
    const Matrix3 expected = Diagonal(1, -1, 1) * glm::mat3_cast(left.q_WB[i]) * Diagonal(1, 1, -1);
    const Matrix3 found = glm::mat3_cast(right.q_WB[i]);
    for (int column = 0; column < 3; ++column) {
      EXPECT_LT(glm::distance(found[column], expected[column]), 1e-14) << i;
    }
  }
  for (std::size_t i = 0; i < kSiteCount; ++i) {
    EXPECT_EQ(right.site_m[i], Vector3(left.site_m[i].x, -0.3, -0.2)) << i;
  }
  EXPECT_EQ(right.time_s, left.time_s);
  EXPECT_EQ(right.command, left.command);
  EXPECT_EQ(right.position_rad, left.position_rad);
  EXPECT_EQ(right.connect_force_N, left.connect_force_N);
}

// --- Elements ------------------------------------------------------------------------------------

class FoundShoulders : public EngineTest, public testing::WithParamInterface<Variant> {};

INSTANTIATE_TEST_SUITE_P(Variants, FoundShoulders, testing::ValuesIn(AllVariants()), NameOf);

TEST_P(FoundShoulders, AreTheModelsWithTheRightOneFirst) {
  const Variant& variant = GetParam();
  for (const Sides sides : {Sides::kRight, Sides::kLeft, Sides::kBoth}) {
    const ModelPointer model = variant.Load(sides);
    const std::vector<Side> expected = SidesOf(sides);
    const auto shoulders = FindShoulders(*model, "model.xml");
    ASSERT_EQ(shoulders.size(), expected.size());
    for (std::size_t i = 0; i < shoulders.size(); ++i) {
      const ShoulderElements& found = shoulders[i];
      const ShoulderNames names{expected[i]};
      EXPECT_EQ(found.side, expected[i]);
      EXPECT_EQ(found.assembly, variant.assembly);
      EXPECT_EQ(found.lead, variant.lead);
      EXPECT_EQ(found.has_plugin(), variant.has_plugin());
      EXPECT_EQ(found.sensor >= 0, variant.has_plugin());
      EXPECT_EQ(found.connect >= 0, variant.assembly == Assembly::kLoop);
      const auto driven = DrivenCoordinates(variant.assembly);
      for (std::size_t k = 0; k < kCoordinateCount; ++k) {
        const int joint = IdOf(*model, mjOBJ_JOINT, names.Of(driven[k]));
        EXPECT_EQ(found.qpos[k], model->jnt_qposadr[joint]) << driven[k];
        const bool follows = variant.lead == Lead::kScapula && !variant.has_plugin() && k < 2;
        EXPECT_EQ(found.joint_controls[k],
                  follows
                      ? -1
                      : model->actuator_ctrladr[IdOf(*model, mjOBJ_ACTUATOR, names.Of(driven[k]))])
            << driven[k];
      }
      for (std::size_t k = 0; variant.assembly == Assembly::kLoop && k < 3; ++k) {
        const int joint = IdOf(*model, mjOBJ_JOINT, names.Of(kTranslationNames[k]));
        EXPECT_EQ(found.place_qpos[k], model->jnt_qposadr[joint]);
        EXPECT_EQ(found.place_controls[k] >= 0, variant.lead == Lead::kScapula);
      }
    }
  }
}

TEST_P(FoundShoulders, GiveTheControlSignalOfTheSameModelWithServos) {
  const Variant servos = {"servos", GetParam().assembly, GetParam().lead, Actuation::kPosition};
  const ModelPointer model = servos.Load(Sides::kBoth);
  std::vector<std::string> expected;
  expected.reserve(static_cast<std::size_t>(model->nactuator));
  for (int actuator = 0; actuator < model->nactuator; ++actuator) {
    expected.emplace_back(model->names + model->name_actuatoradr[actuator]);
  }
  ShoulderSimulation simulation({GetParam().Load(Sides::kBoth), "model.xml"},
                                {BuiltInRhythm(), GetParam().assembly});
  EXPECT_EQ(simulation.TargetNames(), expected);
  const ArmCommand command{1.2, 0.6, 0.2};
  simulation.ObserveAtTargets(command);
  const DataPointer data = MakeData(*model);
  for (const Side side : {Side::kRight, Side::kLeft}) {
    Command(*model, *data, servos, {side}, command);
  }
  const std::vector<double> targets = simulation.Targets();
  ASSERT_EQ(static_cast<int>(targets.size()), model->nu);
  for (int i = 0; i < model->nu; ++i) {
    // Through angles and back.
    EXPECT_NEAR(targets[static_cast<std::size_t>(i)], data->ctrl[i], 1e-14)
        << expected[static_cast<std::size_t>(i)];
  }
}

TEST_P(FoundShoulders, StartAndStayWhereTheCommandLeads) {
  const AssembledRhythm rhythm(BuiltInRhythm(), GetParam().assembly);
  ShoulderSimulation simulation({GetParam().Load(Sides::kBoth), "model.xml"}, rhythm);
  const ArmCommand command{1.2, 0.6, 0.2};
  const ShoulderPose pose = rhythm.SolvePose(command);
  for (const Side side : {Side::kRight, Side::kLeft}) {
    simulation.Watch(side);
    simulation.Start(command);
    for (int step = 0; step < 20; ++step) simulation.Step(command);
    ShoulderState state = simulation.Observe(command);
    if (side == Side::kLeft) state = MirroredToRight(state);
    const Quaternion q_WT = state.rotation(Segment::kThorax);
    EXPECT_LT(AngleBetween(state.rotation(Segment::kScapula), q_WT * pose.q_TS()), 1e-9);
    EXPECT_LT(AngleBetween(state.rotation(Segment::kHumerus), q_WT * pose.q_TH()), 1e-9);
    EXPECT_LT(glm::distance(state.landmark_m(Landmark::kPAC), state.child_site_m(1)), 1e-9);
    EXPECT_LT(glm::distance(
                  glm::conjugate(q_WT) * (state.child_site_m(1) - state.landmark_m(Landmark::kIJ)),
                  PlaceOfScapula(pose)),
              1e-9);
    EXPECT_FALSE(state.clamped);
  }
}

// Whatever is put in the plugin's configuration, or in the place of position servos' rhythm, moves
// the joints: no simulation is without one.
TEST_P(FoundShoulders, FollowTheirOwnRhythmOrTheOneThatServosAreGiven) {
  const ArmCommand command{0.6, 1.2, 0};
  const AssembledRhythm own(BuiltInRhythm(), GetParam().assembly);
  const AssembledRhythm other(BuiltInRhythm(kAsPublished), GetParam().assembly);
  ASSERT_GT(AngleBetween(own.SolvePose(command).q_TC, other.SolvePose(command).q_TC), 1e-3);
  const auto angles_of = [&](ShoulderSimulation simulation) {
    return simulation.ObserveAtTargets(command).position_rad;
  };
  const auto expect_near = [](const JointAngles& is_rad, const JointAngles& should_be_rad) {
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      EXPECT_NEAR(is_rad[k], should_be_rad[k], 1e-12) << k;
    }
  };
  const auto load = [] { return GetParam().Load(Sides::kRight); };
  expect_near(angles_of({load(), "model.xml"}), own.SolveAngles(command));
  expect_near(angles_of({{load(), "model.xml"}, other}),
              (GetParam().has_plugin() ? own : other).SolveAngles(command));
  EXPECT_EQ(ShoulderSimulation(load(), "model.xml").rhythm().rhythm().options().interpolation,
            Interpolation::kSmooth);
}

TEST_P(FoundShoulders, DoNotHaveASideThatTheModelLacks) {
  ShoulderSimulation simulation(GetParam().Load(Sides::kLeft), "model.xml");
  EXPECT_EQ(simulation.elements().side, Side::kLeft);
  try {
    simulation.Watch(Side::kRight);
    FAIL() << "watched";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()),
              "model.xml: has no right shoulder. Make one that has with girdle generate --side");
  }
}

// --- What is missing -----------------------------------------------------------------------------

// One name changed in the model of both.
struct Missing {
  const char* name;
  Variant variant;
  std::string from;
  std::string to;
  const char* message;
};

void PrintTo(const Missing& missing, std::ostream* out) { *out << missing.name; }

class MissingElement : public EngineTest, public testing::WithParamInterface<Missing> {};

std::string Replaced(const Missing& missing) {
  return girdle::Replaced(ShoulderXml(missing.variant.Options(Sides::kBoth)), missing.from,
                          missing.to);
}

TEST_P(MissingElement, IsNamedWithItsSide) {
  const ModelPointer model = LoadedModel(Replaced(GetParam()));
  try {
    (void)FindShoulders(*model, "model.xml");
    FAIL() << "found";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()), GetParam().message);
  }
}

const Variant kTree = {"Tree"};
const Variant kLoop = {"Loop", Assembly::kLoop};
const Variant kLoopServos = {"LoopServos", Assembly::kLoop, Lead::kClavicle, Actuation::kPosition};
const Variant kLeadServos = {"LeadServos", Assembly::kLoop, Lead::kScapula, Actuation::kPosition};

INSTANTIATE_TEST_SUITE_P(
    Names, MissingElement,
    testing::Values(
        Missing{"Connect", kLoop, "<connect name=\"AC_l\"", "<connect name=\"mine\"",
                "model.xml: has no equality \"AC_l\". Restore it, or make the model anew with "
                "girdle generate"},
        Missing{"Site", kTree, "<site name=\"TS_l\"", "<site name=\"TS\"",
                "model.xml: has no site \"TS_l\". Restore it, or make the model anew with girdle "
                "generate"},
        Missing{"Bone", kTree, "<body name=\"humerus_l\"", "<body name=\"arm\"",
                "model.xml: has no body \"humerus_l\". Restore it, or make the model anew with "
                "girdle generate"},
        Missing{"Sensor", kTree, "<plugin name=\"rhythm_l\"", "<plugin name=\"mine\"",
                "model.xml: has no sensor \"rhythm_l\". Restore it, or make the model anew with "
                "girdle generate"},
        Missing{"SensorOfTheOtherSide", kTree, "<plugin name=\"rhythm_l\" instance=\"rhythm_l\"",
                "<plugin name=\"rhythm_l\" instance=\"rhythm_r\"",
                "model.xml: sensor \"rhythm_l\" is not one of the plugin girdle.rhythm. Make it "
                "<plugin name=\"rhythm_l\" instance=\"rhythm_l\"/>, or make the model anew with "
                "girdle generate"},
        Missing{"Servo", kLoopServos, "<position name=\"st_tilt_l\"", "<position name=\"mine\"",
                "model.xml: has no actuator \"st_tilt_l\". Restore it, or make the model anew with "
                "girdle generate"},
        Missing{"ServoOfThePlace", kLeadServos, "<position name=\"st_lateral_l\"",
                "<position name=\"mine\"",
                "model.xml: has no actuator \"st_lateral_l\". Restore it, or make the model anew "
                "with girdle generate"},
        Missing{"SideOfTheInstance", kTree, "<config key=\"side\" value=\"left\"/>", "",
                "model.xml: the plugin's instance \"rhythm_l\" moves a right shoulder, and its "
                "elements end in _l. Set <config key=\"side\" value=\"left\"/>, or make the model "
                "anew with girdle generate"}),
    [](const auto& tested) { return tested.param.name; });

}  // namespace
}  // namespace girdle::shoulder_elements_test
