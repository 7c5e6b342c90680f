// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "mjcf/shoulder_model.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <iterator>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "anatomy/built_in_anatomy.h"
#include "kinematics/random_rotations.h"
#include "kinematics/shipped_data.h"
#include "mjcf/bone_meshes.h"
#include "mjcf/parsed_xml.h"
#include "names/joint_dynamics.h"
#include "names/model_names.h"
#include "rhythm_tables/built_in_tables.h"
#include "rhythm_tables/rhythm_config.h"
#include "rhythm_tables/rhythm_table_csv.h"
#include "text/csv_text.h"

namespace girdle {

void PrintTo(const Actuation& actuation, std::ostream* out) {
  *out << (actuation == Actuation::kPlugin ? "plugin" : "position");
}

}  // namespace girdle

namespace girdle::shoulder_model_test {
namespace {

// A few dozen roundings of numbers of size one.
constexpr double kRounding = 1e-14;
// Angles to and from quaternions.
constexpr double kAngleRounding_rad = 1e-12;

// Public names, written out: users' programs hold them.
constexpr std::array<const char*, kCoordinateCount> kJoints = {
    "sc_protraction_r",       "sc_elevation_r",       "sc_rotation_r",
    "ac_internal_rotation_r", "ac_upward_rotation_r", "ac_tilt_r",
    "gh_elevation_r",         "gh_flexion_r",         "gh_axial_r"};
constexpr std::array<const char*, kJointCount> kMovingBones = {"clavicle_r", "scapula_r",
                                                               "humerus_r"};

const Anatomy& BuiltIn() {
  static const Anatomy kAnatomy = BuiltInAnatomy();
  return kAnatomy;
}

// Smooth and exact over the whole range.
const ShoulderRhythm& DefaultRhythm() {
  static const ShoulderRhythm kRhythm = BuiltInRhythm();
  return kRhythm;
}

// As published.
const ShoulderRhythm& PublishedRhythm() {
  static const ShoulderRhythm kRhythm = BuiltInRhythm({Interpolation::kSquad, Closure::kTable});
  return kRhythm;
}

std::string Xml(const ShoulderRhythm& rhythm, const ShoulderModelOptions& options = {}) {
  return ShoulderModelXml(BuiltIn(), rhythm, options);
}

const ParsedXml& Model(Actuation actuation) {
  static const ParsedXml kPluginModel(Xml(DefaultRhythm()));
  static const ParsedXml kPositionModel(Xml(DefaultRhythm(), {.actuation = Actuation::kPosition}));
  return actuation == Actuation::kPlugin ? kPluginModel : kPositionModel;
}

const ParsedXml& PublishedModel() {
  static const ParsedXml kModel(Xml(PublishedRhythm(), {.table = BuiltInTable::kMeasured}));
  return kModel;
}

// With commands for offsets and rates.
const ParsedXml& FullModel() {
  static const ParsedXml kModel(Xml(DefaultRhythm(), {.has_offsets = true, .has_rates = true}));
  return kModel;
}

// Text of one key of the plugin's configuration; empty if it is not there.
std::string Config(const ParsedXml& model, const std::string& key) {
  for (const auto* config : model.All("config")) {
    if (TextOf(*config, "key") == key) return TextOf(*config, "value");
  }
  return "";
}

RhythmConfig ConfigOf(const ParsedXml& model) {
  return ParseRhythmConfig({Config(model, "interpolation"), Config(model, "closure"),
                            Config(model, "range"), Config(model, "table"), Config(model, "kp")});
}

std::string Printed(const tinyxml2::XMLElement& element) {
  tinyxml2::XMLPrinter printer;
  element.Accept(&printer);
  return printer.CStr();
}

class EitherActuation : public testing::TestWithParam<Actuation> {
 protected:
  static const ParsedXml& model() { return Model(GetParam()); }
};

INSTANTIATE_TEST_SUITE_P(Actuations, EitherActuation,
                         testing::Values(Actuation::kPlugin, Actuation::kPosition),
                         [](const auto& tested) {
                           return tested.param == Actuation::kPlugin ? "Plugin" : "Position";
                         });

TEST_P(EitherActuation, HangsEachBoneOnTheOneBefore) {
  std::string parent = "thorax";
  for (const char* const bone : kMovingBones) {
    const auto* const above = model().Named("body", bone).Parent()->ToElement();
    EXPECT_EQ(TextOf(*above, "name"), parent);
    parent = bone;
  }
  EXPECT_EQ(model().All("body").size(), 4U);
}

TEST_P(EitherActuation, HasNineHingesInTurningOrder) {
  std::vector<std::string> names;
  for (const auto* joint : model().Parts("joint")) {
    names.push_back(TextOf(*joint, "name"));
    EXPECT_EQ(joint->Attribute("type"), nullptr) << "a joint without a type is a hinge";
  }
  EXPECT_EQ(names, (std::vector<std::string>{kJoints.begin(), kJoints.end()}));
}

TEST_P(EitherActuation, HasThreeHingesOnEachMovingBone) {
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    const auto* const body = model().Named("joint", kJoints[k]).Parent()->ToElement();
    EXPECT_EQ(TextOf(*body, "name"), kMovingBones[k / 3]);
  }
}

TEST_P(EitherActuation, KeepsTheAnatomysJointRanges) {
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    const auto range = NumbersOf(model().Named("joint", kJoints[k]), "range");
    ASSERT_EQ(range.size(), 2U);
    EXPECT_EQ(range[0], BuiltIn().ranges[k].lower_rad) << kJoints[k];
    EXPECT_EQ(range[1], BuiltIn().ranges[k].upper_rad) << kJoints[k];
  }
}

