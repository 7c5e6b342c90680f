// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/isb_frames.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <glm/geometric.hpp>
#include <optional>
#include <ostream>
#include <string>
#include <utility>

#include "kinematics/random_rotations.h"
#include "kinematics/shipped_data.h"
#include "kinematics/shoulder_rhythm.h"

namespace girdle::isb_frames_test {
namespace {

// A few dozen roundings, of landmarks up to ten times as far off as they are apart.
constexpr double kRounding = 1e-13;

// A rigid placement in any unit of length.
struct Placement {
  Quaternion q_AB;
  Vector3 p_AB;
  double scale;

  [[nodiscard]] Vector3 operator()(const Vector3& p_BL) const {
    return p_AB + scale * (q_AB * p_BL);
  }
};

rc::Gen<Placement> AnyPlacement() {
  return rc::gen::exec([] {
    return Placement{*UnitQuaternion(), *VectorWithin(-1, 1), *NumberWithin(0.5, 2)};
  });
}

void showValue(const Placement& placement, std::ostream& out) {
  out << "turned by ";
  showValue(placement.q_AB, out);
  out << ", moved by ";
  showValue(placement.p_AB, out);
  out << ", scaled by " << placement.scale;
}

// Landmarks in the bone's own frame, as the definitions place them.
struct ScapulaLandmarks {
  Vector3 pac;
  Vector3 ts;
  Vector3 ai;
};

struct HumerusLandmarks {
  Vector3 gh;
  Vector3 em;
  Vector3 el;
};

// Origin PAC, TS on -z, AI below in the y-z plane.
ScapulaLandmarks AnyScapula() {
  const double spine_m = *NumberWithin(0.1, 0.15);
  return {{0, 0, 0},
          {0, 0, -spine_m},
          {0, -*NumberWithin(0.1, 0.15), -spine_m + *NumberWithin(-0.03, 0.03)}};
}

// Origin GH, the epicondyles in the y-z plane with their middle on -y, EL to the right of EM.
HumerusLandmarks AnyHumerus() {
  const double length_m = *NumberWithin(0.25, 0.35);
  const double half_width_m = *NumberWithin(0.02, 0.04);
  const double tilt_m = *NumberWithin(-0.01, 0.01);
  return {{0, 0, 0}, {0, -length_m - tilt_m, -half_width_m}, {0, -length_m + tilt_m, half_width_m}};
}

RC_GTEST_PROP(ScapulaFrame, IsTheRotationThatPlacedTheLandmarks, ()) {
  const ScapulaLandmarks bone = AnyScapula();
  const Placement placed = *AnyPlacement();
  RC_ASSERT(AngleBetween(ScapulaFrame(placed(bone.pac), placed(bone.ts), placed(bone.ai)),
                         placed.q_AB) < kRounding);
}

RC_GTEST_PROP(HumerusFrame, IsTheRotationThatPlacedTheLandmarks, ()) {
  const HumerusLandmarks bone = AnyHumerus();
  const Placement placed = *AnyPlacement();
  RC_ASSERT(AngleBetween(HumerusFrame(placed(bone.gh), placed(bone.em), placed(bone.el)),
                         placed.q_AB) < kRounding);
}

RC_GTEST_PROP(ClavicleAxis, IsTheUnitVectorFromScToPac, ()) {
  const double length_m = *NumberWithin(0.1, 0.2);
  const Placement placed = *AnyPlacement();
  const Vector3 axis = ClavicleAxis(placed({0, 0, 0}), placed({0, 0, length_m}));
  RC_ASSERT(glm::length(axis - placed.q_AB * Vector3(0, 0, 1)) < kRounding);
}

// The humerus's z is parallel to EM-EL only where the epicondyles stand level; its y always points
// to GH.
RC_GTEST_PROP(HumerusFrame, HasItsLongAxisThroughTheMiddleOfTheElbow, ()) {
  const Vector3 gh = *VectorWithin(-1, 1);
  const Vector3 em = *VectorWithin(-1, 1);
  const Vector3 el = *VectorWithin(-1, 1);
  const Vector3 shaft = gh - (em + el) / 2.0;
  RC_PRE(glm::length(glm::cross(shaft, el - em)) > 0.01);
  RC_ASSERT(glm::length(HumerusFrame(gh, em, el) * Vector3(0, 1, 0) - glm::normalize(shaft)) <
            kRounding);
}

RC_GTEST_PROP(ScapulaFrame, HasItsForwardAxisPerpendicularToTheBlade, ()) {
  const Vector3 pac = *VectorWithin(-1, 1);
  const Vector3 ts = *VectorWithin(-1, 1);
  const Vector3 ai = *VectorWithin(-1, 1);
  RC_PRE(glm::length(glm::cross(pac - ts, ai - ts)) > 0.01);
  const Vector3 x = ScapulaFrame(pac, ts, ai) * Vector3(1, 0, 0);
  RC_ASSERT(std::abs(glm::dot(x, pac - ts)) < kRounding);
  RC_ASSERT(std::abs(glm::dot(x, ai - ts)) < kRounding);
}

TEST(ScapulaFrame, OfTheShippedLandmarksIsTheirOwnFrame) {
  const auto landmarks_m = ShippedLandmarks();
  const Vector3 pac{0, 0, 0};  // the scapula's origin
  EXPECT_LT(AngleBetween(ScapulaFrame(pac, landmarks_m.at("TS"), landmarks_m.at("AI")),
                         Quaternion(1, 0, 0, 0)),
            kRounding);
}

TEST(HumerusFrame, OfTheShippedLandmarksIsTheirOwnFrame) {
  const auto landmarks_m = ShippedLandmarks();
  const Vector3 gh{0, 0, 0};  // the humerus's origin
  EXPECT_LT(AngleBetween(HumerusFrame(gh, landmarks_m.at("EM"), landmarks_m.at("EL")),
                         Quaternion(1, 0, 0, 0)),
            kRounding);
}

TEST(ClavicleAxis, OfTheShippedLandmarksIsZ) {
  const Vector3 sc{0, 0, 0};  // the clavicle's origin
  EXPECT_LT(glm::length(ClavicleAxis(sc, ShippedLandmarks().at("PAC")) - Vector3(0, 0, 1)),
            kRounding);
}

TEST(ScapulaFrame, OfLandmarksOnALineIsNotFinite) {
  EXPECT_FALSE(std::isfinite(glm::length(ScapulaFrame({0, 0, 0}, {0, 0, -1}, {0, 0, -2}))));
}

TEST(HumerusFrame, OfLandmarksOnALineIsNotFinite) {
  EXPECT_FALSE(std::isfinite(glm::length(HumerusFrame({0, 0, 0}, {0, -1, 0}, {0, -2, 0}))));
}

// --- Thorax and clavicle --------------------------------------------------------------------

// Origin IJ; C7 and the middle of PX and T8 in the median plane, the latter below that of IJ and
// C7; PX and T8 as far to the left as to the right.
ThoraxPoints AnyThorax() {
  const double depth_m = *NumberWithin(0.1, 0.2);
  const double rise_m = *NumberWithin(-0.02, 0.08);
  const Vector3 upper_m{-depth_m / 2, rise_m / 2, 0};
  const Vector3 lower_m = upper_m - Vector3(0, *NumberWithin(0.1, 0.25), 0);
  const Vector3 half_m{*NumberWithin(0.05, 0.1), *NumberWithin(-0.03, 0.05),
                       *NumberWithin(-0.02, 0.02)};
  return {
      {0, 0, 0}, lower_m + half_m, {-depth_m, rise_m, 0}, lower_m - half_m, {-0.01, 0.01, 0.02}};
}

RC_GTEST_PROP(ThoraxFrame, IsTheRotationThatPlacedTheLandmarks, ()) {
  const ThoraxPoints bone = AnyThorax();
  const Placement placed = *AnyPlacement();
  RC_ASSERT(AngleBetween(ThoraxFrame(placed(bone.ij_m), placed(bone.px_m), placed(bone.c7_m),
                                     placed(bone.t8_m)),
                         placed.q_AB) < kRounding);
}

TEST(ThoraxFrame, OfTheShippedLandmarksIsTheirOwnFrame) {
  const auto landmarks_m = ShippedLandmarks();
  EXPECT_LT(AngleBetween(ThoraxFrame(landmarks_m.at("IJ"), landmarks_m.at("PX"),
                                     landmarks_m.at("C7"), landmarks_m.at("T8")),
                         Quaternion(1, 0, 0, 0)),
            kRounding);
}

TEST(ThoraxFrame, OfLandmarksOnALineIsNotFinite) {
  EXPECT_FALSE(
      std::isfinite(glm::length(ThoraxFrame({0, 0, 0}, {0, -3, 0}, {0, -1, 0}, {0, -3, 0}))));
}

RC_GTEST_PROP(ClavicleFrame, HasItsLongAxisThroughPacAndNoForwardRise, ()) {
  const Vector3 sc = *VectorWithin(-1, 1);
  const Vector3 pac = *VectorWithin(-1, 1);
  const Vector3 thorax_y = *UnitVector();
  RC_PRE(glm::length(glm::cross(thorax_y, pac - sc)) > 0.01);
  const Quaternion q_AC = ClavicleFrame(sc, pac, thorax_y);
  constexpr double kRoundingOfShortLines = 1e-12;
  RC_ASSERT(glm::length(q_AC * Vector3(0, 0, 1) - ClavicleAxis(sc, pac)) < kRoundingOfShortLines);
  RC_ASSERT(std::abs(glm::dot(q_AC * Vector3(1, 0, 0), thorax_y)) < kRoundingOfShortLines);
  // Up is up.
  RC_ASSERT(glm::dot(q_AC * Vector3(0, 1, 0), thorax_y) > 0);
}

// In the thorax frame a clavicle that was not turned about its own axis is Y-X'.
RC_GTEST_PROP(ClavicleFrame, IsProtractionAndElevationWithoutRotation, ()) {
  const Vector3 angles_rad{*NumberWithin(-1.2, 1.2), *NumberWithin(-1.2, 1.2), 0};
  const Quaternion q_TC = QuaternionFromEuler(EulerSequence::kYXZ, angles_rad);
  const Vector3 sc = *VectorWithin(-1, 1);
  const Quaternion found =
      ClavicleFrame(sc, sc + q_TC * Vector3(0, 0, *NumberWithin(0.1, 0.2)), {0, 1, 0});
  constexpr double kRoundingOfShortLines = 1e-12;
  RC_ASSERT(AngleBetween(found, q_TC) < kRoundingOfShortLines);
}

TEST(DistanceFromLine, IsMeasuredAtARightAngle) {
  EXPECT_DOUBLE_EQ(DistanceFromLine({7, 3, 4}, {0, 0, 0}, {2, 0, 0}), 5);
}

TEST(DistanceFromLine, IsThatFromThePointWhereThereIsNoLine) {
  EXPECT_DOUBLE_EQ(DistanceFromLine({4, 4, 1}, {1, 0, 1}, {1, 0, 1}), 5);
}

// --- Flaws ----------------------------------------------------------------------------------

// The shipped landmarks, each bone where its own frame is.
struct Shoulder {
  ThoraxPoints thorax;
  ScapulaPoints scapula;
  HumerusPoints humerus;
};

Shoulder ShippedShoulder() {
  const auto p_m = ShippedLandmarks();
  return {{p_m.at("IJ"), p_m.at("PX"), p_m.at("C7"), p_m.at("T8"), p_m.at("SC")},
          {{0, 0, 0}, p_m.at("TS"), p_m.at("AI"), p_m.at("AA"), p_m.at("PC")},
          {{0, 0, 0}, p_m.at("EM"), p_m.at("EL")}};
}

std::optional<LandmarkFlaw> FlawOf(const Shoulder& shoulder) {
  return FlawOfRightShoulder(shoulder.thorax, shoulder.scapula, shoulder.humerus);
}

// The same with each bone in another frame, at its own size.
Shoulder Placed(const Shoulder& shoulder) {
  Placement thorax = *AnyPlacement();
  Placement scapula = *AnyPlacement();
  Placement humerus = *AnyPlacement();
  thorax.scale = scapula.scale = humerus.scale = 1;
  const ThoraxPoints& t = shoulder.thorax;
  const ScapulaPoints& s = shoulder.scapula;
  const HumerusPoints& h = shoulder.humerus;
  return {{thorax(t.ij_m), thorax(t.px_m), thorax(t.c7_m), thorax(t.t8_m), thorax(t.sc_m)},
          {scapula(s.pac_m), scapula(s.ts_m), scapula(s.ai_m), scapula(s.aa_m), scapula(s.pc_m)},
          {humerus(h.gh_m), humerus(h.em_m), humerus(h.el_m)}};
}

Vector3 Mirrored(const Vector3& p) { return {p.x, p.y, -p.z}; }

void MirrorThorax(Shoulder& shoulder) {
  for (Vector3* p : {&shoulder.thorax.ij_m, &shoulder.thorax.px_m, &shoulder.thorax.c7_m,
                     &shoulder.thorax.t8_m, &shoulder.thorax.sc_m}) {
    *p = Mirrored(*p);
  }
}

void MirrorScapula(Shoulder& shoulder) {
  for (Vector3* p : {&shoulder.scapula.pac_m, &shoulder.scapula.ts_m, &shoulder.scapula.ai_m,
                     &shoulder.scapula.aa_m, &shoulder.scapula.pc_m}) {
    *p = Mirrored(*p);
  }
}

RC_GTEST_PROP(FlawOfRightShoulder, IsNoneOfTheShippedOneInAnyFrames, ()) {
  RC_ASSERT(!FlawOf(Placed(ShippedShoulder())).has_value());
}

struct Flaw {
  const char* name;
  std::function<void(Shoulder&)> change;
  const char* landmark;
  const char* message;
};

void PrintTo(const Flaw& flaw, std::ostream* out) { *out << flaw.name; }

class FlawedShoulder : public testing::TestWithParam<Flaw> {};

TEST_P(FlawedShoulder, IsToldWithTheLandmarkAndTheFix) {
  Shoulder shoulder = ShippedShoulder();
  GetParam().change(shoulder);
  const std::optional<LandmarkFlaw> flaw = FlawOf(shoulder);
  ASSERT_TRUE(flaw.has_value());
  EXPECT_EQ(flaw->landmark, GetParam().landmark);
  EXPECT_EQ(flaw->message, GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    OneEach, FlawedShoulder,
    testing::Values(
        Flaw{"IJ and PX", [](Shoulder& s) { std::swap(s.thorax.ij_m, s.thorax.px_m); }, "PX",
             "SC lies nearer to PX than to IJ: IJ and PX have each other's place. Swap their "
             "names"},
        Flaw{"C7 and T8", [](Shoulder& s) { std::swap(s.thorax.c7_m, s.thorax.t8_m); }, "T8",
             "T8 to C7 does not go up as PX to IJ does: C7 and T8 have each other's place. Swap "
             "their "
             "names"},
        Flaw{"IJ and C7", [](Shoulder& s) { std::swap(s.thorax.ij_m, s.thorax.c7_m); }, "C7",
             "SC lies nearer to C7 than to IJ: IJ and C7 have each other's place. Swap their "
             "names"},
        Flaw{"PX and T8", [](Shoulder& s) { std::swap(s.thorax.px_m, s.thorax.t8_m); }, "T8",
             "PX lies behind T8: PX and T8 have each other's place. Swap their names"},
        Flaw{"upside down",
             [](Shoulder& s) {
               std::swap(s.thorax.ij_m, s.thorax.px_m);
               std::swap(s.thorax.c7_m, s.thorax.t8_m);
             },
             "PX",
             "SC lies nearer to PX than to IJ: IJ and PX have each other's place. Swap their "
             "names"},
        Flaw{"front to back",
             [](Shoulder& s) {
               std::swap(s.thorax.ij_m, s.thorax.c7_m);
               std::swap(s.thorax.px_m, s.thorax.t8_m);
             },
             "C7",
             "SC lies nearer to C7 than to IJ: IJ and C7 have each other's place. Swap their "
             "names"},
        Flaw{"thorax on a line",
             [](Shoulder& s) {
               s.thorax.c7_m = {0.0205, 0.0502, 0};
             },
             "T8",
             "IJ, C7 and the middle of PX and T8 lie nearly on a line, 0 mm off it, and tell no "
             "frame. Measure them again"},
        Flaw{"TS and AI", [](Shoulder& s) { std::swap(s.scapula.ts_m, s.scapula.ai_m); }, "AI",
             "AI lies nearer to PAC than TS does: TS and AI have each other's place. Swap their "
             "names"},
        Flaw{"scapula on a line",
             [](Shoulder& s) {
               s.scapula.ai_m = {0, -0.003, -0.2};
             },
             "AI",
             "PAC, TS and AI lie nearly on a line, 2 mm off it, and tell no frame. Measure them "
             "again"},
        Flaw{"humerus on a line",
             [](Shoulder& s) {
               s.humerus.el_m = {0, -0.2, -0.02};
             },
             "EL",
             "GH, EM and EL lie nearly on a line, 3 mm off it, and tell no frame. Measure them "
             "again"},
        Flaw{"AA and PC", [](Shoulder& s) { std::swap(s.scapula.aa_m, s.scapula.pc_m); }, "PC",
             "PC lies behind AA, as in a left scapula. Swap their names if they have each other's "
             "place, or negate z_m in the scapula's rows if it is mirrored"},
        Flaw{"mirrored scapula", MirrorScapula, "PC",
             "PC lies behind AA, as in a left scapula. Swap their names if they have each other's "
             "place, or negate z_m in the scapula's rows if it is mirrored"},
        Flaw{"mirrored thorax", MirrorThorax, "SC",
             "SC lies to the left of IJ and C7, but the scapula is a right one. Give the right SC, "
             "swap the names of PX and C7 if they have each other's place, or negate z_m in the "
             "thorax's rows if they are mirrored"},
        Flaw{"left shoulder",
             [](Shoulder& s) {
               MirrorThorax(s);
               MirrorScapula(s);
             },
             "SC",
             "these are landmarks of a left shoulder. Make it a right one: negate z_m in every "
             "row"}));

TEST(FlawOfRightShoulder, IsToldWhateverTheThoraxsNamesAreMixedUpTo) {
  const ThoraxPoints right = ShippedShoulder().thorax;
  const std::array<Vector3, 4> places_m = {right.ij_m, right.px_m, right.c7_m, right.t8_m};
  std::array<std::size_t, 4> order = {0, 1, 2, 3};
  EXPECT_FALSE(FlawOf(ShippedShoulder()).has_value());
  while (std::next_permutation(order.begin(), order.end())) {
    Shoulder shoulder = ShippedShoulder();
    shoulder.thorax = {places_m.at(order[0]), places_m.at(order[1]), places_m.at(order[2]),
                       places_m.at(order[3]), right.sc_m};
    EXPECT_TRUE(FlawOf(shoulder).has_value()) << order[0] << order[1] << order[2] << order[3];
  }
}

// As near a line as is let pass, and not.
TEST(FlawOfRightShoulder, LetsLandmarksPassFivePercentOffALine) {
  Shoulder shoulder = ShippedShoulder();
  constexpr double kLength_m = 0.2;
  shoulder.scapula.ts_m = {0, 0, -kLength_m / 2};
  shoulder.scapula.ai_m = {0, -kLength_m * 0.11, -kLength_m};
  EXPECT_FALSE(FlawOf(shoulder).has_value());
  shoulder.scapula.ai_m.y = -kLength_m * 0.09;
  EXPECT_TRUE(FlawOf(shoulder).has_value());
}

// --- The turn of the humerus ----------------------------------------------------------------

TEST(IsHumerusTurnedAround, IsFalseWhereverTheRhythmTakesTheArm) {
  const ShoulderRhythm rhythm(TableOf(MeasuredRows()), {}, ShippedJointRanges());
  for (double elevation_deg = 0; elevation_deg <= 180; elevation_deg += 10) {
    for (double plane_deg = -60; plane_deg <= 135; plane_deg += 15) {
      const ShoulderPose pose =
          rhythm.SolvePose({RadiansFromDegrees(elevation_deg), RadiansFromDegrees(plane_deg)});
      EXPECT_FALSE(IsHumerusTurnedAround(pose.q_TH())) << elevation_deg << ", " << plane_deg;
    }
  }
}

// Half a turn about its own axis: what swapped epicondyles look like. Where people digitise.
TEST(IsHumerusTurnedAround, IsTrueOfTheOtherWayRoundWhereTheArmHangs) {
  const ShoulderRhythm rhythm(TableOf(MeasuredRows()), {}, ShippedJointRanges());
  for (double elevation_deg = 0; elevation_deg <= 30; elevation_deg += 10) {
    for (double plane_deg = 0; plane_deg <= 90; plane_deg += 15) {
      const ShoulderPose pose =
          rhythm.SolvePose({RadiansFromDegrees(elevation_deg), RadiansFromDegrees(plane_deg)});
      EXPECT_TRUE(IsHumerusTurnedAround(pose.q_TH() * Quaternion(0, 0, 1, 0)))
          << elevation_deg << ", " << plane_deg;
    }
  }
}

TEST(IsHumerusTurnedAround, BeginsAt120Degrees) {
  for (const double side : {1.0, -1.0}) {
    const auto turned = [&](double angle_deg) {
      return Exp(Vector3(0, side * RadiansFromDegrees(angle_deg), 0));
    };
    EXPECT_FALSE(IsHumerusTurnedAround(turned(119)));
    EXPECT_TRUE(IsHumerusTurnedAround(turned(121)));
    // Whatever the quaternion's sign.
    EXPECT_FALSE(IsHumerusTurnedAround(-turned(119)));
    EXPECT_TRUE(IsHumerusTurnedAround(-turned(121)));
  }
}

TEST(IsHumerusTurnedAround, SaysNothingOfAnArmStraightUp) {
  const Quaternion up = Exp(Vector3(0, 0, RadiansFromDegrees(170)));
  EXPECT_FALSE(IsHumerusTurnedAround(up * Exp(Vector3(0, kPi, 0))));
}

}  // namespace
}  // namespace girdle::isb_frames_test
