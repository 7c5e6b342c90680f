// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Left shoulders, both on one thorax, and the assembly loop, as XML.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "anatomy/built_in_anatomy.h"
#include "kinematics/assembled_rhythm.h"
#include "kinematics/shipped_data.h"
#include "mjcf/parsed_xml.h"
#include "mjcf/scene.h"
#include "mjcf/shoulder_model.h"
#include "names/joint_dynamics.h"
#include "names/model_names.h"
#include "rhythm_tables/built_in_tables.h"
#include "text/csv_text.h"

namespace girdle::sides_and_assemblies_test {
namespace {

// A few dozen roundings of numbers of size one.
constexpr double kRounding = 1e-14;
// Angles to and from quaternions.
constexpr double kAngleRounding_rad = 1e-12;

const ShoulderRhythm& DefaultRhythm() {
  static const ShoulderRhythm kRhythm = BuiltInRhythm();
  return kRhythm;
}

std::string Xml(const ShoulderModelOptions& options) {
  static const Anatomy kAnatomy = BuiltInAnatomy();
  return ShoulderModelXml(kAnatomy, DefaultRhythm(), options);
}

// A tree or a loop with either lead, moved by plugin or servos.
struct Variant {
  const char* name;
  Assembly assembly = Assembly::kTree;
  Lead lead = Lead::kClavicle;
  Actuation actuation = Actuation::kPlugin;

  [[nodiscard]] std::string Of(Sides sides) const {
    return Xml({.sides = sides, .assembly = assembly, .lead = lead, .actuation = actuation});
  }
};

void PrintTo(const Variant& variant, std::ostream* out) { *out << variant.name; }

const std::vector<Variant>& Variants() {
  static const std::vector<Variant> kVariants = {
      {"Tree"},
      {"TreePosition", Assembly::kTree, Lead::kClavicle, Actuation::kPosition},
      {"Loop", Assembly::kLoop},
      {"LoopPosition", Assembly::kLoop, Lead::kClavicle, Actuation::kPosition},
      {"ScapulaLeads", Assembly::kLoop, Lead::kScapula},
      {"ScapulaLeadsPosition", Assembly::kLoop, Lead::kScapula, Actuation::kPosition}};
  return kVariants;
}

std::vector<Variant> Loops() {
  std::vector<Variant> loops = Variants();
  loops.erase(loops.begin(), loops.begin() + 2);
  return loops;
}

std::string NameOf(const testing::TestParamInfo<Variant>& tested) { return tested.param.name; }

Matrix3 Diagonal(double x, double y, double z) { return {{x, 0, 0}, {0, y, 0}, {0, 0, z}}; }

// The mirror: across z in every bone's frame and in the thorax's.
Matrix3 Mirror() { return Diagonal(1, 1, -1); }

double Difference(const Matrix3& a, const Matrix3& b) {
  double largest = 0;
  for (int i = 0; i < 3; ++i) largest = std::max(largest, glm::distance(a[i], b[i]));
  return largest;
}

using Element = tinyxml2::XMLElement;

std::string OtherSide(std::string name, char side) {
  if (name.ends_with("_r") || name.ends_with("_l")) name.back() = side;
  return name;
}

// An inertia has no name but its body's.
std::string OwnName(const Element& element) {
  return element.Attribute("name") != nullptr ? TextOf(element, "name")
                                              : TextOf(*element.Parent()->ToElement(), "name");
}

// Elements with this tag below the bodies, by name.
std::map<std::string, const Element*> Placed(const ParsedXml& model, const std::string& tag) {
  std::map<std::string, const Element*> found;
  for (const auto* element : ParsedXml::All(model.Child("worldbody"), tag)) {
    found[OwnName(*element)] = element;
  }
  return found;
}

Vector3 PositionOf(const Element& element) {
  return element.Attribute("pos") == nullptr ? Vector3{0, 0, 0} : VectorIn(element, "pos");
}

Matrix3 RotationOf(const Element& element) { return glm::mat3_cast(QuaternionIn(element, "quat")); }

class Mirrors : public testing::TestWithParam<Variant> {
 protected:
  ParsedXml right_{GetParam().Of(Sides::kRight)};
  ParsedXml left_{GetParam().Of(Sides::kLeft)};