TEST_P(EitherActuation, StandsWhereControlsOfZeroLead) {
  const JointAngles zero_rad = AnglesFromPose(DefaultRhythm().SolvePose({}));
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    EXPECT_NEAR(NumberOf(model().Named("joint", kJoints[k]), "ref"), zero_rad[k],
                kAngleRounding_rad)
        << kJoints[k];
  }
}

// The first row of the file: elevation 15 in the frontal plane.
TEST(PublishedModel, StandsAtTheLowestMeasuredPosition) {
  const MeasuredRow lowest = MeasuredRows().front();
  ASSERT_EQ(lowest.elevation_deg, 15);
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    EXPECT_NEAR(NumberOf(PublishedModel().Named("joint", kJoints[k]), "ref"),
                RadiansFromDegrees(lowest.angles_deg[k]), kAngleRounding_rad)
        << kJoints[k];
  }
}

TEST_P(EitherActuation, StandsWithinItsRanges) {
  for (const auto* joint : model().Parts("joint")) {
    const auto range = NumbersOf(*joint, "range");
    EXPECT_LT(range[0], NumberOf(*joint, "ref")) << TextOf(*joint, "name");
    EXPECT_GT(range[1], NumberOf(*joint, "ref")) << TextOf(*joint, "name");
  }
}

TEST_P(EitherActuation, TakesDampingAndArmatureFromItsDynamics) {
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    const auto& joint = model().Named("joint", kJoints[k]);
    EXPECT_EQ(NumberOf(joint, "damping"), kJointDynamics[k / 3].damping_N_m_s_per_rad);
    EXPECT_EQ(NumberOf(joint, "armature"), kJointDynamics[k / 3].armature_kg_m2);
  }
}

// Its meaning differs between versions of MuJoCo.
TEST_P(EitherActuation, HasNoDampingRatio) {
  for (const auto* element : model().All("")) {
    EXPECT_EQ(element->Attribute("dampratio"), nullptr) << element->Name();
  }
}

TEST_P(EitherActuation, IsInRadiansAndIntegratedImplicitly) {
  EXPECT_EQ(TextOf(model().Child("compiler"), "angle"), "radian");
  EXPECT_EQ(TextOf(model().Child("option"), "integrator"), "implicitfast");
}

TEST_P(EitherActuation, CarriesTheMovingBonesAgainstGravity) {
  for (const char* const bone : kMovingBones) {
    EXPECT_EQ(NumberOf(model().Named("body", bone), "gravcomp"), 1) << bone;
  }
}

// Right-multiplied in the order of the file, each about its axis in the bone's frame: MuJoCo's
// manual, "Kinematics".
Quaternion MujocoRotation(const tinyxml2::XMLElement& body,
                          const std::array<double, 3>& positions_rad) {
  Quaternion q = QuaternionIn(body, "quat");
  std::size_t hinge = 0;
  for (const auto* joint = body.FirstChildElement("joint"); joint != nullptr;
       joint = joint->NextSiblingElement("joint")) {
    const double half_rad = (positions_rad.at(hinge) - NumberOf(*joint, "ref")) / 2;
    const Vector3 axis = std::sin(half_rad) * VectorIn(*joint, "axis");
    q = q * Quaternion(std::cos(half_rad), axis.x, axis.y, axis.z);
    ++hinge;
  }
  return q;
}

RC_GTEST_PROP(JointCoordinates, AreTheMeasuredEulerAngles, ()) {
  const ParsedXml& model = Model(*rc::gen::element(Actuation::kPlugin, Actuation::kPosition));
  for (std::size_t joint = 0; joint < kJointCount; ++joint) {
    const std::array<double, 3> angles_rad = {*NumberWithin(-kPi, kPi), *NumberWithin(-kPi, kPi),
                                              *NumberWithin(-kPi, kPi)};
    const Quaternion expected =
        QuaternionFromEuler(kJointSequences[joint], {angles_rad[0], angles_rad[1], angles_rad[2]});
    const Quaternion q = MujocoRotation(model.Named("body", kMovingBones[joint]), angles_rad);
    RC_ASSERT(AngleBetween(q, expected) < kRounding);
  }
}

TEST_P(EitherActuation, HasHingeAxesOfUnitLength) {
  for (const auto* joint : model().Parts("joint")) {
    EXPECT_NEAR(glm::length(VectorIn(*joint, "axis")), 1, kRounding) << TextOf(*joint, "name");
  }
}

TEST_P(EitherActuation, PutsTheThoraxUpright) {
  const Quaternion q_WT = QuaternionIn(model().Named("body", "thorax"), "quat");
  EXPECT_LT(glm::length(q_WT * Vector3(1, 0, 0) - Vector3(1, 0, 0)), kRounding) << "forward";
  EXPECT_LT(glm::length(q_WT * Vector3(0, 1, 0) - Vector3(0, 0, 1)), kRounding) << "up";
  EXPECT_LT(glm::length(q_WT * Vector3(0, 0, 1) - Vector3(0, -1, 0)), kRounding) << "right";
}

TEST_P(EitherActuation, HangsTheBonesAtTheirJoints) {
  const auto shipped_m = ShippedLandmarks();
  EXPECT_EQ(VectorIn(model().Named("body", "clavicle_r"), "pos"), shipped_m.at("SC"));
  EXPECT_EQ(VectorIn(model().Named("body", "scapula_r"), "pos"), shipped_m.at("PAC"));
  EXPECT_EQ(VectorIn(model().Named("body", "humerus_r"), "pos"), shipped_m.at("GH"));
}

