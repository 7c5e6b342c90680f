// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/skin_measures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "anatomy/built_in_anatomy.h"
#include "anatomy/posed_bones.h"
#include "kinematics/one_sided_difference.h"
#include "rhythm_tables/built_in_tables.h"
#include "skin/bone_heat.h"
#include "skin/bone_shapes.h"
#include "skin/implicit_body.h"

namespace girdle::skin_measures_test {
namespace {

// Metres; sums of some roundings of a body's size.
constexpr double kExact_m = 1e-13;
// Rounding over the step of the differences (0.02 deg), with the weights of their formula.
constexpr double kDifferences_m_per_rad = 1e-9;

const ShoulderPose& Bind() {
  static const ShoulderPose kBind =
      BuiltInRhythm().SolvePose({RadiansFromDegrees(45), RadiansFromDegrees(20)});
  return kBind;
}

// A skin without triangles on the bones of the built-in anatomy, bound in Bind().
class SkinMaker {
 public:
  explicit SkinMaker(const std::vector<Side>& sides = {Side::kRight}) {
    for (const SkinBone& bone : SkinBonesOf(sides)) {
      skin_.bones.push_back({bone.name(), FrameInThorax(BuiltInAnatomy(), Bind(), bone), {}});
    }
  }

  // Adds a vertex with these shares and returns its number.
  int Add(const Vector3& vertex_m, const std::vector<std::pair<std::string, double>>& shares) {
    const int vertex = static_cast<int>(skin_.surface.vertices_m.size());
    skin_.surface.vertices_m.push_back(vertex_m);
    for (const auto& [body, weight] : shares) {
      Bone(body).weights.push_back({vertex, weight});
    }
    return vertex;
  }

  BoundBone& Bone(const std::string& body) {
    return *std::find_if(skin_.bones.begin(), skin_.bones.end(),
                         [&](const BoundBone& bone) { return bone.body == body; });
  }

  BoundSkin& skin() { return skin_; }
  [[nodiscard]] SkinOnBones OnBones() const { return {skin_, BuiltInAnatomy()}; }

 private:
  BoundSkin skin_;
};

// All five landmarks at one vertex.
SkinLandmarkVertices AllAt(int vertex) {
  SkinLandmarkVertices vertices;
  vertices.fill({vertex});
  return vertices;
}

TEST(SkinOnBones, InTheBindPoseEveryVertexStaysWhereItWasBound) {
  SkinMaker maker;
  const Vector3 vertex_m{0.02, -0.1, 0.15};
  maker.Add(vertex_m,
            {{"thorax", 0.1}, {"clavicle_r", 0.2}, {"scapula_r", 0.3}, {"humerus_r", 0.4}});
  const SkinOnBones skin = maker.OnBones();
  EXPECT_LT(glm::distance(skin.VerticesIn_m(skin.BindPose(Side::kRight)).front(), vertex_m),
            kExact_m);
}

// Skin half on the scapula and half on the humerus, beside GH: turned by phi it is drawn in to
// cos(phi / 2) of its distance and turned by half of phi.
TEST(SkinOnBones, BetweenTwoBonesSkinCollapsesByTheCosineOfHalfTheTurn) {
  const Vector3 center_m = LandmarkInThorax_m(BuiltInAnatomy(), Bind(), Landmark::kGH);
  const Vector3 axis_S = glm::normalize(Vector3{0.3, -0.5, 0.8});
  const Vector3 axis_T = Bind().q_TS() * axis_S;
  const Vector3 off_m = 0.05 * glm::normalize(glm::cross(axis_T, Vector3{1, 0, 0}));
  for (const double turn_deg : {10.0, 90.0, 150.0}) {
    const double turn_rad = RadiansFromDegrees(turn_deg);
    SkinMaker maker;
    maker.Add(center_m + off_m, {{"scapula_r", 0.5}, {"humerus_r", 0.5}});
    ShoulderPose turned = Bind();
    turned.q_SH = Exp(turn_rad * axis_S) * turned.q_SH;
    const Vector3 wanted_m =
        center_m + std::cos(turn_rad / 2) * (Exp(turn_rad / 2 * axis_T) * off_m);
    EXPECT_LT(glm::distance(maker.OnBones().VerticesIn_m(turned).front(), wanted_m), kExact_m)
        << turn_deg;
  }
}

TEST(SkinOnBones, FindsThePoseThatItWasBoundInOnEitherSide) {
  const SkinOnBones skin = SkinMaker({Side::kRight, Side::kLeft}).OnBones();
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const ShoulderPose pose = skin.BindPose(side);
    EXPECT_LT(AngleBetween(pose.q_TC, Bind().q_TC), kExact_m);
    EXPECT_LT(AngleBetween(pose.q_CS, Bind().q_CS), kExact_m);
    EXPECT_LT(AngleBetween(pose.q_SH, Bind().q_SH), kExact_m);
    EXPECT_LT(skin.MisplacedBones_m(side), kExact_m);
  }
}

TEST(SkinOnBones, RefusesABoneThatIsNoneAndMissesOneThatIsNotThere) {
  SkinMaker maker;
  EXPECT_THROW(static_cast<void>(maker.OnBones().BindPose(Side::kLeft)), std::invalid_argument);
  maker.Bone("scapula_r").body = "pelvis";
  try {
    static_cast<void>(maker.OnBones());
    FAIL() << "a skin on the pelvis was taken";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("\"pelvis\""), std::string::npos) << error.what();
  }
}