  // Calls with the right and the left one of every element of a kind.
  template <typename Check>
  void ForEachPair(const std::string& tag, std::size_t least, Check check) {
    const auto rights = Placed(right_, tag);
    const auto lefts = Placed(left_, tag);
    EXPECT_EQ(rights.size(), lefts.size());
    EXPECT_GE(rights.size(), least);
    for (const auto& [name, right] : rights) {
      const auto left = lefts.find(OtherSide(name, 'l'));
      ASSERT_NE(left, lefts.end()) << name;
      check(name, *right, *left->second);
    }
  }
};

INSTANTIATE_TEST_SUITE_P(Variants, Mirrors, testing::ValuesIn(Variants()), NameOf);

TEST_P(Mirrors, EveryBodyButTheThoraxWhichStandsAsItStood) {
  ForEachPair("body", 4, [](const std::string& name, const Element& right, const Element& left) {
    const Matrix3 mirror = name == "thorax" ? Diagonal(1, 1, 1) : Mirror();
    EXPECT_EQ(PositionOf(left), mirror * PositionOf(right)) << name;
    EXPECT_LT(Difference(RotationOf(left), mirror * RotationOf(right) * mirror), kRounding) << name;
    if (name != "thorax") {
      EXPECT_EQ(TextOf(*left.Parent()->ToElement(), "name"),
                OtherSide(TextOf(*right.Parent()->ToElement(), "name"), 'l'));
    }
  });
}

TEST_P(Mirrors, EverySite) {
  ForEachPair("site", 18, [](const std::string& name, const Element& right, const Element& left) {
    EXPECT_EQ(PositionOf(left), Mirror() * PositionOf(right)) << name;
  });
}

// The axis of a turn is the cross product of two vectors of its plane: mirrored, it turns round. A
// slide's is a vector.
TEST_P(Mirrors, EveryAxisAndKeepsTheCoordinates) {
  ForEachPair("joint", 9, [](const std::string& name, const Element& right, const Element& left) {
    const bool is_slide = right.Attribute("type") != nullptr;
    const Vector3 mirrored = Mirror() * VectorIn(right, "axis");
    EXPECT_LT(glm::distance(VectorIn(left, "axis"), is_slide ? mirrored : -mirrored), kRounding)
        << name;
    for (const char* const same : {"ref", "range", "damping", "armature", "type"}) {
      EXPECT_STREQ(left.Attribute(same), right.Attribute(same)) << name << " " << same;
    }
  });
}

TEST_P(Mirrors, EveryInertia) {
  ForEachPair(
      "inertial", 4, [](const std::string& name, const Element& right, const Element& left) {
        EXPECT_EQ(PositionOf(left), Mirror() * PositionOf(right)) << name;
        EXPECT_EQ(TextOf(left, "mass"), TextOf(right, "mass")) << name;
        const Vector3 moments = VectorIn(right, "diaginertia");
        const Matrix3 inertia = Diagonal(moments.x, moments.y, moments.z);
        const Vector3 mirrored = VectorIn(left, "diaginertia");
        EXPECT_EQ(
            Difference(Diagonal(mirrored.x, mirrored.y, mirrored.z), Mirror() * inertia * Mirror()),
            0)
            << name;
        EXPECT_EQ(left.Attribute("quat"), nullptr) << name;
      });
}

std::vector<Vector3> Vertices(const Element& mesh) {
  const std::vector<double> numbers = NumbersOf(mesh, "vertex");
  std::vector<Vector3> vertices;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) {
    vertices.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  }
  return vertices;
}

// Of each triangle: its normal times twice its area, outward by the order of its corners.
std::vector<Vector3> Normals(const Element& mesh) {
  const std::vector<Vector3> vertices = Vertices(mesh);
  const std::vector<double> corners = NumbersOf(mesh, "face");
  std::vector<Vector3> normals;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    const auto corner = [&](std::size_t k) {
      return vertices.at(static_cast<std::size_t>(corners[i + k]));
    };
    normals.push_back(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
  }
  return normals;
}

TEST_P(Mirrors, EveryBonesVerticesAndTheWayItsFacesFace) {
  for (const char* const bone : {"clavicle", "scapula", "humerus"}) {
    const auto& right = right_.Named("mesh", std::string(bone) + "_r");
    const auto& left = left_.Named("mesh", std::string(bone) + "_l");
    const auto right_vertices = Vertices(right);
    const auto left_vertices = Vertices(left);
    ASSERT_EQ(right_vertices.size(), left_vertices.size()) << bone;
    for (std::size_t i = 0; i < right_vertices.size(); ++i) {
      ASSERT_EQ(left_vertices[i], Mirror() * right_vertices[i]) << bone << " vertex " << i;
    }
    const auto right_normals = Normals(right);
    const auto left_normals = Normals(left);
    ASSERT_EQ(right_normals.size(), left_normals.size()) << bone;
    for (std::size_t i = 0; i < right_normals.size(); ++i) {
      ASSERT_LT(glm::distance(left_normals[i], Mirror() * right_normals[i]), kRounding)
          << bone << " triangle " << i;
    }
  }
}

TEST_P(Mirrors, ActuatorsAndKeyframesAsTheyAre) {
  const auto actuators = [](const ParsedXml& model) {
    return ParsedXml::All(model.Child("actuator"), "");
  };
  const auto rights = actuators(right_);
  const auto lefts = actuators(left_);
  ASSERT_EQ(rights.size(), lefts.size());
  for (std::size_t i = 0; i < rights.size(); ++i) {
    for (const auto* attribute = rights[i]->FirstAttribute(); attribute != nullptr;
         attribute = attribute->Next()) {
      EXPECT_EQ(TextOf(*lefts[i], attribute->Name()), OtherSide(attribute->Value(), 'l'));
    }
  }
  const auto right_keys = right_.All("key");
  const auto left_keys = left_.All("key");
  ASSERT_EQ(right_keys.size(), 9U);
  ASSERT_EQ(left_keys.size(), 9U);
  for (std::size_t i = 0; i < right_keys.size(); ++i) {
    for (const char* const attribute : {"name", "qpos", "ctrl"}) {
      EXPECT_EQ(TextOf(*left_keys[i], attribute), TextOf(*right_keys[i], attribute));
    }
  }
}

// --- Both ----------------------------------------------------------------------------------------

class BothShoulders : public testing::TestWithParam<Variant> {
 protected:
  ParsedXml both_{GetParam().Of(Sides::kBoth)};
  ParsedXml right_{GetParam().Of(Sides::kRight)};
  ParsedXml left_{GetParam().Of(Sides::kLeft)};
};

INSTANTIATE_TEST_SUITE_P(Variants, BothShoulders, testing::ValuesIn(Variants()), NameOf);

std::string Printed(const Element& element) {
  tinyxml2::XMLPrinter printer;
  element.Accept(&printer);
  return printer.CStr();
}

// What is printed, but for how far it is indented.
std::vector<std::string> PrintedWords(const Element& element) { return Words(Printed(element)); }

TEST_P(BothShoulders, HangTheBonesOfEachSideOnOneThorax) {
  EXPECT_EQ(both_.All("body").size(), 7U);
  for (const auto& [alone, suffix] : {std::pair(&right_, "_r"), std::pair(&left_, "_l")}) {
    const std::string clavicle = std::string("clavicle") + suffix;
    const std::string scapula = std::string("scapula") + suffix;
    EXPECT_EQ(PrintedWords(both_.Named("body", clavicle)),
              PrintedWords(alone->Named("body", clavicle)));
    EXPECT_EQ(PrintedWords(both_.Named("body", scapula)),
              PrintedWords(alone->Named("body", scapula)));
    EXPECT_EQ(TextOf(*both_.Named("body", clavicle).Parent()->ToElement(), "name"), "thorax");
  }
}

TEST_P(BothShoulders, PutWhatHasNoSideInTheMedianPlane) {
  for (const char* const landmark : {"IJ", "PX", "C7", "T8"}) {
    const Vector3 right_m = VectorIn(right_.Named("site", landmark), "pos");
    EXPECT_EQ(VectorIn(both_.Named("site", landmark), "pos"), Vector3(right_m.x, right_m.y, 0));
  }
  const auto& center = *both_.Named("body", "thorax").FirstChildElement("inertial");
  EXPECT_EQ(VectorIn(center, "pos").z, 0);
  EXPECT_NE(VectorIn(right_.Named("site", "PX"), "pos").z, 0) << "nothing had to be moved";
}

// The shipped thorax has its centre there already.
TEST(BothShouldersOfSomebodyElse, HaveTheThoraxsCentreOfMassInTheMedianPlane) {
  Anatomy anatomy = BuiltInAnatomy();
  anatomy.segments[static_cast<std::size_t>(Segment::kThorax)].center_of_mass_m.z = 0.01;
  const auto across_m = [&anatomy](Sides sides) {
    const ParsedXml model(ShoulderModelXml(anatomy, DefaultRhythm(), {.sides = sides}));
    return VectorIn(*model.Named("body", "thorax").FirstChildElement("inertial"), "pos").z;
  };
  EXPECT_EQ(across_m(Sides::kRight), 0.01);
  EXPECT_EQ(across_m(Sides::kLeft), -0.01);
  EXPECT_EQ(across_m(Sides::kBoth), 0);
}

TEST_P(BothShoulders, HaveTheActuatorsOfTheRightOneAndThenOfTheLeft) {
  const auto actuators = [](const ParsedXml& model) {
    std::vector<std::string> texts;
    for (const auto* element : ParsedXml::All(model.Child("actuator"), "")) {
      texts.push_back(Printed(*element));
    }
    return texts;
  };
  std::vector<std::string> expected = actuators(right_);
  const std::vector<std::string> lefts = actuators(left_);
  expected.insert(expected.end(), lefts.begin(), lefts.end());
  EXPECT_EQ(actuators(both_), expected);
}

TEST_P(BothShoulders, HaveTheKeyframesOfEachSideOneAfterTheOther) {
  const auto alone = right_.All("key");
  const auto keys = both_.All("key");
  ASSERT_EQ(keys.size(), alone.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    for (const char* const attribute : {"qpos", "ctrl"}) {
      std::vector<double> expected = NumbersOf(*alone[i], attribute);
      const std::vector<double> one = expected;
      expected.insert(expected.end(), one.begin(), one.end());
      EXPECT_EQ(NumbersOf(*keys[i], attribute), expected) << TextOf(*keys[i], "name");
    }
  }
}

TEST(BothShouldersOfThePlugin, HaveAnInstanceAndASensorEach) {
  const ParsedXml both(Xml({.sides = Sides::kBoth}));
  ASSERT_EQ(both.All("instance").size(), 2U);
  const auto sensors = ParsedXml::All(both.Child("sensor"), "plugin");
  ASSERT_EQ(sensors.size(), 2U);
  EXPECT_EQ(TextOf(*sensors[0], "instance"), "rhythm_r");
  EXPECT_EQ(TextOf(*sensors[1], "instance"), "rhythm_l");
}

// The text of one key of an instance's configuration; empty if it is not there.
std::string Config(const ParsedXml& model, const std::string& instance, const std::string& key) {
  for (const auto* config : ParsedXml::All(model.Named("instance", instance), "config")) {
    if (TextOf(*config, "key") == key) return TextOf(*config, "value");
  }
  return "";
}

TEST(BothShouldersOfThePlugin, TellTheLeftInstanceItsSide) {
  const ParsedXml both(Xml({.sides = Sides::kBoth}));
  EXPECT_EQ(Config(both, "rhythm_l", "side"), "left");
  EXPECT_EQ(Config(both, "rhythm_r", "side"), "");
  for (const char* const key : {"interpolation", "closure", "range", "table", "kp"}) {
    EXPECT_EQ(Config(both, "rhythm_l", key), Config(both, "rhythm_r", key)) << key;
  }
}

// --- The loop ------------------------------------------------------------------------------------

class Loop : public testing::TestWithParam<Variant> {
 protected:
  [[nodiscard]] bool scapula_leads() const { return GetParam().lead == Lead::kScapula; }
  [[nodiscard]] bool has_plugin() const { return GetParam().actuation == Actuation::kPlugin; }