TEST_P(EitherActuation, HasASiteAtEveryLandmark) {
  for (const auto& row : ShippedRows("landmarks.csv")) {
    const std::string& landmark = row.at(0);
    const std::string& segment = row.at(1);
    const bool is_in_the_middle =
        landmark == "IJ" || landmark == "PX" || landmark == "C7" || landmark == "T8";
    const auto& site = model().Named("site", is_in_the_middle ? landmark : landmark + "_r");
    EXPECT_EQ(VectorIn(site, "pos"), ShippedLandmarks().at(landmark)) << landmark;
    EXPECT_EQ(TextOf(*site.Parent()->ToElement(), "name"),
              segment == "thorax" ? segment : segment + "_r")
        << landmark;
  }
}

TEST_P(EitherActuation, HasASecondSiteWhereABoneMeetsTheNext) {
  for (const auto& [name, bone] :
       {std::pair("SC_clavicle_r", "clavicle_r"), std::pair("PAC_scapula_r", "scapula_r"),
        std::pair("GH_humerus_r", "humerus_r")}) {
    const auto& site = model().Named("site", name);
    EXPECT_EQ(site.Attribute("pos"), nullptr) << name << " lies at the origin of its bone";
    EXPECT_EQ(TextOf(*site.Parent()->ToElement(), "name"), bone);
  }
}

TEST_P(EitherActuation, HasTheAnatomysMasses) {
  for (const auto& row : ShippedRows("segments.csv")) {
    const std::string body = row.at(0) == "thorax" ? row.at(0) : row.at(0) + "_r";
    const auto* const inertial = model().Named("body", body).FirstChildElement("inertial");
    ASSERT_NE(inertial, nullptr) << body;
    EXPECT_EQ(NumberOf(*inertial, "mass"), std::stod(row.at(1))) << body;
    EXPECT_EQ(VectorIn(*inertial, "pos"),
              Vector3(std::stod(row.at(2)), std::stod(row.at(3)), std::stod(row.at(4))))
        << body;
    EXPECT_EQ(VectorIn(*inertial, "diaginertia"),
              Vector3(std::stod(row.at(5)), std::stod(row.at(6)), std::stod(row.at(7))))
        << body;
  }
}

struct NamedPlace {
  const char* name;
  double elevation_deg;
  double plane_deg;
};

constexpr NamedPlace kPlaces[] = {
    {"hanging", 0, 0},         {"relaxed", 0, 0},       {"abduction_30", 30, 0},
    {"abduction_60", 60, 0},   {"abduction_90", 90, 0}, {"abduction_120", 120, 0},
    {"abduction_150", 150, 0}, {"flexion_90", 90, 90},  {"across_90", 90, 120}};

// The lowest position that is measured stands for rest.
constexpr NamedPlace kPublishedPlaces[] = {{"hanging", 15, 0},        {"abduction_30", 30, 0},
                                           {"abduction_60", 60, 0},   {"abduction_90", 90, 0},
                                           {"abduction_120", 120, 0}, {"flexion_90", 90, 90}};

ArmCommand CommandOf(const NamedPlace& place) {
  return {RadiansFromDegrees(place.elevation_deg), RadiansFromDegrees(place.plane_deg)};
}

template <std::size_t N>
void ExpectKeyframes(const ParsedXml& model, const NamedPlace (&places)[N]) {
  const auto keys = model.All("key");
  ASSERT_EQ(keys.size(), N);
  for (std::size_t i = 0; i < N; ++i) {
    EXPECT_EQ(TextOf(*keys[i], "name"), places[i].name);
  }
}

TEST_P(EitherActuation, HasAKeyframeForEachNamedPose) { ExpectKeyframes(model(), kPlaces); }

TEST(PublishedModel, HasNoKeyframesOutsideTheMeasuredDomain) {
  ExpectKeyframes(PublishedModel(), kPublishedPlaces);
}

TEST_P(EitherActuation, StandsInItsKeyframesWhereTheRhythmLeads) {
  for (const NamedPlace& place : kPlaces) {
    if (std::string(place.name) == "relaxed") continue;
    const auto qpos = NumbersOf(model().Named("key", place.name), "qpos");
    const JointAngles target_rad = AnglesFromPose(DefaultRhythm().SolvePose(CommandOf(place)));
    EXPECT_EQ(qpos, std::vector<double>(target_rad.begin(), target_rad.end())) << place.name;
  }
}

// Ludewig et al. 2009, relaxed standing; the arm hangs as it does at rest.
TEST_P(EitherActuation, StandsAsMeasuredWhenRelaxed) {
  constexpr double kPublished_deg[] = {-19.2, -5.9, 0, 60, -2.5, -8.4};
  const auto qpos = NumbersOf(model().Named("key", "relaxed"), "qpos");
  ASSERT_EQ(qpos.size(), kCoordinateCount);
  for (std::size_t k = 0; k < std::size(kPublished_deg); ++k) {
    EXPECT_NEAR(qpos[k], RadiansFromDegrees(kPublished_deg[k]), kAngleRounding_rad) << kJoints[k];
  }
  JointAngles angles_rad{};
  std::copy(qpos.begin(), qpos.end(), angles_rad.begin());
  EXPECT_LT(AngleBetween(PoseFromAngles(angles_rad).q_TH(), DefaultRhythm().SolvePose({}).q_TH()),
            kAngleRounding_rad);
}