TEST(SkinOnBones, SaysHowFarABoneWasFromItsPlaceWhenTheSkinWasBound) {
  constexpr double kMoved_m = 0.0015;
  for (const char* const body : {"thorax", "clavicle_r", "scapula_r", "humerus_r"}) {
    SkinMaker maker;
    maker.Bone(body).bind.p_TB_m.x += kMoved_m;
    EXPECT_NEAR(maker.OnBones().MisplacedBones_m(Side::kRight), kMoved_m, kExact_m) << body;
  }
}

TEST(LandmarkSkin, OfSeveralVerticesMeansTheirMean) {
  SkinMaker maker;
  SkinLandmarkVertices vertices = AllAt(maker.Add({0, 0, 0.3}, {{"thorax", 1}}));
  vertices[1] = {maker.Add({0.1, 0, 0}, {{"thorax", 1}}), maker.Add({0, 0.2, 0}, {{"thorax", 1}})};
  const SkinLandmarkPlaces places = LandmarkSkin(maker.OnBones(), vertices).In_m(Bind());
  EXPECT_LT(glm::distance(places[0], Vector3(0, 0, 0.3)), kExact_m);
  EXPECT_LT(glm::distance(places[1], Vector3(0.05, 0.1, 0)), kExact_m);
  EXPECT_LT(glm::distance(places[4], Vector3(0, 0, 0.3)), kExact_m);
}

// What a landmark is on must not depend on the vertices that it is taken from.
TEST(LandmarkSkin, MovesAsTheWholeSkinDoes) {
  const std::vector<SkinBone> bones = SkinBonesOf({Side::kRight});
  const PosedBody body = ImplicitBody(BuiltInAnatomy(), {Side::kRight});
  const SkinOnBones skin(Bind(body, bones, BoneHeat(body.surface, BoneShapesOf(body, bones))),
                         BuiltInAnatomy());
  const SkinLandmarkVertices vertices = FindSkinLandmarks(body, Side::kRight);
  const LandmarkSkin landmarks(skin, vertices);
  const ShoulderPose pose = BuiltInRhythm().SolvePose({RadiansFromDegrees(110), 0});
  const std::vector<Vector3> all_m = skin.VerticesIn_m(pose);
  const SkinLandmarkPlaces places_m = landmarks.In_m(pose);
  for (std::size_t k = 0; k < kSkinLandmarkCount; ++k) {
    Vector3 mean_m{0, 0, 0};
    for (const int vertex : vertices[k]) {
      mean_m += all_m[static_cast<std::size_t>(vertex)] / static_cast<double>(vertices[k].size());
    }
    EXPECT_LT(glm::distance(places_m[k], mean_m), kExact_m) << kSkinLandmarkNames[k];
  }
}