  // The controls of a keyframe hold its positions: position servos are given them, the plugin's
  // trims make up for what they are off its targets.
  void ExpectHeld(const NamedPose& named, const ArmCommand& command,
                  const std::vector<double>& controls, const std::vector<double>& qpos) const;

  ParsedXml model_{GetParam().Of(Sides::kRight)};
};

INSTANTIATE_TEST_SUITE_P(Variants, Loop, testing::ValuesIn(Loops()), NameOf);

constexpr std::array<const char*, 3> kSlides = {"st_anterior_r", "st_superior_r", "st_lateral_r"};
constexpr std::array<const char*, 3> kTurns = {"st_internal_rotation_r", "st_upward_rotation_r",
                                               "st_tilt_r"};

AssembledRhythm LoopRhythm() { return {DefaultRhythm(), Assembly::kLoop}; }

// PAC in the thorax where the clavicle takes it.
Vector3 PlaceOfScapula(const ShoulderPose& pose) {
  const auto landmarks_m = ShippedLandmarks();
  return landmarks_m.at("SC") + pose.q_TC * landmarks_m.at("PAC");
}

TEST_P(Loop, HangsClavicleAndScapulaFromTheThorax) {
  for (const auto& [bone, parent] :
       {std::pair("clavicle_r", "thorax"), std::pair("scapula_r", "thorax"),
        std::pair("humerus_r", "scapula_r")}) {
    EXPECT_EQ(TextOf(*model_.Named("body", bone).Parent()->ToElement(), "name"), parent) << bone;
  }
}

TEST_P(Loop, GivesTheScapulaThreeSlidesAndThenThreeHinges) {
  std::vector<std::string> names;
  const auto& scapula = model_.Named("body", "scapula_r");
  for (const auto* joint = scapula.FirstChildElement("joint"); joint != nullptr;
       joint = joint->NextSiblingElement("joint")) {
    names.push_back(TextOf(*joint, "name"));
    EXPECT_EQ(joint->Attribute("type") != nullptr, names.size() <= 3) << names.back();
  }
  EXPECT_EQ(names, (std::vector<std::string>{kSlides[0], kSlides[1], kSlides[2], kTurns[0],
                                             kTurns[1], kTurns[2]}));
  EXPECT_EQ(model_.Parts("joint").size(), 12U);
}

// A slide's axis is given in the body's frame, as it stands.
TEST_P(Loop, SlidesAlongTheThoraxsAxesFromThePlaceItStandsAt) {
  const auto& scapula = model_.Named("body", "scapula_r");
  const Quaternion q_TS = QuaternionIn(scapula, "quat");
  const Vector3 place_m = VectorIn(scapula, "pos");
  EXPECT_LT(glm::distance(place_m, PlaceOfScapula(LoopRhythm().SolvePose({}))), kRounding);
  for (int i = 0; i < 3; ++i) {
    const auto& slide = model_.Named("joint", kSlides[static_cast<std::size_t>(i)]);
    Vector3 axis{0, 0, 0};
    axis[i] = 1;
    EXPECT_LT(glm::distance(q_TS * VectorIn(slide, "axis"), axis), kRounding) << i;
    EXPECT_EQ(NumberOf(slide, "ref"), place_m[i]) << i;
    EXPECT_EQ(slide.Attribute("range"), nullptr) << i;
  }
}

// As a joint's coordinates turn a bone in MuJoCo: about its axes in turn, from where it stands.
TEST_P(Loop, TurnsTheScapulaByItsMeasuredAngles) {
  const Vector3 angles_rad{0.6, -0.3, 0.2};
  Quaternion q_TS = QuaternionIn(model_.Named("body", "scapula_r"), "quat");
  for (int i = 0; i < 3; ++i) {
    const auto& hinge = model_.Named("joint", kTurns[static_cast<std::size_t>(i)]);
    q_TS = q_TS * glm::angleAxis(angles_rad[i] - NumberOf(hinge, "ref"), VectorIn(hinge, "axis"));
  }
  EXPECT_LT(AngleBetween(q_TS, QuaternionFromEuler(EulerSequence::kYXZ, angles_rad)),
            kAngleRounding_rad);
}

TEST_P(Loop, TakesTheScapulasRangesFromItsOwnRows) {
  const auto rows = ShippedRows("joint_ranges.csv");
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& row = rows.at(kCoordinateCount + i);
    ASSERT_EQ(row.at(0) + "_r", kTurns[i]);
    const auto range = NumbersOf(model_.Named("joint", kTurns[i]), "range");
    EXPECT_EQ(range.at(0), RadiansFromDegrees(std::stod(row.at(1)))) << kTurns[i];
    EXPECT_EQ(range.at(1), RadiansFromDegrees(std::stod(row.at(2)))) << kTurns[i];
  }
}