// Every named pose of the measured domain lies on a measured position.
TEST(PublishedModel, StandsAtTheMeasuredAnglesInItsKeyframes) {
  for (const NamedPlace& place : kPublishedPlaces) {
    const auto qpos = NumbersOf(PublishedModel().Named("key", place.name), "qpos");
    ASSERT_EQ(qpos.size(), kCoordinateCount) << place.name;
    int rows = 0;
    for (const MeasuredRow& row : MeasuredRows()) {
      if (row.elevation_deg != place.elevation_deg || row.plane_deg != place.plane_deg) continue;
      for (std::size_t k = 0; k < kCoordinateCount; ++k) {
        EXPECT_NEAR(qpos[k], RadiansFromDegrees(row.angles_deg[k]), kAngleRounding_rad)
            << place.name << ", " << kJoints[k];
      }
      ++rows;
    }
    EXPECT_EQ(rows, 1) << place.name;
  }
}

template <std::size_t N>
void ExpectKeyframeCommands(const ParsedXml& model, const NamedPlace (&places)[N],
                            std::size_t controls) {
  for (const NamedPlace& place : places) {
    if (std::string(place.name) == "relaxed") continue;
    const auto ctrl = NumbersOf(model.Named("key", place.name), "ctrl");
    std::vector<double> expected(controls);
    expected[0] = RadiansFromDegrees(place.elevation_deg);
    expected[1] = RadiansFromDegrees(place.plane_deg);
    EXPECT_EQ(ctrl, expected) << place.name;
  }
}

TEST(PluginModel, CommandsItsKeyframesToTheirElevationAndPlane) {
  ExpectKeyframeCommands(Model(Actuation::kPlugin), kPlaces, kCommandCount + kCoordinateCount);
  ExpectKeyframeCommands(PublishedModel(), kPublishedPlaces, kCommandCount + kCoordinateCount);
  ExpectKeyframeCommands(FullModel(), kPlaces, kAllCommandCount + kCoordinateCount);
}

// Where the servos aim, with their trims, is where the keyframe stands.
TEST(PluginModel, HoldsTheRelaxedKeyframeByTrimsWithinTheirRanges) {
  for (const auto& [model, commands] : {std::pair(&Model(Actuation::kPlugin), kCommandCount),
                                        std::pair(&FullModel(), kAllCommandCount)}) {
    const auto& key = model->Named("key", "relaxed");
    const auto ctrl = NumbersOf(key, "ctrl");
    const auto qpos = NumbersOf(key, "qpos");
    ASSERT_EQ(ctrl.size(), commands + kCoordinateCount);
    EXPECT_EQ(std::count(ctrl.begin(), ctrl.begin() + static_cast<std::ptrdiff_t>(commands), 0.0),
              static_cast<std::ptrdiff_t>(commands));
    const JointAngles target_rad = AnglesFromPose(DefaultRhythm().SolvePose({}));
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      const double trim_rad = ctrl[commands + k];
      const auto range = NumbersOf(model->Named("plugin", kJoints[k]), "ctrlrange");
      EXPECT_NEAR(target_rad[k] + trim_rad, qpos[k], kAngleRounding_rad) << kJoints[k];
      EXPECT_GT(trim_rad, range.at(0)) << kJoints[k];
      EXPECT_LT(trim_rad, range.at(1)) << kJoints[k];
    }
  }
}

TEST(PositionModel, CommandsTheJointsToTheirKeyframes) {
  for (const auto* key : Model(Actuation::kPosition).All("key")) {
    EXPECT_EQ(NumbersOf(*key, "ctrl"), NumbersOf(*key, "qpos")) << TextOf(*key, "name");
  }
}

TEST_P(EitherActuation, HasNoNumberThatIsNotFiniteOrIsMinusZero) {
  EXPECT_EQ(BadNumbers(model()), std::vector<std::string>());
}

TEST(PluginModel, HasThreeCommandsAndNineServosOnOneInstance) {
  const auto& actuator = Model(Actuation::kPlugin).Child("actuator");
  std::vector<std::string> names;
  for (const auto* plugin : ParsedXml::All(actuator, "")) {
    EXPECT_STREQ(plugin->Name(), "plugin");
    EXPECT_EQ(TextOf(*plugin, "instance"), "rhythm_r");
    names.push_back(TextOf(*plugin, "name"));
  }
  std::vector<std::string> expected = {"elevation_r", "plane_r", "axial_r"};
  expected.insert(expected.end(), kJoints.begin(), kJoints.end());
  EXPECT_EQ(names, expected);
}

TEST(PluginModel, HasCommandsWithoutForce) {
  const ParsedXml& model = Model(Actuation::kPlugin);
  for (const char* const command : {"elevation_r", "plane_r", "axial_r"}) {
    EXPECT_EQ(NumberOf(model.Named("plugin", command), "gear"), 0) << command;
  }
}

TEST(PluginModel, HasServosOnTheirOwnJoints) {
  const ParsedXml& model = Model(Actuation::kPlugin);
  for (const char* const joint : kJoints) {
    const auto& servo = model.Named("plugin", joint);
    EXPECT_EQ(TextOf(servo, "joint"), joint);
    EXPECT_EQ(servo.Attribute("gear"), nullptr) << joint << " would be taken for a command";
  }
}

TEST(PluginModel, TakesCommandsForAllThatAnArmReaches) {
  const ParsedXml& model = Model(Actuation::kPlugin);
  EXPECT_EQ(NumbersOf(model.Named("plugin", "elevation_r"), "ctrlrange"),
            (std::vector<double>{0, RadiansFromDegrees(180)}));
  EXPECT_EQ(NumbersOf(model.Named("plugin", "plane_r"), "ctrlrange"),
            (std::vector<double>{-kPi, kPi}))
      << "an angle: the rhythm answers what is not reached";
}