// Skin that is the acromion's alone rises with the bone.
TEST(AcromionIn, RisesAsSkinThatIsBoundToTheScapulaAlone) {
  for (const Side side : {Side::kRight, Side::kLeft}) {
    SkinMaker maker({Side::kRight, Side::kLeft});
    const Vector3 tip_m = AcromionIn_m(BuiltInAnatomy(), Bind(), side);
    const int vertex = maker.Add(tip_m, {{SidedName("scapula", side), 1}});
    const ShoulderPose pose = BuiltInRhythm().SolvePose({RadiansFromDegrees(120), 0});
    const Vector3 bone_m = AcromionIn_m(BuiltInAnatomy(), pose, side);
    EXPECT_GT(glm::distance(bone_m, tip_m), 0.01);
    EXPECT_LT(glm::distance(LandmarkSkin(maker.OnBones(), AllAt(vertex)).In_m(pose)[0], bone_m),
              kExact_m);
  }
}

// Two triangles, of three quarters and one quarter of the area.
TriangleMesh TwoTriangles() {
  return {{{0, 0, 0}, {3, 0, 0}, {0, 1, 0}, {0, 0, 5}, {1, 0, 5}, {0, 1, 5}},
          {{0, 1, 2}, {3, 4, 5}}};
}

std::vector<Vector3> Squeezed(const TriangleMesh& surface, std::size_t first, std::size_t count,
                              double factor) {
  std::vector<Vector3> vertices_m = surface.vertices_m;
  for (std::size_t i = first; i < first + count; ++i) {
    vertices_m[i].x *= factor;
  }
  return vertices_m;
}

TEST(ChangeOfAreas, OfAUniformSqueezeIsTheSqueeze) {
  const TriangleMesh surface = TwoTriangles();
  for (const double factor : {0.3, 0.6, 1.0, 1.7}) {
    const AreaChange change = ChangeOfAreas(surface, Squeezed(surface, 0, 6, factor), {0, 1});
    EXPECT_NEAR(change.kept, factor, kExact_m);
    EXPECT_NEAR(change.fifth_percentile, factor, kExact_m);
    EXPECT_EQ(change.below_half, factor < 0.5 ? 1 : 0);
  }
}

TEST(ChangeOfAreas, WeighsTrianglesByTheirAreaAtFirst) {
  const TriangleMesh surface = TwoTriangles();
  const AreaChange small = ChangeOfAreas(surface, Squeezed(surface, 3, 3, 0.2), {0, 1});
  EXPECT_NEAR(small.below_half, 0.25, kExact_m);
  EXPECT_NEAR(small.kept, 0.75 + 0.25 * 0.2, kExact_m);
  EXPECT_NEAR(small.fifth_percentile, 0.2, kExact_m);
  const AreaChange large = ChangeOfAreas(surface, Squeezed(surface, 0, 3, 0.2), {0, 1});
  EXPECT_NEAR(large.below_half, 0.75, kExact_m);
}

TEST(ChangeOfAreas, AFifthPercentileLeavesOutLessThanATwentieth) {
  // A sliver of 4 and then of 6 hundredths of the area, squeezed to a tenth.
  for (const double width : {0.04, 0.06}) {
    const TriangleMesh surface{
        {{0, 0, 0}, {width, 0, 0}, {0, 1, 0}, {0, 0, 5}, {1 - width, 0, 5}, {0, 1, 5}},
        {{0, 1, 2}, {3, 4, 5}}};
    const AreaChange change = ChangeOfAreas(surface, Squeezed(surface, 0, 3, 0.1), {0, 1});
    EXPECT_NEAR(change.fifth_percentile, width < 0.05 ? 1 : 0.1, kExact_m);
  }
}