TEST_P(Loop, ClosesTheAcJointByOneConnectOfTwoSites) {
  const auto equalities = ParsedXml::All(model_.Child("equality"), "");
  ASSERT_EQ(equalities.size(), 1U);
  const auto& connect = *equalities.front();
  EXPECT_STREQ(connect.Name(), "connect");
  EXPECT_EQ(TextOf(connect, "name"), "AC_r");
  EXPECT_EQ(TextOf(connect, "site1"), "PAC_r");
  EXPECT_EQ(TextOf(connect, "site2"), "PAC_scapula_r");
  EXPECT_EQ(TextOf(*model_.Named("site", "PAC_r").Parent()->ToElement(), "name"), "clavicle_r");
  EXPECT_EQ(TextOf(*model_.Named("site", "PAC_scapula_r").Parent()->ToElement(), "name"),
            "scapula_r");
  // The shortest time constant that MuJoCo takes at its time step.
  EXPECT_EQ(NumbersOf(connect, "solref").at(0), 2 * NumberOf(model_.Child("option"), "timestep"));
}

TEST(Tree, HasNoConstraint) { EXPECT_TRUE(ParsedXml(Xml({})).All("equality").empty()); }

// What leads is damped as its servo wants it; hinges that follow only as much as keeps them from
// ringing, slides that follow as much as the connect needs at long time steps.
TEST_P(Loop, DampsWhatFollows) {
  const TranslationDynamics& place = scapula_leads() ? kLeadingTranslation : kFollowingTranslation;
  for (const char* const slide : kSlides) {
    EXPECT_EQ(NumberOf(model_.Named("joint", slide), "damping"), place.damping_N_s_per_m);
    EXPECT_EQ(NumberOf(model_.Named("joint", slide), "armature"), place.armature_kg);
  }
  for (const char* const follower : {"sc_protraction_r", "sc_elevation_r"}) {
    EXPECT_EQ(
        NumberOf(model_.Named("joint", follower), "damping"),
        scapula_leads() ? kFollowerDamping_N_m_s_per_rad : kJointDynamics[0].damping_N_m_s_per_rad);
  }
  // Nothing else says how far the clavicle is rolled.
  EXPECT_EQ(NumberOf(model_.Named("joint", "sc_rotation_r"), "damping"),
            kJointDynamics[0].damping_N_m_s_per_rad);
  EXPECT_LT(kFollowerDamping_N_m_s_per_rad, kJointDynamics[0].damping_N_m_s_per_rad);
  EXPECT_GT(kFollowingTranslation.damping_N_s_per_m, 0);
}

