// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Ligaments and the contact with the thorax in emitted models.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <glm/geometric.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "anatomy/built_in_anatomy.h"
#include "anatomy/posed_bones.h"
#include "kinematics/assembled_rhythm.h"
#include "mjcf/parsed_xml.h"
#include "mjcf/shoulder_model.h"
#include "names/joint_dynamics.h"
#include "names/model_names.h"
#include "rhythm_tables/built_in_tables.h"

namespace girdle::thorax_test {
namespace {

// Of numbers of a shoulder's size.
constexpr double kRounding = 1e-15;

const Anatomy& BuiltIn() {
  static const Anatomy kAnatomy = BuiltInAnatomy();
  return kAnatomy;
}

const ShoulderRhythm& DefaultRhythm() {
  static const ShoulderRhythm kRhythm = BuiltInRhythm();
  return kRhythm;
}

ParsedXml Model(const ShoulderModelOptions& options) {
  return ParsedXml(ShoulderModelXml(BuiltIn(), DefaultRhythm(), options));
}

std::string ParentOf(const tinyxml2::XMLElement& element) {
  return element.Parent()->ToElement()->Attribute("name");
}

class EitherAssembly : public testing::TestWithParam<Assembly> {};

INSTANTIATE_TEST_SUITE_P(Assemblies, EitherAssembly,
                         testing::Values(Assembly::kTree, Assembly::kLoop),
                         [](const testing::TestParamInfo<Assembly>& test) {
                           return std::string(Name(test.param));
                         });

TEST_P(EitherAssembly, HasALigamentBetweenItsAttachmentsOnBothSides) {
  const ParsedXml model = Model({.sides = Sides::kBoth, .assembly = GetParam()});
  for (const auto& [name, ligament] :
       {std::pair<std::string, Ligament>("conoid", BuiltIn().ligament(LigamentName::kConoid)),
        std::pair<std::string, Ligament>("trapezoid",
                                         BuiltIn().ligament(LigamentName::kTrapezoid))}) {
    for (const auto& [suffix, side] : {std::pair("_r", 1.0), std::pair("_l", -1.0)}) {
      const Vector3 mirror{1, 1, side};
      const auto& clavicle = model.Named("site", name + "_clavicle" + suffix);
      const auto& scapula = model.Named("site", name + "_scapula" + suffix);
      EXPECT_EQ(ParentOf(clavicle), std::string("clavicle") + suffix);
      EXPECT_EQ(ParentOf(scapula), std::string("scapula") + suffix);
      EXPECT_LT(glm::distance(VectorIn(clavicle, "pos"), mirror * ligament.clavicle_m), kRounding);
      EXPECT_LT(glm::distance(VectorIn(scapula, "pos"), mirror * ligament.scapula_m), kRounding);
      const auto& tendon = model.Named("spatial", name + suffix);
      const auto ends = ParsedXml::All(tendon, "site");
      ASSERT_EQ(ends.size(), 2U);
      EXPECT_EQ(ends[0]->Attribute("site"), name + "_clavicle" + suffix);
      EXPECT_EQ(ends[1]->Attribute("site"), name + "_scapula" + suffix);
      EXPECT_EQ(NumbersOf(tendon, "stiffness"), std::vector{ligament.stiffness_N_per_m});
      const std::vector<double> slack_m = NumbersOf(tendon, "springlength");
      ASSERT_EQ(slack_m.size(), 2U);
      EXPECT_EQ(slack_m[0], 0) << "pushes";
      EXPECT_GE(slack_m[1], ligament.slack_m);
      const std::vector<double> range_m = NumbersOf(tendon, "range");
      ASSERT_EQ(range_m.size(), 2U);
      EXPECT_NEAR(range_m[1] - slack_m[1], ligament.failure_elongation_m, kRounding);
    }
  }
}

double SlackIn(const ParsedXml& model, LigamentName ligament) {
  const std::string name(Name(ligament));
  return NumbersOf(model.Named("spatial", name + "_r"), "springlength").at(1);
}

TEST_P(EitherAssembly, HasLigamentsThatTheRhythmNeverStretches) {
  const AssembledRhythm rhythm(DefaultRhythm(), GetParam());
  const ParsedXml model = Model({.assembly = GetParam()});
  for (const LigamentName name : {LigamentName::kConoid, LigamentName::kTrapezoid}) {
    double longest_m = 0;
    // Between the places where slack was looked for.
    for (double elevation_deg = 0.5; elevation_deg < 180; elevation_deg += 1) {
      for (double plane_deg = -94.5; plane_deg < 135; plane_deg += 3) {
        longest_m = std::max(longest_m,
                             LigamentLength_m(BuiltIn().ligament(name), BuiltIn(),
                                              rhythm.SolvePose({RadiansFromDegrees(elevation_deg),
                                                                RadiansFromDegrees(plane_deg)})));
      }
    }
    const double slack_m = SlackIn(model, name);
    EXPECT_LE(longest_m, slack_m);
    // And no looser than to 0.1 mm and what lies between two places.
    EXPECT_GT(longest_m, slack_m - 0.0003);
  }
}

TEST(LigamentSlack, IsTheAnatomysWhereTheRhythmStaysInTheTable) {
  const ShoulderRhythm rhythm = BuiltInRhythm({Interpolation::kSquad, Closure::kTable});
  const ParsedXml model(ShoulderModelXml(BuiltIn(), rhythm, {.table = std::nullopt}));
  for (const LigamentName name : {LigamentName::kConoid, LigamentName::kTrapezoid}) {
    EXPECT_EQ(SlackIn(model, name), BuiltIn().ligament(name).slack_m);
  }
}

TEST_P(EitherAssembly, TouchesTheThoraxWithTsAndAiAlone) {
  const ParsedXml model =
      Model({.sides = Sides::kBoth, .assembly = GetParam(), .has_thorax_contact = true});
  EXPECT_EQ(model.Parts("pair").size(), 4U);
  for (const auto& [suffix, side] : {std::pair("_r", 1.0), std::pair("_l", -1.0)}) {
    const Vector3 mirror{1, 1, side};
    const auto& surface = model.Named("geom", std::string("gliding") + suffix);
    EXPECT_EQ(ParentOf(surface), "thorax");
    EXPECT_STREQ(surface.Attribute("type"), "ellipsoid");
    const Vector3& radii_m = BuiltIn().gliding.radii_m;
    EXPECT_EQ(NumbersOf(surface, "size"), (std::vector{radii_m.x, radii_m.y, radii_m.z}));
    EXPECT_LT(glm::distance(VectorIn(surface, "pos"), mirror * BuiltIn().gliding.center_m),
              kRounding);
    for (const auto& [name, landmark] :
         {std::pair("TS", Landmark::kTS), std::pair("AI", Landmark::kAI)}) {
      const auto& point = model.Named("geom", std::string(name) + suffix);
      EXPECT_EQ(ParentOf(point), std::string("scapula") + suffix);
      EXPECT_LT(glm::distance(VectorIn(point, "pos"), mirror * BuiltIn().landmark_m(landmark)),
                kRounding);
      EXPECT_LE(NumbersOf(point, "size").at(0), 0.0001) << "no point";
      const auto& pair = model.Named("pair", std::string(name) + suffix);
      EXPECT_EQ(pair.Attribute("geom1"), std::string("gliding") + suffix);
      EXPECT_EQ(pair.Attribute("geom2"), std::string(name) + suffix);
      EXPECT_EQ(NumbersOf(pair, "condim"), std::vector{1.0}) << "it glides without friction";
    }
  }
}

TEST_P(EitherAssembly, TouchesNothingUnlessTold) {
  const ParsedXml model = Model({.assembly = GetParam()});
  EXPECT_TRUE(model.Parts("pair").empty());
  for (const auto* geom : model.Parts("geom")) {
    const char* const name = geom->Attribute("name");
    EXPECT_STRNE(name == nullptr ? "" : name, "gliding_r");
  }
}

TEST(ShoulderModel, RefusesThoraxContactWhereTheScapulaLeads) {
  EXPECT_THROW(
      static_cast<void>(
          Model({.assembly = Assembly::kLoop, .lead = Lead::kScapula, .has_thorax_contact = true})),
      std::invalid_argument);
}

}  // namespace
}  // namespace girdle::thorax_test
