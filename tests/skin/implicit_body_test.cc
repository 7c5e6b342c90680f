// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/implicit_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <glm/geometric.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "anatomy/body_size.h"
#include "anatomy/built_in_anatomy.h"
#include "rhythm_tables/built_in_tables.h"
#include "skin/bone_heat.h"
#include "skin/bone_shapes.h"
#include "skin/bound_skin.h"
#include "skin/skn_file.h"
#include "skin/surface_depth.h"
#include "skin/surface_topology.h"

namespace girdle::implicit_body_test {
namespace {

const std::vector<Side> kBoth = {Side::kRight, Side::kLeft};

// How deep the nearest bone lies under the skin, at least.
constexpr double kShallowest_mm = 3;

// Bodies of these sides, of an adult, made once.
const PosedBody& AdultBody(const std::vector<Side>& sides) {
  static const PosedBody kBodyOfBoth = ImplicitBody(BuiltInAnatomy(), kBoth);
  static const PosedBody kRightBody = ImplicitBody(BuiltInAnatomy(), {Side::kRight});
  static const PosedBody kLeftBody = ImplicitBody(BuiltInAnatomy(), {Side::kLeft});
  return sides.size() == 2 ? kBodyOfBoth : sides[0] == Side::kRight ? kRightBody : kLeftBody;
}

BoundSkin SkinOf(const PosedBody& body, const std::vector<Side>& sides) {
  const std::vector<SkinBone> bones = SkinBonesOf(sides);
  return Bind(body, bones, BoneHeat(body.surface, BoneShapesOf(body, bones)));
}

class ImplicitBodyOf : public testing::TestWithParam<std::vector<Side>> {
 protected:
  static const PosedBody& Body() { return AdultBody(GetParam()); }
};

std::string NameOfSides(const testing::TestParamInfo<std::vector<Side>>& sides) {
  return sides.param.size() == 2 ? "both" : sides.param.front() == Side::kRight ? "right" : "left";
}

INSTANTIATE_TEST_SUITE_P(Sides, ImplicitBodyOf,
                         testing::Values(kBoth, std::vector<Side>{Side::kRight},
                                         std::vector<Side>{Side::kLeft}),
                         NameOfSides);

TEST_P(ImplicitBodyOf, IsOneClosedPieceWithoutAHole) {
  EXPECT_TRUE(UnpairedEdges(Body().surface).empty());
  EXPECT_EQ(EulerCharacteristic(Body().surface), 2);
}

TEST_P(ImplicitBodyOf, FacesOutward) { EXPECT_GT(Volume_m3(Body().surface), 0); }

TEST(ImplicitBody, HasAsManyVerticesAsAPictureNeeds) {
  EXPECT_GE(AdultBody(kBoth).surface.vertices_m.size(), 7000U);
  EXPECT_LE(AdultBody(kBoth).surface.vertices_m.size(), 17000U);
}

// A trunk without head, hip and legs: half of the weight of a person (Dempster 1955, in Winter:
// the trunk 49.7 %, of which the pelvis is 14.2 %, and each arm 5 %), at the density of water.
TEST(ImplicitBody, HasTheVolumeOfAnUpperBody) {
  constexpr double kBodyMass_kg = 71;
  constexpr double kWater_kg_per_m3 = 1000;
  const double share = Volume_m3(AdultBody(kBoth).surface) * kWater_kg_per_m3 / kBodyMass_kg;
  EXPECT_NEAR(share, 0.497 - 0.142 + 2 * 0.05, 0.12) << "of a lean adult";
}

// Farthest that a body's vertices lie from another body's surface: a sample of them, since each
// asks all triangles.
double Apart_m(const PosedBody& body, const PosedBody& other) {
  constexpr std::size_t kEvery = 23;
  const SurfaceDepth surface(other.surface);
  double farthest_m = 0;
  for (std::size_t i = 0; i < body.surface.vertices_m.size(); i += kEvery) {
    farthest_m = std::max(farthest_m, surface.Distance_m(body.surface.vertices_m[i]));
  }
  return farthest_m;
}

PosedBody InTheMirror(PosedBody body) {
  for (Vector3& vertex_m : body.surface.vertices_m) {
    vertex_m = Mirrored(vertex_m);
  }
  for (Triangle& triangle : body.surface.triangles) {
    std::swap(triangle[1], triangle[2]);
  }
  return body;
}

// The grid's cells need not be each other's mirror image.
TEST(ImplicitBody, OfBothSidesIsItsOwnMirrorImage) {
  EXPECT_LT(Apart_m(InTheMirror(AdultBody(kBoth)), AdultBody(kBoth)), kImplicitCell_m / 2);
}

TEST(ImplicitBody, OfTheLeftIsTheMirrorImageOfThatOfTheRight) {
  EXPECT_LT(Apart_m(InTheMirror(AdultBody({Side::kLeft})), AdultBody({Side::kRight})),
            kImplicitCell_m / 2);
}

TEST(ImplicitBody, HasAnArmOfEachSideThatIsAskedFor) {
  for (const Side own : kBoth) {
    const std::vector<Side> sides = {own};
    const PosedBody& body = AdultBody(sides);
    const SurfaceDepth surface(body.surface);
    for (const Side side : kBoth) {
      const auto place_m = [&](Segment segment, const Vector3& point_m) {
        return OnSideInThorax_m(body.anatomy, body.pose, side, segment, point_m);
      };
      const Vector3 elbow_m = place_m(Segment::kHumerus, body.anatomy.elbow_m());
      // A stump ends above the middle of the arm.
      EXPECT_EQ(surface.Depth_m(elbow_m) > 0, side == own);
      EXPECT_EQ(surface.Depth_m(place_m(Segment::kHumerus, body.anatomy.elbow_m() / 2.0)) > 0,
                side == own);
      EXPECT_GT(surface.Depth_m(place_m(Segment::kHumerus, {0, 0, 0})), 0.01) << "the shoulder";
      EXPECT_GT(surface.Depth_m(place_m(Segment::kScapula, body.anatomy.landmark_m(Landmark::kAI))),
                kShallowest_mm / 1000);
    }
  }
}

TEST(ImplicitBody, StandsWithTheArmsRaisedBy45Degrees) {
  const ArmAngles arm = ArmAnglesFromRotation(AdultBody(kBoth).pose.q_TH());
  // The rhythm's arm is as exact as rounding.
  EXPECT_NEAR(arm.elevation_rad, RadiansFromDegrees(45), 1e-9);
  EXPECT_NEAR(arm.plane_rad, 0, 1e-9);
}

TEST(ImplicitBody, IsTheSameEveryTime) {
  const PosedBody again = ImplicitBody(BuiltInAnatomy(), kBoth);
  EXPECT_EQ(SknBytes(SkinOf(again, kBoth)), SknBytes(SkinOf(AdultBody(kBoth), kBoth)));
}

// Halving is exact, so that no corner of the grid changes sides by rounding.
TEST(ImplicitBody, OfAPersonHalfAsTallIsHalfAsLarge) {
  const PosedBody half =
      ImplicitBody(ScaledAnatomy(BuiltInAnatomy(), {.stature_m = kAdultStature_m / 2}), kBoth);
  const TriangleMesh& adult = AdultBody(kBoth).surface;
  EXPECT_TRUE(half.surface.triangles == adult.triangles);
  ASSERT_EQ(half.surface.vertices_m.size(), adult.vertices_m.size());
  constexpr double kRounding_m = 1e-12;
  for (std::size_t i = 0; i < adult.vertices_m.size(); ++i) {
    ASSERT_LT(glm::distance(half.surface.vertices_m[i], adult.vertices_m[i] / 2.0), kRounding_m);
  }
}

// Landmarks of a right shoulder and of the thorax where a model of both shoulders has them.
Vector3 Place_m(const Anatomy& anatomy, const ShoulderPose& pose, std::size_t landmark) {
  const Vector3 place_m = OnSideInThorax_m(
      anatomy, pose, Side::kRight, kLandmarks[landmark].segment, anatomy.landmarks_m[landmark]);
  return kLandmarks[landmark].sided ? place_m : InMedianPlane(place_m);
}

bool IsOfElbow(std::size_t landmark) { return kLandmarks[landmark].segment == Segment::kHumerus; }

// The triangles of a skin whose corners hang on a bone by more than half.
TriangleMesh MostlyOn(const BoundSkin& skin, const std::string& body) {
  std::vector<bool> is_on(skin.surface.vertices_m.size());
  for (const BoundBone& bone : skin.bones) {
    if (bone.body == body) {
      for (const VertexWeight& share : bone.weights) {
        is_on[static_cast<std::size_t>(share.vertex)] = share.weight > 0.5;
      }
    }
  }
  TriangleMesh part{skin.surface.vertices_m, {}};
  for (const Triangle& triangle : skin.surface.triangles) {
    if (std::all_of(triangle.begin(), triangle.end(),
                    [&](int corner) { return is_on[static_cast<std::size_t>(corner)]; })) {
      part.triangles.push_back(triangle);
    }
  }
  return part;
}

struct PoseToLookAt {
  double elevation_deg;
  double plane_deg;
};

// All over the range, and closer across the body, where the scapula goes farthest.
std::vector<PoseToLookAt> PosesToLookAt() {
  std::vector<PoseToLookAt> poses;
  for (double elevation_deg = 0; elevation_deg <= 180; elevation_deg += 20) {
    for (double plane_deg = -60; plane_deg <= 135; plane_deg += 32.5) {
      poses.push_back({elevation_deg, plane_deg});
    }
  }
  for (double elevation_deg = 60; elevation_deg <= 180; elevation_deg += 7.5) {
    for (double plane_deg = 120; plane_deg <= 135; plane_deg += 7.5) {
      poses.push_back({elevation_deg, plane_deg});
    }
  }
  return poses;
}

// The left arm at rest. The epicondyles may come to lie in the
// trunk or the other arm where no arm could go: of them the arm's own skin is asked.
TEST(SkinOfTheImplicitBody, CoversEveryLandmarkWhereverTheArmGoes) {
  const PosedBody& body = AdultBody(kBoth);
  const std::vector<SkinBone> bones = SkinBonesOf(kBoth);
  const BoundSkin bound = SkinOf(body, kBoth);
  const TriangleMesh humeral = MostlyOn(bound, "humerus_r");
  const ShoulderRhythm rhythm = BuiltInRhythm();
  for (const auto& [elevation_deg, plane_deg] : PosesToLookAt()) {
    const ShoulderPose pose =
        rhythm.Solve({RadiansFromDegrees(elevation_deg), RadiansFromDegrees(plane_deg)}).pose;
    std::vector<BoneFrame> frames;
    frames.reserve(bones.size());
    for (const SkinBone& bone : bones) {
      frames.push_back(
          FrameInThorax(body.anatomy, bone.side == Side::kRight ? pose : body.pose, bone));
    }
    const std::vector<Vector3> vertices_m = BlendedVertices_m(bound, frames);
    const SurfaceDepth skin({vertices_m, bound.surface.triangles});
    const SurfaceDepth arm({vertices_m, humeral.triangles});
    for (std::size_t i = 0; i < kLandmarkCount; ++i) {
      const Vector3 place_m = Place_m(body.anatomy, pose, i);
      EXPECT_GE(1000 * (IsOfElbow(i) ? arm : skin).Depth_m(place_m), kShallowest_mm)
          << kLandmarks[i].name << " at elevation " << elevation_deg << ", plane " << plane_deg;
    }
  }
}

// Somebody else: what is known of them.
struct Person {
  const char* name;
  BodySize size;
};

void PrintTo(const Person& person, std::ostream* out) { *out << person.name; }

class ImplicitBodyOfSomebody : public testing::TestWithParam<Person> {
 protected:
  Anatomy anatomy_ = ScaledAnatomy(BuiltInAnatomy(), GetParam().size);
  PosedBody body_ = ImplicitBody(anatomy_, kBoth);
};

INSTANTIATE_TEST_SUITE_P(Sizes, ImplicitBodyOfSomebody,
                         testing::Values(Person{"child", {.stature_m = 1.0}},
                                         Person{"small", {.stature_m = 1.5}},
                                         Person{"tall", {.stature_m = 2.0}},
                                         Person{"short clavicle", {.clavicle_length_m = 0.13}},
                                         Person{"long clavicle", {.clavicle_length_m = 0.18}},
                                         Person{"long humerus", {.humerus_length_m = 0.33}},
                                         Person{"long scapula", {.scapula_length_m = 0.15}}));

// One test, since making a body takes most of the time.
TEST_P(ImplicitBodyOfSomebody, IsClosedAndOnePieceAndCoversEveryLandmark) {
  EXPECT_TRUE(UnpairedEdges(body_.surface).empty());
  EXPECT_EQ(EulerCharacteristic(body_.surface), 2);
  const SurfaceDepth skin(body_.surface);
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    EXPECT_GE(1000 * skin.Depth_m(Place_m(anatomy_, body_.pose, i)), kShallowest_mm)
        << kLandmarks[i].name;
  }
}

}  // namespace
}  // namespace girdle::implicit_body_test