TEST_P(Loop, HasServosForWhatItDrives) {
  std::vector<std::string> expected;
  if (has_plugin()) expected = {"elevation_r", "plane_r", "axial_r"};
  if (has_plugin() || !scapula_leads()) {
    expected.insert(expected.end(), {"sc_protraction_r", "sc_elevation_r"});
  }
  expected.insert(expected.end(), {"sc_rotation_r", kTurns[0], kTurns[1], kTurns[2],
                                   "gh_elevation_r", "gh_flexion_r", "gh_axial_r"});
  if (scapula_leads()) expected.insert(expected.end(), kSlides.begin(), kSlides.end());
  std::vector<std::string> names;
  for (const auto* actuator : ParsedXml::All(model_.Child("actuator"), "")) {
    names.push_back(TextOf(*actuator, "name"));
    EXPECT_STREQ(actuator->Name(), has_plugin() ? "plugin" : "position");
  }
  EXPECT_EQ(names, expected);
}

TEST_P(Loop, HasTheGainsOfItsDynamics) {
  if (has_plugin()) {
    EXPECT_EQ(Config(model_, "rhythm_r", "kp"), scapula_leads()
                                                    ? "0 0 1500 1000 1000 1000 500 500 500"
                                                    : "1500 1500 1500 1000 1000 1000 500 500 500");
    EXPECT_EQ(Config(model_, "rhythm_r", "kp_translation"), scapula_leads() ? "10000" : "");
    return;
  }
  for (const auto* servo : ParsedXml::All(model_.Child("actuator"), "position")) {
    const std::string name = TextOf(*servo, "name");
    const double expected = name.starts_with("sc_")   ? kJointDynamics[0].stiffness_N_m_per_rad
                            : name.starts_with("gh_") ? kJointDynamics[2].stiffness_N_m_per_rad
                            : std::find(kSlides.begin(), kSlides.end(), name) != kSlides.end()
                                ? kLeadingTranslation.stiffness_N_per_m
                                : kJointDynamics[1].stiffness_N_m_per_rad;
    EXPECT_EQ(NumberOf(*servo, "kp"), expected) << name;
  }
}