TEST(ChangeOfAreas, IsNotKnownIfACornerIsNoNumberBeforeOrNow) {
  const TriangleMesh surface = TwoTriangles();
  TriangleMesh broken = surface;
  broken.vertices_m[1].x = std::numeric_limits<double>::quiet_NaN();
  for (const AreaChange& change : {ChangeOfAreas(surface, broken.vertices_m, {0, 1}),
                                   ChangeOfAreas(broken, surface.vertices_m, {0, 1})}) {
    EXPECT_TRUE(std::isnan(change.kept));
    EXPECT_TRUE(std::isnan(change.below_half));
    EXPECT_TRUE(std::isnan(change.fifth_percentile));
  }
}

TEST(ChangeOfAreas, LooksAtTheTrianglesNamedAndRefusesNone) {
  const TriangleMesh surface = TwoTriangles();
  const std::vector<Vector3> vertices_m = Squeezed(surface, 0, 3, 0.2);
  EXPECT_NEAR(ChangeOfAreas(surface, vertices_m, {1}).kept, 1, kExact_m);
  EXPECT_THROW(static_cast<void>(ChangeOfAreas(surface, vertices_m, {})), std::invalid_argument);
}

TEST(TrianglesNear, AreThoseWhoseMiddleIsWithinTheDistance) {
  const TriangleMesh surface = TwoTriangles();
  const Vector3 middle_m{1, 1.0 / 3, 0};
  EXPECT_EQ(TrianglesNear(surface, middle_m, 0.01), std::vector<std::size_t>{0});
  EXPECT_EQ(TrianglesNear(surface, middle_m + Vector3{0, 0, 0.02}, 0.01),
            std::vector<std::size_t>{});
  EXPECT_EQ(TrianglesNear(surface, middle_m, 6), (std::vector<std::size_t>{0, 1}));
}

// A clavicle that turns about the vertical, and a landmark on it alone, so far off the axis.
constexpr double kRadius_m = 0.12;

LandmarkSkin OnTheClavicle() {
  SkinMaker maker;
  const Vector3 center_m = BuiltInAnatomy().landmark_m(Landmark::kSC);
  const int vertex = maker.Add(center_m + Vector3{kRadius_m, 0.01, 0}, {{"clavicle_r", 1}});
  return {maker.OnBones(), AllAt(vertex)};
}

ShoulderPose Turned(double angle_rad) {
  return {Exp({0, angle_rad, 0}) * Bind().q_TC, Bind().q_CS, Bind().q_SH};
}

TEST(LargestJumps, OfAKinkIsTheChangeOfSpeedTimesTheRadius) {
  constexpr double kKink = 0.25;
  const LandmarkSkin landmarks = OnTheClavicle();
  const RhythmTable table = BuiltInRhythmTable(BuiltInTable::kMeasured);
  const double kink_rad = RadiansFromDegrees(60);
  const auto angle_rad = [&](double x_rad) {
    return 0.4 * x_rad + 0.1 * x_rad * x_rad + kKink * std::max(0.0, x_rad - kink_rad);
  };
  const LandmarkLargest kinked = LargestJumps_m_per_rad(
      landmarks, [&](const ArmCommand& at) { return Turned(angle_rad(at.elevation_rad)); }, table,
      Direction::kElevation);
  EXPECT_NEAR(kinked[0].value(), kKink * kRadius_m, kDifferences_m_per_rad);
  EXPECT_NEAR(kinked[0].place().elevation_rad, kink_rad, kExact_m);

  // What does not change with the elevation has no jump over it, and over planes the same kink is
  // at no knot.
  const LandmarkLargest across = LargestJumps_m_per_rad(
      landmarks, [&](const ArmCommand& at) { return Turned(angle_rad(at.elevation_rad)); }, table,
      Direction::kPlane);
  EXPECT_LT(across[0].value(), kDifferences_m_per_rad);
}