TEST(PublishedModel, TakesElevationsWithinTheTableAndEveryPlane) {
  EXPECT_EQ(NumbersOf(PublishedModel().Named("plugin", "elevation_r"), "ctrlrange"),
            (std::vector<double>{RadiansFromDegrees(15), RadiansFromDegrees(120)}));
  EXPECT_EQ(NumbersOf(PublishedModel().Named("plugin", "plane_r"), "ctrlrange"),
            (std::vector<double>{-kPi, kPi}));
}

// Somewhere among the arm's directions the joint has room for all of the command and no more.
TEST(PluginModel, TakesAxialCommandsAsFarAsTheJointHasRoomAnywhere) {
  const ParsedXml& model = Model(Actuation::kPlugin);
  const auto command = NumbersOf(model.Named("plugin", "axial_r"), "ctrlrange");
  const auto range = NumbersOf(model.Named("joint", "gh_axial_r"), "range");
  const ShoulderRhythm rhythm = BuiltInRhythm();
  double lowest_rad = kPi;
  double highest_rad = -kPi;
  constexpr double kStep_rad = 1 * kRadiansPerDegree;
  for (double elevation_rad = 0; elevation_rad <= kPi; elevation_rad += kStep_rad) {
    for (double plane_rad = -kPi; plane_rad <= kPi; plane_rad += kStep_rad) {
      const ShoulderSolution solution = rhythm.Solve({elevation_rad, plane_rad});
      if (!solution.clamped) {
        const double axial_rad = AnglesFromPose(solution.pose)[kGhAxialIndex];
        lowest_rad = std::min(lowest_rad, axial_rad);
        highest_rad = std::max(highest_rad, axial_rad);
      }
    }
  }
  constexpr double kBetweenSteps_rad = 1 * kRadiansPerDegree;
  EXPECT_NEAR(highest_rad + command.at(0), range.at(0), kBetweenSteps_rad);
  EXPECT_NEAR(lowest_rad + command.at(1), range.at(1), kBetweenSteps_rad);
}

std::vector<std::string> ActuatorNames(const ParsedXml& model) {
  std::vector<std::string> names;
  for (const auto* actuator : ParsedXml::All(model.Child("actuator"), "")) {
    names.push_back(TextOf(*actuator, "name"));
  }
  return names;
}

TEST(PluginModel, TakesOffsetsAndRatesWhereTheyAreWanted) {
  struct Wanted {
    ShoulderModelOptions options;
    std::vector<std::string> commands;
  };
  const std::vector<Wanted> choices = {
      {{.has_offsets = true}, {"elevation_r", "plane_r", "axial_r", "shrug_r", "protraction_r"}},
      {{.has_rates = true},
       {"elevation_r", "plane_r", "axial_r", "elevation_rate_r", "plane_rate_r", "axial_rate_r"}},
      {{.has_offsets = true, .has_rates = true},
       {"elevation_r", "plane_r", "axial_r", "shrug_r", "protraction_r", "elevation_rate_r",
        "plane_rate_r", "axial_rate_r"}}};
  for (const auto& [options, commands] : choices) {
    std::vector<std::string> expected = commands;
    expected.insert(expected.end(), kJoints.begin(), kJoints.end());
    EXPECT_EQ(ActuatorNames(ParsedXml(Xml(DefaultRhythm(), options))), expected);
  }
}

TEST(PluginModel, HasOffsetsAndRatesWithoutForceAndWithRanges) {
  for (const char* const command :
       {"shrug_r", "protraction_r", "elevation_rate_r", "plane_rate_r", "axial_rate_r"}) {
    const auto& actuator = FullModel().Named("plugin", command);
    EXPECT_EQ(NumberOf(actuator, "gear"), 0) << command;
    EXPECT_EQ(TextOf(actuator, "instance"), "rhythm_r") << command;
    const auto range = NumbersOf(actuator, "ctrlrange");
    EXPECT_LT(range.at(0), 0) << command;
    EXPECT_GT(range.at(1), 0) << command;
  }
  EXPECT_EQ(NumbersOf(FullModel().Named("plugin", "shrug_r"), "ctrlrange"),
            (std::vector<double>{RadiansFromDegrees(-15), RadiansFromDegrees(35)}));
  EXPECT_EQ(NumbersOf(FullModel().Named("plugin", "protraction_r"), "ctrlrange"),
            (std::vector<double>{RadiansFromDegrees(-25), RadiansFromDegrees(30)}));
}

// Offsets and rates are commands alone: the body is the same.
TEST(PluginModel, IsTheSameBodyWithOffsetsAndRates) {
  for (const char* const part : {"extension", "default", "asset", "worldbody", "sensor"}) {
    EXPECT_EQ(Printed(FullModel().Child(part)), Printed(Model(Actuation::kPlugin).Child(part)))
        << part;
  }
}

TEST(ShoulderModel, RefusesRatesThatTheInterpolationDoesNotHave) {
  for (const Interpolation interpolation : {Interpolation::kSquad, Interpolation::kSlerp}) {
    const ShoulderRhythm rhythm = BuiltInRhythm({interpolation, Closure::kTable});
    EXPECT_EQ(
        MessageOf<std::invalid_argument>([&] {
          static_cast<void>(Xml(rhythm, {.table = BuiltInTable::kMeasured, .has_rates = true}));
        }),
        "rate commands need the interpolation smooth")
        << Name(interpolation);
  }
}

