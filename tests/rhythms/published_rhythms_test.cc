// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "rhythms/published_rhythms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "kinematics/axis_matrices.h"
#include "rhythms/built_in_files.h"
#include "text/csv_text.h"
#include "text/input_error.h"
#include "text/text_in_data.h"

namespace girdle::published_rhythms_test {
namespace {

// Sines, cosines and quaternions in double precision.
constexpr double kRounding = 1e-14;

PublishedRhythm Rhythm(const std::string& name) {
  for (const PublishedRhythm& rhythm : PublishedRhythms(BuiltInRhythmCoefficients())) {
    if (rhythm.name == name) return rhythm;
  }
  throw std::logic_error("the test names no rhythm " + name);
}

// Y-X'-Z'' in degrees.
RowMatrix Turns(double y_deg, double x_deg, double z_deg) {
  return Product(
      TurnAboutY(RadiansFromDegrees(y_deg)),
      Product(TurnAboutX(RadiansFromDegrees(x_deg)), TurnAboutZ(RadiansFromDegrees(z_deg))));
}

// Elevation H and plane P of the humerus [deg].
struct Place {
  double h_deg;
  double p_deg;
};

class EveryPlace : public testing::TestWithParam<Place> {
 protected:
  [[nodiscard]] static double H() { return GetParam().h_deg; }
  [[nodiscard]] static double P() { return GetParam().p_deg; }
  [[nodiscard]] static GirdlePose PoseOf(const std::string& name) {
    return Rhythm(name).girdle(RadiansFromDegrees(H()), RadiansFromDegrees(P()));
  }
};

INSTANTIATE_TEST_SUITE_P(PublishedRhythms, EveryPlace,
                         testing::Values(Place{0, 0}, Place{30, 40}, Place{90, 0}, Place{120, 90},
                                         Place{150, -60}, Place{180, 135}));

TEST_P(EveryPlace, InmanTurnsTheScapulaUpwardByAThirdOfTheElevation) {
  const GirdlePose pose = PoseOf("Inman");
  EXPECT_LT(Difference(Turns(41.1, -5.4 - H() / 3, -13.5), pose.q_TS), kRounding);
  EXPECT_LT(Difference(Turns(-19.2, -5.9, 0), pose.q_TC), kRounding);
}

TEST_P(EveryPlace, BramanTurnsTheScapulaUpwardByTheShareOfTheGlenohumeralElevation) {
  // 0.43 deg per degree of GH elevation; per degree of the whole, rounded to 0.301 in print.
  constexpr double kPrinted = 0.0005;
  const GirdlePose pose = PoseOf("Braman");
  EXPECT_LT(Difference(Turns(41.1, -5.4 - 0.301 * H(), -13.5), pose.q_TS), kRounding);
  const double upward_deg = 0.43 / 1.43 * H();
  EXPECT_LT(Difference(Turns(41.1, -5.4 - upward_deg, -13.5), pose.q_TS),
            RadiansFromDegrees(kPrinted * H()) + kRounding);
  EXPECT_LT(Difference(Turns(-19.2, -5.9, 0), pose.q_TC), kRounding);
}

// The regression with the signs of its publication: elevation and upward rotation are positive,
// which are turns about -x.
TEST_P(EveryPlace, DeGrootAndBrandFollowTheirRegression) {
  constexpr double kC0y = -28.6;
  constexpr double kC0e = 11.7;
  constexpr double kS0y = 32.0;
  constexpr double kS0u = 10.7;
  constexpr double kS0t = -10.3;
  const double clavicle_y = -4.983 + 0.120 * P() - 0.242 * H() + 0.851 * kC0y;
  const double clavicle_up = 3.917 - 0.046 * P() + 0.123 * H() + 0.493 * kC0e;
  const double scapula_y = -1.203 + 0.140 * P() - 0.049 * H() + 0.901 * kS0y;
  const double scapula_up = 3.095 - 0.079 * P() + 0.396 * H() + 0.414 * kS0u;
  const double scapula_tilt = 0.659 - 0.028 * P() + 0.184 * H() + 0.886 * kS0t;
  const GirdlePose pose = PoseOf("de Groot and Brand");
  EXPECT_LT(Difference(Turns(scapula_y, -scapula_up, scapula_tilt), pose.q_TS), kRounding);
  EXPECT_LT(Difference(Turns(clavicle_y, -clavicle_up, 0), pose.q_TC), kRounding);
}

TEST_P(EveryPlace, MoblArmsTurnsOnTopOfTheRestingBones) {
  const GirdlePose pose = PoseOf("MoBL-ARMS");
  EXPECT_LT(
      Difference(Product(Turns(-6, -8.4, 0), Turns(-0.242 * H(), -0.1025 * H(), 0)), pose.q_TC),
      kRounding);
  EXPECT_LT(
      Difference(Product(Turns(40, -6.8, -17.4), Turns(-0.049 * H(), -0.396 * H(), 0.178 * H())),
                 pose.q_TS),
      kRounding);
}

// The hinges of the model, whose bodies are parallel to the thorax when all are zero: their axes
// say in which order and about what the bones turn.
TEST_P(EveryPlace, MoblArmsTurnsAboutTheHingesOfTheModel) {
  // Axes to four decimals, rest angles to a tenth of a degree.
  constexpr double kPrinted_rad = 0.2 * kRadiansPerDegree;
  const auto hinge = [](const Vector3& axis, double angle_deg) {
    return Exp(glm::normalize(axis) * RadiansFromDegrees(angle_deg));
  };
  const GirdlePose rest = Rhythm("MoBL-ARMS").girdle(0, 0);
  const GirdlePose pose = PoseOf("MoBL-ARMS");
  const Quaternion clavicle =
      hinge({0.0153, 0.9893, -0.1451}, -0.242 * H()) * hinge({-0.9945, 0, -0.1050}, 0.1025 * H());
  EXPECT_LT(AngleBetween(pose.q_TC, clavicle * rest.q_TC), kPrinted_rad);
  const Quaternion scapula = hinge({0.1571, 0.9473, -0.2793}, -0.049 * H()) *
                             hinge({-0.7541, 0.2976, 0.5855}, 0.396 * H()) *
                             hinge({0.6377, 0.1186, 0.7611}, 0.178 * H());
  EXPECT_LT(AngleBetween(pose.q_TS, scapula * rest.q_TS), kPrinted_rad);
}

TEST_P(EveryPlace, AFrozenGirdleStaysAtTheRelaxedPosture) {
  const GirdlePose pose = PoseOf("frozen girdle");
  EXPECT_LT(Difference(Turns(-19.2, -5.9, 0), pose.q_TC), kRounding);
  EXPECT_LT(Difference(Turns(41.1, -5.4, -13.5), pose.q_TS), kRounding);
}

// The relaxed posture is published three times over: SC and AC make ST.
TEST(RelaxedPosture, HasThePublishedAcromioclavicularAngles) {
  constexpr double kPrinted_deg = 0.1;
  const ShoulderPose pose =
      WithHumerus(Rhythm("frozen girdle").girdle(0, 0), Quaternion(1, 0, 0, 0));
  const Vector3 ac_rad = EulerFromQuaternion(EulerSequence::kYXZ, pose.q_CS);
  EXPECT_NEAR(DegreesFromRadians(ac_rad.x), 60.0, kPrinted_deg);
  EXPECT_NEAR(DegreesFromRadians(ac_rad.y), -2.5, kPrinted_deg);
  EXPECT_NEAR(DegreesFromRadians(ac_rad.z), -8.4, kPrinted_deg);
}

TEST(PublishedRhythms, AllRaiseBonesAsTheArmIsRaised) {
  for (const PublishedRhythm& rhythm : PublishedRhythms(BuiltInRhythmCoefficients())) {
    if (rhythm.name == "frozen girdle") continue;
    const Vector3 low = EulerFromQuaternion(EulerSequence::kYXZ, rhythm.girdle(0.5, 0.7).q_TS);
    const Vector3 high = EulerFromQuaternion(EulerSequence::kYXZ, rhythm.girdle(2, 0.7).q_TS);
    EXPECT_LT(high.y, low.y) << rhythm.name;
  }
}

TEST(PublishedRhythms, SayNoMoreThanTheyPublish) {
  for (const char* const name : {"Inman", "Braman"}) {
    EXPECT_EQ(Rhythm(name).defined.angles, (std::array{false, false, false, false, true, false}))
        << name;
  }
  const DefinedAngles de_groot_brand = Rhythm("de Groot and Brand").defined;
  EXPECT_EQ(de_groot_brand.angles, (std::array{true, true, false, true, true, true}));
  EXPECT_FALSE(de_groot_brand.Clavicle());
  EXPECT_TRUE(de_groot_brand.Scapula());
  for (const char* const name : {"MoBL-ARMS", "frozen girdle"}) {
    EXPECT_TRUE(Rhythm(name).defined.Clavicle() && Rhythm(name).defined.Scapula()) << name;
  }
}

TEST(PublishedRhythms, HaveNamesOfTheirOwnAndSources) {
  std::set<std::string_view> names;
  for (const PublishedRhythm& rhythm : PublishedRhythms(BuiltInRhythmCoefficients())) {
    EXPECT_TRUE(names.insert(rhythm.name).second) << rhythm.name;
    EXPECT_FALSE(rhythm.source.empty()) << rhythm.name;
    EXPECT_FALSE(rhythm.says.empty()) << rhythm.name;
  }
}

TEST(WithHumerus, LeavesTheHumerusWhereItIs) {
  const Quaternion q_TH = Exp({0.3, -1.2, 0.8});
  for (const PublishedRhythm& rhythm : PublishedRhythms(BuiltInRhythmCoefficients())) {
    const GirdlePose girdle = rhythm.girdle(1.5, 0.6);
    const ShoulderPose pose = WithHumerus(girdle, q_TH);
    EXPECT_LT(AngleBetween(pose.q_TH(), q_TH), kRounding) << rhythm.name;
    EXPECT_LT(AngleBetween(pose.q_TS(), girdle.q_TS), kRounding) << rhythm.name;
    EXPECT_EQ(pose.q_TC, girdle.q_TC) << rhythm.name;
  }
}

std::string MessageOn(const CsvFlaw& flaw) {
  CsvText text(built_in_files::kPublishedRhythms);
  flaw.change(text);
  return MessageOf<InputError>([&] {
    std::istringstream in(text.Text());
    static_cast<void>(PublishedRhythms(ReadRhythmCoefficients(in, "t.csv")));
  });
}

class FlawedCoefficients : public testing::TestWithParam<CsvFlaw> {};

TEST_P(FlawedCoefficients, AreRefusedWithPlaceAndReason) {
  EXPECT_EQ(MessageOn(GetParam()), GetParam().message);
}

// relaxed stands in lines 2 to 7, inman in 8, braman in 9.
INSTANTIATE_TEST_SUITE_P(
    OneFlawEach, FlawedCoefficients,
    testing::Values(
        CsvFlaw{"unknown angle", [](CsvText& text) { text.Cell(6, "angle") = "ac_tilt"; },
                "t.csv:8: angle 'ac_tilt' is not known. Correct the name"},
        CsvFlaw{"row twice", [](CsvText& text) { text.rows.push_back(text.rows[7]); },
                "t.csv:21: st_upward_rotation of braman is given twice. Remove one of the rows"},
        CsvFlaw{"factor in percent", [](CsvText& text) { text.Cell(7, "per_elevation") = "-30.1"; },
                "t.csv:9: per_elevation is -30.1, expected -1 to 1"},
        CsvFlaw{"no number", [](CsvText& text) { text.Cell(7, "rest_deg") = "-5.A"; },
                "t.csv:9: rest_deg is '-5.A', expected a finite number such as 22.5"},
        CsvFlaw{"rhythm missing", [](CsvText& text) { text.RemoveRow(7); },
                "published rhythms: no rows for 'braman'"},
        CsvFlaw{"relaxed posture incomplete", [](CsvText& text) { text.RemoveRow(0); },
                "published rhythms: no row for sc_protraction of relaxed"}));

TEST(PublishedRhythms, IsTheShippedFileByteForByte) {
  EXPECT_EQ(built_in_files::kPublishedRhythms, TextInData("published_rhythms.csv"));
}

}  // namespace
}  // namespace girdle::published_rhythms_test