// The formulas' orders: of a cubic the third is exact, and a coarse step changes nothing.
TEST(LargestJumps, AreTheSameByAnyStepWhereTheMotionIsAsSimpleAsTheFormula) {
  const ArmCommand place{1, 0.5};
  const LandmarkFunction cubic = [](const ArmCommand& at) {
    const double x = at.elevation_rad - 1;
    const double bend = x > 0 ? 0.3 * x + 2 * x * x - x * x * x : 0.1 * x * x + 5 * x * x * x;
    SkinLandmarkPlaces places;
    places.fill({bend, 0, 0});
    return places;
  };
  for (const double step_rad : {1e-3, 0.02, 0.1}) {
    const LandmarkLargest jumps = LargestJumps_m_per_rad(cubic, Direction::kElevation, {place},
                                                         {kOneSidedFirstOfCoarse, step_rad});
    EXPECT_NEAR(jumps[0].value(), 0.3, 1e-10) << step_rad;
    EXPECT_EQ(jumps[0].place(), place);
  }
}

TEST(LargestJumps, AreOfThePlacesAskedForAlone) {
  const LandmarkFunction kinked = [](const ArmCommand& at) {
    SkinLandmarkPlaces places;
    places.fill({0, std::max(0.0, at.plane_rad - 0.5), 0});
    return places;
  };
  const SkinDifference difference{kOneSidedFirst, 0.01};
  EXPECT_NEAR(LargestJumps_m_per_rad(kinked, Direction::kPlane, {{1, 0.2}, {1, 0.5}}, difference)[0]
                  .value(),
              1, 1e-10);
  EXPECT_EQ(LargestJumps_m_per_rad(kinked, Direction::kPlane, {{1, 0.2}}, difference)[0].value(),
            0);
  EXPECT_EQ(
      LargestJumps_m_per_rad(kinked, Direction::kElevation, {{1, 0.5}}, difference)[0].value(), 0);
}

TEST(IsAcSkin, AreTheLandmarksOverTheJointAndTheAcromion) {
  const std::vector<bool> expected = {true, true, false, false, false};
  for (std::size_t k = 0; k < kSkinLandmarkCount; ++k) {
    EXPECT_EQ(IsAcSkin(k), expected[k]) << kSkinLandmarkNames[k];
  }
}

TEST(LargestJumps, SeeAKinkOverPlanes) {
  constexpr double kKink = 0.1;
  const LandmarkSkin landmarks = OnTheClavicle();
  const RhythmTable table = BuiltInRhythmTable(BuiltInTable::kMeasured);
  const double kink_rad = table.planes_rad()[1];
  const LandmarkLargest kinked = LargestJumps_m_per_rad(
      landmarks,
      [&](const ArmCommand& at) { return Turned(kKink * std::max(0.0, at.plane_rad - kink_rad)); },
      table, Direction::kPlane);
  EXPECT_NEAR(kinked[0].value(), kKink * kRadius_m, kDifferences_m_per_rad);
}

TEST(LargestJumps, OfASmoothMotionAreNone) {
  const LandmarkLargest smooth = LargestJumps_m_per_rad(
      OnTheClavicle(),
      [](const ArmCommand& at) { return Turned(std::sin(at.elevation_rad) + at.plane_rad); },
      BuiltInRhythmTable(BuiltInTable::kMeasured), Direction::kElevation);
  EXPECT_LT(smooth[0].value(), kDifferences_m_per_rad);
}

TEST(LargestSteps, OfAnEvenTurnAreTheChordOfADegree) {
  const RhythmTable table = BuiltInRhythmTable(BuiltInTable::kMeasured);
  const LandmarkLargest steps = LargestSteps_m(
      OnTheClavicle(),
      // Twice as fast in the second plane.
      [](const ArmCommand& at) { return Turned(at.elevation_rad * (at.plane_rad > 1 ? 2 : 1)); },
      table, {0, 1.5});
  EXPECT_NEAR(steps[0].value(), 2 * kRadius_m * std::sin(kRadiansPerDegree), kExact_m);
  EXPECT_EQ(steps[0].place().plane_rad, 1.5);
}

TEST(LargestSteps, KeepWhatIsNoNumber) {
  // Before numbers and after them.
  for (const bool is_first : {true, false}) {
    const LandmarkLargest steps = LargestSteps_m(
        OnTheClavicle(),
        [is_first](const ArmCommand& at) {
          return Turned((at.elevation_rad < 1) == is_first ? std::nan("") : at.elevation_rad);
        },
        BuiltInRhythmTable(BuiltInTable::kMeasured), {0});
    EXPECT_TRUE(std::isnan(steps[0].value())) << is_first;
  }
}