TEST(PluginModel, HasTheSensorOfItsInstance) {
  const auto sensors = ParsedXml::All(Model(Actuation::kPlugin).Child("sensor"), "plugin");
  ASSERT_EQ(sensors.size(), 1U);
  EXPECT_EQ(TextOf(*sensors[0], "name"), "rhythm_r");
  EXPECT_EQ(TextOf(*sensors[0], "instance"), "rhythm_r");
}

TEST(PluginModel, NamesThePluginOfItsInstance) {
  const ParsedXml& model = Model(Actuation::kPlugin);
  const auto& instance = model.Named("instance", "rhythm_r");
  EXPECT_EQ(TextOf(*instance.Parent()->ToElement(), "plugin"), "girdle.rhythm");
}

struct Chosen {
  RhythmOptions options;
  std::optional<BuiltInTable> table;
};

class ChosenRhythm : public testing::TestWithParam<Chosen> {};

// What the plugin reads is what the model was made of.
TEST_P(ChosenRhythm, IsTheOneThatTheModelSays) {
  const auto& [options, table] = GetParam();
  const ShoulderRhythm rhythm(BuiltInRhythmTable(table.value_or(BuiltInTable::kMeasured)), options,
                              BuiltIn().ranges);
  const RhythmConfig config = ConfigOf(ParsedXml(Xml(rhythm, {.table = table})));
  EXPECT_EQ(config.rhythm.interpolation, options.interpolation);
  EXPECT_EQ(config.rhythm.closure, options.closure);
  EXPECT_EQ(config.rhythm.range, rhythm.options().range);
  EXPECT_EQ(RhythmTableToLine(Resolve(config.rhythm).table), RhythmTableToLine(rhythm.table()));
}

INSTANTIATE_TEST_SUITE_P(
    Words, ChosenRhythm,
    testing::Values(Chosen{{}, BuiltInTable::kSmoothed}, Chosen{{}, BuiltInTable::kMeasured},
                    Chosen{{}, std::nullopt},
                    Chosen{{Interpolation::kSmooth, Closure::kExact, Range::kClamp},
                           BuiltInTable::kSmoothed},
                    Chosen{{Interpolation::kSmooth, Closure::kTable}, BuiltInTable::kSmoothed},
                    Chosen{{Interpolation::kSquad, Closure::kTable}, BuiltInTable::kMeasured},
                    Chosen{{Interpolation::kSquad, Closure::kTable}, std::nullopt},
                    Chosen{{Interpolation::kSlerp, Closure::kExact}, BuiltInTable::kMeasured}));

TEST(PluginModel, SaysInWordsWhatItIsMadeOf) {
  const ParsedXml& model = Model(Actuation::kPlugin);
  EXPECT_EQ(Config(model, "interpolation"), "smooth");
  EXPECT_EQ(Config(model, "closure"), "exact");
  EXPECT_EQ(Config(model, "range"), "whole");
  EXPECT_EQ(Config(model, "table"), "smoothed");
}

TEST(PublishedModel, SaysInWordsWhatItIsMadeOf) {
  EXPECT_EQ(Config(PublishedModel(), "interpolation"), "squad");
  EXPECT_EQ(Config(PublishedModel(), "closure"), "table");
  EXPECT_EQ(Config(PublishedModel(), "range"), "clamp");
  EXPECT_EQ(Config(PublishedModel(), "table"), "measured");
}

TEST(PluginModel, HasTheStiffnessesOfItsDynamics) {
  const RhythmConfig config = ConfigOf(Model(Actuation::kPlugin));
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    EXPECT_EQ(config.stiffness_N_m_per_rad[k], kJointDynamics[k / 3].stiffness_N_m_per_rad)
        << kJoints[k];
  }
}

// The built-in rows with one angle changed, so that the built-in table cannot stand in for it.
RhythmTable OtherTable() {
  std::vector<MeasuredRow> rows = MeasuredRows();
  rows.front().angles_deg[1] -= 2.5;
  return TableOf(rows);
}

TEST(PluginModel, CarriesATableThatReadsBack) {
  const ParsedXml model(
      Xml(ShoulderRhythm(OtherTable(), {}, BuiltIn().ranges), {.table = std::nullopt}));
  const RhythmTable table = RhythmTableFromLine(Config(model, "table"), "config");
  EXPECT_EQ(table.planes_rad(), OtherTable().planes_rad());
  EXPECT_EQ(table.elevations_rad(), OtherTable().elevations_rad());
  for (std::size_t plane = 0; plane < table.planes_rad().size(); ++plane) {
    for (std::size_t elevation = 0; elevation < table.elevations_rad().size(); ++elevation) {
      EXPECT_EQ(table.position(plane, elevation).angles_rad,
                OtherTable().position(plane, elevation).angles_rad)
          << "plane " << plane << ", elevation " << elevation;
    }
  }
}

TEST(ShoulderModel, OfAnotherTableStandsAtThatTablesLowestPosition) {
  const ShoulderRhythm rhythm(OtherTable(), {Interpolation::kSquad, Closure::kTable});
  const ParsedXml model(Xml(rhythm, {.table = std::nullopt}));
  EXPECT_NEAR(NumberOf(model.Named("joint", "sc_elevation_r"), "ref"),
              OtherTable().position(0, 0).angles_rad[1], kAngleRounding_rad);
}