void Loop::ExpectHeld(const NamedPose& named, const ArmCommand& command,
                      const std::vector<double>& controls, const std::vector<double>& qpos) const {
  const ShoulderPose target = LoopRhythm().SolvePose(command);
  const JointAngles target_rad = DrivenAngles(Assembly::kLoop, target);
  const Vector3 target_m = PlaceOfScapula(target);
  std::vector<double> targets(target_rad.begin(), target_rad.begin() + 3);
  targets.insert(targets.end(), {target_m.x, target_m.y, target_m.z});
  targets.insert(targets.end(), target_rad.begin() + 3, target_rad.end());
  std::vector<double> expected;
  if (has_plugin()) expected = {command.elevation_rad, command.plane_rad, 0};
  const auto add = [&](std::size_t k) {
    expected.push_back(has_plugin() ? qpos[k] - targets[k] : qpos[k]);
  };
  // In the order of the actuators: angles, then the place.
  for (const std::size_t k : {0U, 1U, 2U, 6U, 7U, 8U, 9U, 10U, 11U}) {
    if (k > 1 || has_plugin() || !scapula_leads()) add(k);
  }
  for (const std::size_t k : {3U, 4U, 5U}) {
    if (scapula_leads()) add(k);
  }
  ASSERT_EQ(controls.size(), expected.size()) << named.name;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(controls[i], expected[i], kAngleRounding_rad) << named.name << " control " << i;
  }
}