// A box far around the body: bound to the thorax it stays, and a landmark is as deep as its nearest
// side is far.
TEST(LandmarkDepths, InABoxAreTheDistancesFromItsSides) {
  constexpr double kHalf_m = 0.6;
  for (const std::vector<Side>& sides :
       {std::vector<Side>{Side::kRight}, {Side::kRight, Side::kLeft}}) {
    SkinMaker maker(sides);
    for (int i = 0; i < 8; ++i) {
      maker.Add(
          kHalf_m * Vector3((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1),
          {{"thorax", 1}});
    }
    maker.skin().surface.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6},
                                      {0, 1, 5}, {0, 5, 4}, {2, 6, 7}, {2, 7, 3},
                                      {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    const ShoulderPose pose = BuiltInRhythm().SolvePose({RadiansFromDegrees(90), 0});
    const LandmarkDepths depths_m = LandmarkDepths_m(maker.OnBones(), pose, sides.back());
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
      const Vector3 point_m = LandmarkInThorax_m(BuiltInAnatomy(), pose, static_cast<Landmark>(i));
      const bool is_median = sides.size() > 1 && !kLandmarks[i].sided;
      const double farthest_m =
          std::max({std::abs(point_m.x), std::abs(point_m.y), is_median ? 0 : std::abs(point_m.z)});
      EXPECT_NEAR(depths_m[i], kHalf_m - farthest_m, kExact_m) << kLandmarks[i].name;
    }
  }
}

// The mirror image of a skin of a right shoulder is one of a left one.
SkinOnBones MirroredSkin(const SkinOnBones& right) {
  BoundSkin left = right.bound();
  for (Vector3& vertex_m : left.surface.vertices_m) {
    vertex_m = Mirrored(vertex_m);
  }
  for (Triangle& triangle : left.surface.triangles) {
    std::swap(triangle[0], triangle[1]);
  }
  const std::vector<SkinBone> bones = SkinBonesOf({Side::kLeft});
  for (std::size_t i = 0; i < bones.size(); ++i) {
    left.bones[i].body = bones[i].name();
    left.bones[i].bind = FrameInThorax(right.anatomy(), right.BindPose(Side::kRight), bones[i]);
  }
  return {left, right.anatomy()};
}

TEST(SkinMeasures, OfTheMirrorImageAreTheSame) {
  const std::vector<SkinBone> bones = SkinBonesOf({Side::kRight});
  const PosedBody body = ImplicitBody(BuiltInAnatomy(), {Side::kRight});
  const SkinOnBones right(Bind(body, bones, BoneHeat(body.surface, BoneShapesOf(body, bones))),
                          BuiltInAnatomy());
  const SkinOnBones left = MirroredSkin(right);
  const SkinLandmarkVertices vertices = FindSkinLandmarks(body, Side::kRight);
  const ShoulderPose pose =
      BuiltInRhythm().SolvePose({RadiansFromDegrees(120), RadiansFromDegrees(40)});
  const SkinLandmarkPlaces right_m = LandmarkSkin(right, vertices).In_m(pose);
  const SkinLandmarkPlaces left_m = LandmarkSkin(left, vertices).In_m(pose);
  for (std::size_t k = 0; k < kSkinLandmarkCount; ++k) {
    EXPECT_LT(glm::distance(right_m[k], Mirrored(left_m[k])), kExact_m) << kSkinLandmarkNames[k];
  }
  const LandmarkDepths right_depths_m = LandmarkDepths_m(right, pose, Side::kRight);
  const LandmarkDepths left_depths_m = LandmarkDepths_m(left, pose, Side::kLeft);
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    // Those of the thorax are where the right shoulder's were dissected; only sided ones mirror.
    if (kLandmarks[i].sided) {
      EXPECT_NEAR(right_depths_m[i], left_depths_m[i], kExact_m) << kLandmarks[i].name;
    }
  }
}

}  // namespace
}  // namespace girdle::skin_measures_test