TEST(ShoulderModel, OfAnotherAnatomyHasItsLandmarksAndMasses) {
  Anatomy anatomy = BuiltIn();
  anatomy.landmarks_m[static_cast<std::size_t>(Landmark::kGH)] = {0.009, -0.05, -0.006};
  anatomy.segments[static_cast<std::size_t>(Segment::kHumerus)].mass_kg = 2.5;
  const ParsedXml model(ShoulderModelXml(anatomy, DefaultRhythm()));
  const auto& humerus = model.Named("body", "humerus_r");
  EXPECT_EQ(VectorIn(humerus, "pos"), Vector3(0.009, -0.05, -0.006));
  EXPECT_EQ(VectorIn(model.Named("site", "GH_r"), "pos"), Vector3(0.009, -0.05, -0.006));
  EXPECT_EQ(NumberOf(*humerus.FirstChildElement("inertial"), "mass"), 2.5);
}

TEST(PositionModel, HasNinePositionServosWithTheSameGains) {
  const auto servos = ParsedXml::All(Model(Actuation::kPosition).Child("actuator"), "");
  const RhythmConfig plugin = ConfigOf(Model(Actuation::kPlugin));
  ASSERT_EQ(servos.size(), kCoordinateCount);
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    EXPECT_STREQ(servos[k]->Name(), "position");
    EXPECT_EQ(TextOf(*servos[k], "name"), kJoints[k]);
    EXPECT_EQ(TextOf(*servos[k], "joint"), kJoints[k]);
    EXPECT_EQ(NumberOf(*servos[k], "kp"), plugin.stiffness_N_m_per_rad[k]) << kJoints[k];
  }
}

TEST(PositionModel, TakesTargetsWithinTheJointRanges) {
  const ParsedXml& model = Model(Actuation::kPosition);
  for (const char* const joint : kJoints) {
    EXPECT_EQ(NumbersOf(model.Named("position", joint), "ctrlrange"),
              NumbersOf(model.Named("joint", joint), "range"))
        << joint;
  }
}

TEST(PositionModel, HasNoPlugin) {
  for (const auto* element : Model(Actuation::kPosition).All("")) {
    EXPECT_STRNE(element->Name(), "plugin");
    EXPECT_STRNE(element->Name(), "extension");
  }
}

TEST(PositionModel, IsTheSameBodyAsThePluginModel) {
  for (const char* const part : {"compiler", "option", "asset", "worldbody"}) {
    EXPECT_EQ(Printed(Model(Actuation::kPosition).Child(part)),
              Printed(Model(Actuation::kPlugin).Child(part)))
        << part;
  }
}

TEST(ShoulderModel, IsTheSameTextEveryTime) {
  EXPECT_EQ(Xml(DefaultRhythm()), ShoulderModelXml(BuiltInAnatomy(), BuiltInRhythm()));
}

// It would load, and be another rhythm's.
TEST(ShoulderModel, RefusesToNameATableThatIsNotItsOwn) {
  EXPECT_EQ(MessageOf<std::invalid_argument>([] {
              static_cast<void>(Xml(PublishedRhythm(), {.table = BuiltInTable::kSmoothed}));
            }),
            "the rhythm's table is not the built-in table smoothed. Name the one that it is, or "
            "none");
  EXPECT_EQ(MessageOf<std::invalid_argument>([] {
              static_cast<void>(Xml(ShoulderRhythm(OtherTable(), {}, BuiltIn().ranges),
                                    {.table = BuiltInTable::kMeasured}));
            }),
            "the rhythm's table is not the built-in table measured. Name the one that it is, or "
            "none");
}

struct Outside {
  const char* name;
  std::size_t coordinate;
  double angle_deg;
  const char* message;
};

void PrintTo(const Outside& outside, std::ostream* out) { *out << outside.name; }

class TableOutsideTheRanges : public testing::TestWithParam<Outside> {};

TEST_P(TableOutsideTheRanges, IsRefusedWithValuePlaceAndRange) {
  constexpr std::size_t kPlane40Elevation60 = 22 + 9;
  std::vector<MeasuredRow> rows = MeasuredRows();
  rows[kPlane40Elevation60].angles_deg[GetParam().coordinate] = GetParam().angle_deg;
  const ShoulderRhythm rhythm(TableOf(rows), {Interpolation::kSquad, Closure::kTable});
  EXPECT_EQ(MessageOf<std::invalid_argument>(
                [&] { static_cast<void>(Xml(rhythm, {.table = std::nullopt})); }),
            GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    OneAngleEach, TableOutsideTheRanges,
    testing::Values(
        Outside{"protraction above", 0, 10.1,
                "sc_protraction is 10.1 deg at plane 40, elevation 60, outside the joint's range "
                "-60 to 10 deg. Check the signs and the sequence of the table's angles"},
        Outside{"upward rotation below", 4, -40.02,
                "ac_upward_rotation is -40.02 deg at plane 40, elevation 60, outside the joint's "
                "range -40 to 15 deg. Check the signs and the sequence of the table's angles"}));

TEST(ShoulderModel, TakesATableOnTheEdgeOfARange) {
  std::vector<MeasuredRow> rows = MeasuredRows();
  rows[10].angles_deg[0] = -60;
  const ShoulderRhythm rhythm(TableOf(rows), {Interpolation::kSquad, Closure::kTable});
  EXPECT_NO_THROW(static_cast<void>(Xml(rhythm, {.table = std::nullopt})));
}

// All rows lie within the ranges; what follows from them elsewhere does not.
TEST(ShoulderModel, RefusesATableWhoseWholeRhythmLeavesARange) {
  std::vector<MeasuredRow> rows = MeasuredRows();
  for (MeasuredRow& row : rows) row.angles_deg[kGhAxialIndex] -= 10;
  for (const MeasuredRow& row : rows) {
    ASSERT_GT(RadiansFromDegrees(row.angles_deg[kGhAxialIndex]),
              BuiltIn().ranges[kGhAxialIndex].lower_rad);
  }
  const auto message = [&rows](const RhythmOptions& options) {
    return MessageOf<std::invalid_argument>([&] {
      static_cast<void>(Xml(ShoulderRhythm(TableOf(rows), options), {.table = std::nullopt}));
    });
  };
  const std::string whole = message({});
  EXPECT_EQ(whole.rfind("gh_axial is -18", 0), 0U) << whole;
  EXPECT_NE(whole.find(", outside the joint's range -180 to 60 deg. Check the signs"),
            std::string::npos)
      << whole;
  EXPECT_EQ(message({Interpolation::kSmooth, Closure::kExact, Range::kClamp}),
            "(nothing was thrown)");
}

// Between the positions that the writer looks at, too.
TEST(BuiltInAnatomy, HoldsTheWholeRhythmInItsRanges) {
  const auto within = [](const ArmCommand& command) {
    const JointAngles angles_rad = AnglesFromPose(DefaultRhythm().SolvePose(command));
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      const CoordinateRange& range = BuiltIn().ranges[k];
      if (!(angles_rad[k] >= range.lower_rad && angles_rad[k] <= range.upper_rad)) return false;
    }
    return true;
  };
  for (double elevation_deg = 0.25; elevation_deg < 180; elevation_deg += 0.5) {
    for (double plane_deg = -94.75; plane_deg < 135; plane_deg += 0.5) {
      ASSERT_TRUE(within({RadiansFromDegrees(elevation_deg), RadiansFromDegrees(plane_deg)}))
          << "elevation " << elevation_deg << ", plane " << plane_deg;
    }
  }
}