// SC's three angles, the place, the scapula's three, GH's three; and controls that hold them.
TEST_P(Loop, HasKeyframesOfThePosesThatTheirNamesSay) {
  const AssembledRhythm rhythm = LoopRhythm();
  const auto keys = model_.All("key");
  ASSERT_EQ(keys.size(), kKeyframes.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const NamedPose& named = kKeyframes[i];
    ASSERT_EQ(TextOf(*keys[i], "name"), named.name);
    const ArmCommand command{RadiansFromDegrees(named.elevation_deg),
                             RadiansFromDegrees(named.plane_deg)};
    const ShoulderPose pose = named.name == kRelaxedName
                                  ? HangingIn(RelaxedStanding(), rhythm.rhythm())
                                  : rhythm.SolvePose(command);
    const JointAngles angles_rad = DrivenAngles(Assembly::kLoop, pose);
    const Vector3 place_m = PlaceOfScapula(pose);
    std::vector<double> qpos(angles_rad.begin(), angles_rad.begin() + 3);
    qpos.insert(qpos.end(), {place_m.x, place_m.y, place_m.z});
    qpos.insert(qpos.end(), angles_rad.begin() + 3, angles_rad.end());
    const std::vector<double> written = NumbersOf(*keys[i], "qpos");
    ASSERT_EQ(written.size(), qpos.size());
    for (std::size_t k = 0; k < qpos.size(); ++k) {
      EXPECT_NEAR(written[k], qpos[k], kAngleRounding_rad) << named.name << " " << k;
    }
    ExpectHeld(named, command, NumbersOf(*keys[i], "ctrl"), written);
  }
}

// --- What goes together --------------------------------------------------------------------------

struct Refused {
  const char* name;
  ShoulderModelOptions options;
  const char* message;
};

void PrintTo(const Refused& refused, std::ostream* out) { *out << refused.name; }

class RefusedOptions : public testing::TestWithParam<Refused> {};

TEST_P(RefusedOptions, AreNamed) {
  EXPECT_EQ(MessageOf<std::invalid_argument>([] { static_cast<void>(Xml(GetParam().options)); }),
            GetParam().message);
}

constexpr const char* kNeedThePlugin =
    "commands for offsets and rates need the plugin: position servos are given joint angles";

INSTANTIATE_TEST_SUITE_P(
    Combinations, RefusedOptions,
    testing::Values(Refused{"RatesOfALoop",
                            {.assembly = Assembly::kLoop, .has_rates = true},
                            "rate commands need the assembly tree"},
                    Refused{"OffsetsOfPositionServos",
                            {.actuation = Actuation::kPosition, .has_offsets = true},
                            kNeedThePlugin},
                    Refused{
                        "AxialFromIsbOfPositionServos",
                        {.actuation = Actuation::kPosition, .axial_from = AxialFrom::kIsb},
                        "another zero of axial turns needs the plugin: position servos are given "
                        "joint angles"},
                    Refused{"RatesOfPositionServos",
                            {.actuation = Actuation::kPosition, .has_rates = true},
                            kNeedThePlugin},
                    Refused{"TheScapulaLeadsATree",
                            {.lead = Lead::kScapula},
                            "in a tree nothing but the clavicle can lead"}),
    [](const auto& tested) { return tested.param.name; });

TEST(LoopModel, OfATableOfTwoPlanesIsRefused) {
  std::vector<MeasuredRow> rows = MeasuredRows();
  rows.resize(44);
  const ShoulderRhythm rhythm(TableOf(rows), {Interpolation::kSlerp, Closure::kTable});
  const auto message = [&rhythm](Assembly assembly) {
    return MessageOf<std::invalid_argument>([&] {
      static_cast<void>(ShoulderModelXml(BuiltInAnatomy(), rhythm,
                                         {.assembly = assembly, .table = std::nullopt}));
    });
  };
  EXPECT_EQ(message(Assembly::kTree), "(nothing was thrown)");
  EXPECT_EQ(message(Assembly::kLoop),
            "the assembly loop needs a table of at least 3 planes and 3 elevations, this one has 2 "
            "and 22");
}

