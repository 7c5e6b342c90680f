// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/fitted_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <sstream>
#include <stdexcept>
#include <string>

#include "anatomy/built_in_anatomy.h"
#include "anatomy/person_landmarks.h"
#include "anatomy/posed_bones.h"
#include "rhythm_tables/built_in_tables.h"
#include "skin/bone_shapes.h"
#include "skin/built_in_files.h"
#include "skin/solids.h"
#include "skin/surface_depth.h"
#include "skin/surface_topology.h"
#include "skin/weight_blend.h"
#include "text/csv_text.h"
#include "text/input_error.h"
#include "text/text_in_data.h"

namespace girdle::fitted_body_test {
namespace {

// Landmarks are rounded to a micrometre each.
constexpr double kRounded_m = 3e-6;
constexpr double kRounded_rad = 1e-4;
constexpr double kExact = 1e-12;

const Vector3 kShoulder_m{-0.05, 0.98, 0.19};
const Vector3 kElbow_m{-0.06, 0.79, 0.36};
const Vector3 kWrist_m{0.13, 0.66, 0.49};

MakeHumanFit Fit() {
  MakeHumanFit fit;
  fit.notch_skin_m = 0.004;
  fit.shoulder_joint = "shoulder";
  fit.shoulder_medially_m = 0.01;
  fit.elbow_joint = "elbow";
  fit.elbow_medially_m = 0.005;
  fit.wrist_joint = "wrist";
  fit.thorax_scale = 0.9;
  fit.scapula_scale = 0.95;
  fit.waist_below_notch_m = 0.1;
  fit.neck_above_notch_m = 0.1;
  return fit;
}

// A ball with the joints of a man, whose first vertex is moved to where the notch should be.
MakeHumanBody BallMan() {
  MakeHumanBody man;
  man.surface = Ball(0.3, 0.05);
  for (Vector3& vertex : man.surface.vertices_m) vertex += Vector3{0, 1, 0};
  man.joints_m = {{"shoulder", kShoulder_m}, {"elbow", kElbow_m}, {"wrist", kWrist_m}};
  man.artist.assign(7, std::vector<double>(man.surface.vertices_m.size()));
  man.artist[0].assign(man.surface.vertices_m.size(), 1);
  return man;
}

Vector3 NotchOf(const MakeHumanBody& man) {
  return InMedianPlane(man.surface.vertices_m[0]) - Vector3{0.004, 0, 0};
}

FittedBody Fitted(const MakeHumanBody& man, Head head = Head::kKept) {
  return FitBones(man, Fit(), BuiltInAnatomy(), RelaxedStanding(), BuiltInRhythm(), head);
}

TEST(FitBones, PutsGHMediallyOfTheJoint) {
  const MakeHumanBody man = BallMan();
  const PosedBody body = Fitted(man).body;
  const Vector3 gh_m = LandmarkInThorax_m(body.anatomy, body.pose, Landmark::kGH);
  EXPECT_LT(glm::distance(gh_m, kShoulder_m - NotchOf(man) - Vector3{0, 0, 0.01}), kRounded_m);
}

TEST(FitBones, PutsTheElbowMediallyOfTheJoint) {
  const MakeHumanBody man = BallMan();
  const PosedBody body = Fitted(man).body;
  const Vector3 elbow_m =
      InThorax_m(body.anatomy, body.pose, Segment::kHumerus, body.anatomy.elbow_m());
  EXPECT_LT(glm::distance(elbow_m, kElbow_m - NotchOf(man) - Vector3{0, 0, 0.005}), kRounded_m);
}

TEST(FitBones, StandsTheScapulaAsInThePosture) {
  const Posture relaxed = RelaxedStanding();
  EXPECT_LT(AngleBetween(Fitted(BallMan()).body.pose.q_TS(), relaxed.q_TC * relaxed.q_CS), kExact);
}

TEST(FitBones, TurnsTheClavicleByTheSmallestRotation) {
  const Posture relaxed = RelaxedStanding();
  const Quaternion q_TC = Fitted(BallMan()).body.pose.q_TC;
  const Vector3 z{0, 0, 1};
  EXPECT_NEAR(AngleBetween(q_TC, relaxed.q_TC), std::acos(glm::dot(q_TC * z, relaxed.q_TC * z)),
              kExact);
}

TEST(FitBones, TurnsTheHumerusAsTheRhythmDoes) {
  const Quaternion q_TH = Fitted(BallMan()).body.pose.q_TH();
  const ArmAngles arm = ArmAnglesFromRotation(q_TH);
  const Quaternion rhythms = BuiltInRhythm().SolvePose({arm.elevation_rad, arm.plane_rad}).q_TH();
  EXPECT_LT(AngleBetween(q_TH, rhythms), kRounded_rad);
}

TEST(FitBones, ScalesThoraxAndScapula) {
  const Anatomy adult = BuiltInAnatomy();
  const Anatomy anatomy = Fitted(BallMan()).body.anatomy;
  EXPECT_LT(glm::distance(anatomy.landmark_m(Landmark::kC7), 0.9 * adult.landmark_m(Landmark::kC7)),
            kRounded_m);
  EXPECT_LT(
      glm::distance(anatomy.landmark_m(Landmark::kAI), 0.95 * adult.landmark_m(Landmark::kAI)),
      kRounded_m);
}

TEST(FitBones, MeasuresTheNotchsHeightFromTheGround) {
  const MakeHumanBody man = BallMan();
  double ground_m = 1;
  for (const Vector3& vertex : man.surface.vertices_m) ground_m = std::min(ground_m, vertex.y);
  EXPECT_NEAR(Fitted(man).body.anatomy.jugular_notch_height_m, NotchOf(man).y - ground_m, kExact);
}

TEST(FitBones, GivesLandmarksThatReadBackAsTheyAre) {
  const Anatomy anatomy = Fitted(BallMan()).body.anatomy;
  std::istringstream in(LandmarksToCsv(anatomy, {"# a comment"}));
  EXPECT_EQ(ReadPersonAnatomy(in, "t.csv", BuiltInAnatomy()).landmarks_m, anatomy.landmarks_m);
}

TEST(FitBones, CutsAtTheWaist) {
  const FittedBody fitted = Fitted(BallMan());
  EXPECT_TRUE(IsClosed(fitted.body.surface));
  double lowest_m = 1;
  for (const Vector3& vertex : fitted.body.surface.vertices_m) {
    lowest_m = std::min(lowest_m, vertex.y);
  }
  EXPECT_NEAR(lowest_m, -0.1, kExact);
}

TEST(FitBones, SaysWhichJointABodyLacks) {
  MakeHumanBody man = BallMan();
  man.joints_m.erase("elbow");
  EXPECT_EQ(MessageOf<std::invalid_argument>([&] { static_cast<void>(Fitted(man)); }),
            "the body has no 'elbow'");
}

class FlawedFit : public testing::TestWithParam<CsvFlaw> {};

TEST_P(FlawedFit, IsRefusedWithItsLine) {
  CsvText text(built_in_files::kMakeHumanFit);
  GetParam().change(text);
  std::istringstream in(text.Text());
  EXPECT_EQ(MessageOf<InputError>([&] { static_cast<void>(ReadMakeHumanFit(in, "f.csv")); }),
            GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Rows, FlawedFit,
    testing::Values(CsvFlaw{"unknown", [](CsvText& text) { text.Cell(0, "quantity") = "knee"; },
                            "f.csv:2: 'knee' is not known, or is given twice"},
                    CsvFlaw{"twice",
                            [](CsvText& text) { text.Cell(1, "quantity") = "notch_vertex"; },
                            "f.csv:3: 'notch_vertex' is not known, or is given twice"},
                    CsvFlaw{"missing", [](CsvText& text) { text.RemoveRow(0); },
                            "f.csv:11: no row for notch_vertex"},
                    CsvFlaw{"half a vertex", [](CsvText& text) { text.Cell(0, "value") = "1.5"; },
                            "f.csv:2: a vertex has a whole number"}),
    [](const auto& tested) {
      std::string name = tested.param.name;
      std::replace(name.begin(), name.end(), ' ', '_');
      return name;
    });

// scripts/setup --python fetches him.
const FittedBody& Man() {
  static const FittedBody kMan =
      FitBones(ReadMakeHumanMan(GIRDLE_SOURCE_DIR "/build/body"), BuiltInMakeHumanFit(),
               BuiltInAnatomy(), RelaxedStanding(), BuiltInRhythm(), Head::kKept);
  return kMan;
}

TEST(FittedMan, IsClosed) { EXPECT_TRUE(IsClosed(Man().body.surface)); }

TEST(FittedMan, IsTheMirrorImageOfHimself) {
  const SurfaceDepth skin(Man().body.surface);
  // The project's files have four decimals of a decimetre.
  constexpr double kMirrored_m = 1e-5;
  for (std::size_t i = 0; i < Man().body.surface.vertices_m.size(); i += 50) {
    EXPECT_LT(skin.Distance_m(Mirrored(Man().body.surface.vertices_m[i])), kMirrored_m) << i;
  }
}

TEST(FittedMan, HasEveryLandmarkWhereItBelongsUnderTheSkin) {
  const SurfaceDepth skin(Man().body.surface);
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    const auto landmark = static_cast<Landmark>(i);
    const double depth_m =
        skin.Depth_m(LandmarkInThorax_m(Man().body.anatomy, Man().body.pose, landmark));
    EXPECT_GT(depth_m, 0.003) << kLandmarks[i].name;
    // The joint lies in the middle of the shoulder, the coracoid process before it.
    const bool is_deep = landmark == Landmark::kGH || landmark == Landmark::kGC;
    const double deepest_m = is_deep ? 0.06 : landmark == Landmark::kPC ? 0.03 : 0.025;
    EXPECT_LT(depth_m, deepest_m) << kLandmarks[i].name;
  }
}

TEST(FittedMan, PointsHisForearmsToWhereElbowsBend) {
  // The hands lie farthest along the humerus; x is where an elbow bends to, z its hinge.
  const PosedBody& body = Man().body;
  const Vector3 elbow_m =
      InThorax_m(body.anatomy, body.pose, Segment::kHumerus, body.anatomy.elbow_m());
  Vector3 farthest{0, 0, 0};
  for (const Vector3& vertex : body.surface.vertices_m) {
    const Vector3 p_H = glm::conjugate(body.pose.q_TH()) * (vertex - elbow_m);
    if (p_H.x > farthest.x && vertex.z > 0.3) farthest = p_H;
  }
  EXPECT_GT(farthest.x, 0.15);
  EXPECT_LT(std::abs(farthest.z / farthest.x), std::tan(RadiansFromDegrees(15)));
}

TEST(MakeHumanFit, IsTheShippedFileByteForByte) {
  EXPECT_EQ(built_in_files::kMakeHumanFit, TextInData("makehuman_fit.csv"));
}

}  // namespace
}  // namespace girdle::fitted_body_test