struct NamedMesh {
  const char* name;
  TriangleMesh (*draw)(const Anatomy&);
};

void PrintTo(const NamedMesh& mesh, std::ostream* out) { *out << mesh.name; }

class MeshOfTheModel : public testing::TestWithParam<NamedMesh> {};

TEST_P(MeshOfTheModel, IsTheDrawnBoneToATenthOfAMillimeter) {
  constexpr double kHalfATenth_m = 0.5e-4 + 1e-12;
  const TriangleMesh drawn = GetParam().draw(BuiltIn());
  const auto& mesh = Model(Actuation::kPlugin).Named("mesh", GetParam().name);
  const auto vertices_m = NumbersOf(mesh, "vertex");
  ASSERT_EQ(vertices_m.size(), 3 * drawn.vertices_m.size());
  for (std::size_t i = 0; i < vertices_m.size(); ++i) {
    EXPECT_NEAR(vertices_m[i], drawn.vertices_m[i / 3][static_cast<int>(i % 3)], kHalfATenth_m);
  }
  const auto faces = NumbersOf(mesh, "face");
  ASSERT_EQ(faces.size(), 3 * drawn.triangles.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    EXPECT_EQ(faces[i], drawn.triangles[i / 3][i % 3]);
  }
}

INSTANTIATE_TEST_SUITE_P(Bones, MeshOfTheModel,
                         testing::Values(NamedMesh{"ribcage", RibcageMesh},
                                         NamedMesh{"clavicle_r", ClavicleMesh},
                                         NamedMesh{"scapula_r", ScapulaMesh},
                                         NamedMesh{"humerus_r", HumerusMesh}));

TEST_P(EitherActuation, DrawsEachBoneOnItsBody) {
  for (const auto& [geom, body] :
       {std::pair("ribcage", "thorax"), std::pair("clavicle_r", "clavicle_r"),
        std::pair("scapula_r", "scapula_r"), std::pair("humerus_r", "humerus_r")}) {
    const auto& element = model().Named("geom", geom);
    EXPECT_EQ(TextOf(element, "mesh"), geom);
    EXPECT_EQ(TextOf(*element.Parent()->ToElement(), "name"), body);
  }
}

// A mesh's frame is the body's, so that nothing may move or turn the geom.
TEST_P(EitherActuation, DrawsEachBoneInTheFrameOfItsBody) {
  for (const auto* geom : ParsedXml::All(model().Child("worldbody"), "geom")) {
    for (const char* const attribute : {"pos", "quat", "euler", "axisangle", "xyaxes", "zaxis"}) {
      EXPECT_EQ(geom->Attribute(attribute), nullptr) << TextOf(*geom, "name");
    }
  }
}

TEST_P(EitherActuation, DrawsBonesThatNeitherCollideNorWeigh) {
  const auto defaults = ParsedXml::All(model().Child("default"), "geom");
  ASSERT_EQ(defaults.size(), 1U);
  EXPECT_EQ(NumberOf(*defaults[0], "contype"), 0);
  EXPECT_EQ(NumberOf(*defaults[0], "conaffinity"), 0);
  EXPECT_EQ(NumberOf(*defaults[0], "mass"), 0);
  EXPECT_EQ(TextOf(*defaults[0]->Parent()->ToElement(), "class"),
            TextOf(model().Named("body", "thorax"), "childclass"));
}

TEST(JointDynamics, LagsTheTargetByTwentyMilliseconds) {
  for (const JointDynamics& joint : kJointDynamics) {
    EXPECT_DOUBLE_EQ(joint.damping_N_m_s_per_rad / joint.stiffness_N_m_per_rad, 0.020);
  }
}

TEST(JointDynamics, HasTheArmatureThatTheDesignAllows) {
  for (const JointDynamics& joint : kJointDynamics) {
    EXPECT_GE(joint.armature_kg_m2, 0.005);
    EXPECT_LE(joint.armature_kg_m2, 0.02);
  }
}

}  // namespace
}  // namespace girdle::shoulder_model_test