TEST(LoopModel, NamesTheScapulasAngleThatLeavesItsRange) {
  Anatomy anatomy = BuiltInAnatomy();
  anatomy.scapulothoracic_ranges[1].lower_rad = RadiansFromDegrees(-40);
  const auto message = [&anatomy](Assembly assembly) {
    return MessageOf<std::invalid_argument>([&] {
      static_cast<void>(ShoulderModelXml(anatomy, DefaultRhythm(), {.assembly = assembly}));
    });
  };
  EXPECT_EQ(message(Assembly::kTree), "(nothing was thrown)");
  const std::string loop = message(Assembly::kLoop);
  EXPECT_EQ(loop.rfind("st_upward_rotation is -40.", 0), 0U) << loop;
  EXPECT_NE(loop.find("outside the joint's range -40 to 30 deg"), std::string::npos) << loop;
}

TEST(LoopModel, HasNoRangeOfAcToLeave) {
  Anatomy anatomy = BuiltInAnatomy();
  anatomy.ranges[3] = {RadiansFromDegrees(55), RadiansFromDegrees(56)};
  const auto message = [&anatomy](Assembly assembly) {
    return MessageOf<std::invalid_argument>([&] {
      static_cast<void>(ShoulderModelXml(anatomy, DefaultRhythm(), {.assembly = assembly}));
    });
  };
  EXPECT_EQ(message(Assembly::kTree).rfind("ac_internal_rotation is ", 0), 0U);
  EXPECT_EQ(message(Assembly::kLoop), "(nothing was thrown)");
}

// --- Scenes --------------------------------------------------------------------------------------

const ParsedXml& Scene(Sides sides) {
  static const std::array<ParsedXml, 3> kScenes = {
      ParsedXml(SceneXml("m.xml", BuiltInAnatomy(), Sides::kRight)),
      ParsedXml(SceneXml("m.xml", BuiltInAnatomy(), Sides::kLeft)),
      ParsedXml(SceneXml("m.xml", BuiltInAnatomy(), Sides::kBoth))};
  return kScenes.at(static_cast<std::size_t>(sides));
}

// The picture of a mirrored shoulder from a mirrored place: the same height, the other way round.
TEST(LeftScene, IsSeenFromTheMirroredPlaces) {
  const Matrix3 mirror = Diagonal(1, -1, 1);
  const auto center = [](Sides sides) {
    return VectorIn(Scene(sides).Child("statistic"), "center");
  };
  EXPECT_EQ(center(Sides::kLeft), mirror * center(Sides::kRight));
  for (const char* const name : {"front", "back", "above", "oblique"}) {
    const auto& right = Scene(Sides::kRight).Named("camera", name);
    const auto& left = Scene(Sides::kLeft).Named("camera", name);
    EXPECT_LT(glm::distance(VectorIn(left, "pos"), mirror * VectorIn(right, "pos")), kRounding)
        << name;
    const auto axes = NumbersOf(left, "xyaxes");
    const Vector3 x{axes.at(0), axes.at(1), axes.at(2)};
    const Vector3 y{axes.at(3), axes.at(4), axes.at(5)};
    // Axes are written to four decimals.
    constexpr double kPrinted = 4e-4;
    const Vector3 to_center = glm::normalize(center(Sides::kLeft) - VectorIn(left, "pos"));
    EXPECT_LT(glm::distance(-glm::cross(x, y), to_center), kPrinted) << name;
    EXPECT_NEAR(x.z, 0, kPrinted) << name;
  }
}

TEST(SceneOfBoth, LooksAtTheMiddleFromFartherAway) {
  const auto& both = Scene(Sides::kBoth);
  const Vector3 center = VectorIn(both.Child("statistic"), "center");
  EXPECT_EQ(center.y, 0);
  for (const char* const name : {"front", "back", "above", "oblique"}) {
    const auto away = [name](Sides sides) {
      return glm::distance(VectorIn(Scene(sides).Named("camera", name), "pos"),
                           VectorIn(Scene(sides).Child("statistic"), "center"));
    };
    EXPECT_GT(away(Sides::kBoth), 1.2 * away(Sides::kRight)) << name;
  }
  EXPECT_GT(NumberOf(both.Child("statistic"), "extent"),
            NumberOf(Scene(Sides::kRight).Child("statistic"), "extent"));
}

}  // namespace
}  // namespace girdle::sides_and_assemblies_test
