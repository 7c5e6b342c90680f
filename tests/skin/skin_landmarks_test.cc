// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/skin_landmarks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/geometric.hpp>
#include <ostream>
#include <set>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "anatomy/body_size.h"
#include "anatomy/built_in_anatomy.h"
#include "skin/implicit_body.h"

namespace girdle::skin_landmarks_test {
namespace {

const std::vector<Side> kBoth = {Side::kRight, Side::kLeft};

const PosedBody& Body() {
  static const PosedBody kBody = ImplicitBody(BuiltInAnatomy(), kBoth);
  return kBody;
}

std::size_t IndexOf(std::string_view name) {
  return static_cast<std::size_t>(
      std::find(kSkinLandmarkNames.begin(), kSkinLandmarkNames.end(), name) -
      kSkinLandmarkNames.begin());
}

Vector3 Mean_m(const PosedBody& body, const std::vector<int>& vertices) {
  Vector3 sum_m{0, 0, 0};
  for (const int vertex : vertices) {
    sum_m += body.surface.vertices_m.at(static_cast<std::size_t>(vertex));
  }
  return sum_m / static_cast<double>(vertices.size());
}

Vector3 Landmark_m(const PosedBody& body, Side side, std::string_view name) {
  return Mean_m(body, FindSkinLandmarks(body, side).at(IndexOf(name)));
}

Vector3 Bone_m(const PosedBody& body, Side side, Segment segment, const Vector3& point_m) {
  return OnSideInThorax_m(body.anatomy, body.pose, side, segment, point_m);
}

// A landmark of the skin, the point of the bone that it lies over, and how near they are at most.
struct OverBone {
  const char* name;
  Segment segment;
  Vector3 (*point_m)(const Anatomy&);
  double within_mm;
};

void PrintTo(const OverBone& landmark, std::ostream* out) { *out << landmark.name; }

class SkinLandmark : public testing::TestWithParam<OverBone> {};

// As thick as the solids' flesh is over a bone that lies right under it, and a cell beside; the
// centre of the AC joint lies as much deeper as the joint is high.
constexpr double kSubcutaneous_mm = 35;
constexpr double kOverTheJoint_mm = 38;

INSTANTIATE_TEST_SUITE_P(
    OverBones, SkinLandmark,
    testing::Values(
        OverBone{"skin_ac", Segment::kScapula,
                 [](const Anatomy& anatomy) { return anatomy.landmark_m(Landmark::kACJ); },
                 kOverTheJoint_mm},
        OverBone{"skin_acromion", Segment::kScapula, AcromionTip_m, kSubcutaneous_mm},
        OverBone{"skin_mid_clavicle", Segment::kClavicle,
                 [](const Anatomy& anatomy) { return anatomy.landmark_m(Landmark::kPAC) / 2.0; },
                 kSubcutaneous_mm},
        OverBone{"skin_scapular_spine", Segment::kScapula,
                 [](const Anatomy& anatomy) {
                   return (anatomy.landmark_m(Landmark::kTS) + anatomy.landmark_m(Landmark::kAA)) /
                          2.0;
                 },
                 kSubcutaneous_mm}));

TEST_P(SkinLandmark, LiesOverItsBone) {
  for (const Side side : kBoth) {
    const Vector3 bone_m =
        Bone_m(Body(), side, GetParam().segment, GetParam().point_m(BuiltInAnatomy()));
    EXPECT_LT(1000 * glm::distance(Landmark_m(Body(), side, GetParam().name), bone_m),
              GetParam().within_mm);
  }
}

TEST(SkinLandmarks, OfTheDeltoidLookAwayFromTheBodyAtAThirdOfTheArm) {
  // Half of the largest distance between vertices of neighbouring cells, and the arm's slope.
  constexpr double kAlong = 0.06;
  // Statures from the least to the greatest that a body may have: the skin of a thick arm lies
  // farther out than that of an adult's.
  for (const double stature_m : {0.5, kAdultStature_m, 2.8}) {
    const PosedBody body =
        ImplicitBody(ScaledAnatomy(BuiltInAnatomy(), {.stature_m = stature_m}), kBoth);
    for (const Side side : kBoth) {
      const Vector3 shoulder_m = Bone_m(body, side, Segment::kHumerus, {0, 0, 0});
      const Vector3 arm_m =
          Bone_m(body, side, Segment::kHumerus, body.anatomy.elbow_m()) - shoulder_m;
      const Vector3 from_shoulder_m = Landmark_m(body, side, "skin_deltoid") - shoulder_m;
      const double along = glm::dot(from_shoulder_m, arm_m) / glm::dot(arm_m, arm_m);
      EXPECT_NEAR(along, 1.0 / 3, kAlong) << stature_m;
      const Vector3 outward = glm::normalize(from_shoulder_m - along * arm_m);
      const Vector3 away{0, 0, side == Side::kRight ? 1 : -1};
      // The farthest that a direction across the arm can look away.
      const double most = glm::length(glm::cross(away, glm::normalize(arm_m)));
      EXPECT_GT(glm::dot(outward, away), 0.98 * most) << stature_m;
    }
  }
}

TEST(SkinLandmarks, HaveThreeVerticesForTheAcromionAndOneElse) {
  const SkinLandmarkVertices vertices = FindSkinLandmarks(Body(), Side::kRight);
  for (std::size_t i = 0; i < kSkinLandmarkCount; ++i) {
    const bool is_acromion = kSkinLandmarkNames[i] == kSkinAcromionName;
    EXPECT_EQ(vertices[i].size(), is_acromion ? 3U : 1U) << kSkinLandmarkNames[i];
    EXPECT_EQ(std::set<int>(vertices[i].begin(), vertices[i].end()).size(), vertices[i].size());
  }
}

TEST(SkinLandmarks, OfTheAcromionAreTheNearestVerticesTheNearestFirst) {
  const std::vector<int> three =
      FindSkinLandmarks(Body(), Side::kLeft).at(IndexOf(kSkinAcromionName));
  const Vector3 tip_m =
      Bone_m(Body(), Side::kLeft, Segment::kScapula, AcromionTip_m(Body().anatomy));
  const auto distance_m = [&](int vertex) {
    return glm::distance(Body().surface.vertices_m.at(static_cast<std::size_t>(vertex)), tip_m);
  };
  EXPECT_LE(distance_m(three[0]), distance_m(three[1]));
  EXPECT_LE(distance_m(three[1]), distance_m(three[2]));
  int nearer = 0;
  for (int i = 0; i < static_cast<int>(Body().surface.vertices_m.size()); ++i) {
    nearer += distance_m(i) < distance_m(three[2]) ? 1 : 0;
  }
  EXPECT_EQ(nearer, 2);
}

// Of one half and its mirror image, vertices in another order: what is found does not depend on
// the grid.
TEST(SkinLandmarks, OfTheLeftAreThoseOfTheRightInTheMirror) {
  PosedBody mirrored = Body();
  for (Vector3& vertex_m : mirrored.surface.vertices_m) {
    vertex_m = Mirrored(vertex_m);
  }
  EXPECT_EQ(FindSkinLandmarks(mirrored, Side::kLeft), FindSkinLandmarks(Body(), Side::kRight));
  EXPECT_EQ(FindSkinLandmarks(mirrored, Side::kRight), FindSkinLandmarks(Body(), Side::kLeft));
}

TEST(SkinLandmarks, OfASurfaceWithTooFewVerticesAreRefused) {
  PosedBody body = Body();
  body.surface.vertices_m.resize(3);
  EXPECT_NO_THROW(static_cast<void>(FindSkinLandmarks(body, Side::kRight)));
  body.surface.vertices_m.resize(2);
  try {
    static_cast<void>(FindSkinLandmarks(body, Side::kRight));
    FAIL() << "were found";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "a surface of 2 vertices has no landmarks");
  }
}

}  // namespace
}  // namespace girdle::skin_landmarks_test
