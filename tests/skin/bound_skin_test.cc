// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/bound_skin.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "anatomy/built_in_anatomy.h"
#include "kinematics/random_rotations.h"
#include "rhythm_tables/built_in_tables.h"

namespace girdle::bound_skin_test {
namespace {

constexpr double kRounding_m = 1e-12;
// Half of the last place that is kept, in each direction.
constexpr double kRoundedPlace_m = 0.5e-5;
constexpr double kRoundedWeight = 0.5e-4;

const std::vector<SkinBone> kBones = SkinBonesOf({Side::kRight});

// Four vertices around a shoulder; what hangs on what is up to the weights.
PosedBody Body() {
  return {{{{0.1, 0.02, 0.11}, {-0.123456, 0.2, 0.05}, {0, -0.3, 0.31}, {0.05, 0, 0.3}},
           {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}},
          BuiltInAnatomy(),
          BuiltInRhythm().Solve({RadiansFromDegrees(45), 0}).pose};
}

// Thorax, clavicle, scapula, humerus.
SkinWeights Weights() {
  return {{1, 0.25, 0, 0}, {0, 0.25, 0, 0.5}, {0, 0.25, 0.5, 0}, {0, 0.25, 0.5, 0.5}};
}

BoundSkin Skin() { return Bind(Body(), kBones, Weights()); }

std::vector<BoneFrame> BindFrames(const BoundSkin& skin) {
  std::vector<BoneFrame> frames;
  frames.reserve(skin.bones.size());
  for (const BoundBone& bone : skin.bones) {
    frames.push_back(bone.bind);
  }
  return frames;
}

rc::Gen<std::vector<BoneFrame>> AnyFrames() {
  const rc::Gen<BoneFrame> frame =
      rc::gen::map(rc::gen::pair(UnitQuaternion(), VectorWithin(-0.5, 0.5)),
                   [](const std::pair<Quaternion, Vector3>& turn_and_place) {
                     return BoneFrame{turn_and_place.first, turn_and_place.second};
                   });
  return rc::gen::container<std::vector<BoneFrame>>(kBones.size(), frame);
}

TEST(BoundSkin, HasTheBonesWhereTheyStand) {
  const PosedBody body = Body();
  const BoundSkin skin = Skin();
  ASSERT_EQ(skin.bones.size(), kBones.size());
  for (std::size_t k = 0; k < kBones.size(); ++k) {
    const BoneFrame expected = FrameInThorax(body.anatomy, body.pose, kBones[k]);
    EXPECT_EQ(skin.bones[k].body, kBones[k].name());
    EXPECT_EQ(skin.bones[k].bind.p_TB_m, expected.p_TB_m);
    EXPECT_EQ(skin.bones[k].bind.q_TB, expected.q_TB);
  }
}

TEST(BoundSkin, KeepsTheSurfaceToItsDecimals) {
  const PosedBody body = Body();
  const BoundSkin skin = Skin();
  EXPECT_EQ(skin.surface.triangles, body.surface.triangles);
  for (std::size_t i = 0; i < body.surface.vertices_m.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const double place_m = skin.surface.vertices_m[i][axis];
      EXPECT_NEAR(place_m, body.surface.vertices_m[i][axis], kRoundedPlace_m + kRounding_m);
      EXPECT_NEAR(place_m, std::round(place_m * 1e5) / 1e5, kRounding_m);
    }
  }
  EXPECT_NEAR(skin.surface.vertices_m[1].x, -0.12346, kRounding_m);
}

TEST(BoundSkin, ListsOnlyBonesWithAShare) {
  const BoundSkin skin = Skin();
  const std::vector<std::vector<int>> expected = {{0, 1}, {1, 3}, {1, 2}, {1, 2, 3}};
  for (std::size_t k = 0; k < expected.size(); ++k) {
    std::vector<int> vertices;
    for (const VertexWeight& share : skin.bones[k].weights) {
      vertices.push_back(share.vertex);
    }
    EXPECT_EQ(vertices, expected[k]) << skin.bones[k].body;
  }
}

RC_GTEST_PROP(BoundSkin, HasRoundedWeightsOfOneInSum, ()) {
  const PosedBody body = Body();
  SkinWeights weights(kBones.size(), std::vector<double>(body.surface.vertices_m.size()));
  for (std::size_t i = 0; i < body.surface.vertices_m.size(); ++i) {
    double sum = 0;
    for (std::vector<double>& of_bone : weights) {
      // Many of them so small that they are dropped.
      of_bone[i] = std::exp(*NumberWithin(-15, 0));
      sum += of_bone[i];
    }
    for (std::vector<double>& of_bone : weights) {
      of_bone[i] /= sum;
    }
  }
  const BoundSkin skin = Bind(body, kBones, weights);
  std::vector<double> sums(body.surface.vertices_m.size());
  for (std::size_t k = 0; k < kBones.size(); ++k) {
    const auto strongest = std::max_element(weights[k].begin(), weights[k].end());
    for (const VertexWeight& share : skin.bones[k].weights) {
      const auto i = static_cast<std::size_t>(share.vertex);
      sums[i] += share.weight;
      RC_ASSERT(share.weight >= 2 * kRoundedWeight - kRounding_m);
      RC_ASSERT(std::abs(share.weight * 1e4 - std::round(share.weight * 1e4)) < 1e-9);
      const bool is_largest = std::all_of(
          weights.begin(), weights.end(),
          [&](const std::vector<double>& of_bone) { return of_bone[i] <= weights[k][i]; });
      // The largest share takes what the others leave, which the sum shows. A bone keeps one share
      // however small it is.
      if (!is_largest) {
        const bool is_strongest = weights[k].begin() + share.vertex == strongest;
        const double wanted = std::max(weights[k][i], is_strongest ? 2 * kRoundedWeight : 0);
        RC_ASSERT(std::abs(share.weight - wanted) <= kRoundedWeight + kRounding_m);
      }
    }
  }
  for (const double sum : sums) {
    RC_ASSERT(std::abs(sum - 1) < kRounding_m);
  }
}

TEST(BlendedVertices, AreTheSurfaceInTheFramesOfTheBind) {
  const BoundSkin skin = Skin();
  const std::vector<Vector3> blended_m = BlendedVertices_m(skin, BindFrames(skin));
  ASSERT_EQ(blended_m.size(), skin.surface.vertices_m.size());
  for (std::size_t i = 0; i < blended_m.size(); ++i) {
    EXPECT_LT(glm::distance(blended_m[i], skin.surface.vertices_m[i]), kRounding_m);
  }
}

RC_GTEST_PROP(BlendedVertices, MoveRigidlyWithAllBones, ()) {
  const Quaternion q = *UnitQuaternion();
  const Vector3 by_m = *VectorWithin(-1, 1);
  const BoundSkin skin = Skin();
  std::vector<BoneFrame> frames = BindFrames(skin);
  for (BoneFrame& frame : frames) {
    frame = {q * frame.q_TB, by_m + q * frame.p_TB_m};
  }
  const std::vector<Vector3> blended_m = BlendedVertices_m(skin, frames);
  for (std::size_t i = 0; i < blended_m.size(); ++i) {
    RC_ASSERT(glm::distance(blended_m[i], by_m + q * skin.surface.vertices_m[i]) < kRounding_m);
  }
}

RC_GTEST_PROP(BlendedVertices, AreTheWeightedMeanOfWhereTheirBonesTakeThem, ()) {
  const BoundSkin skin = Skin();
  const std::vector<BoneFrame> frames = *AnyFrames();
  const auto taken_by = [&](std::size_t bone, std::size_t vertex) {
    const BoneFrame& bind = skin.bones[bone].bind;
    const Vector3 in_bone_m =
        glm::conjugate(bind.q_TB) * (skin.surface.vertices_m[vertex] - bind.p_TB_m);
    return frames[bone].p_TB_m + frames[bone].q_TB * in_bone_m;
  };
  const std::vector<Vector3> blended_m = BlendedVertices_m(skin, frames);
  RC_ASSERT(glm::distance(blended_m[0], taken_by(0, 0)) < kRounding_m);
  RC_ASSERT(glm::distance(blended_m[1],
                          (taken_by(0, 1) + taken_by(1, 1) + taken_by(2, 1) + taken_by(3, 1)) /
                              4.0) < kRounding_m);
  RC_ASSERT(glm::distance(blended_m[2], (taken_by(2, 2) + taken_by(3, 2)) / 2.0) < kRounding_m);
  RC_ASSERT(glm::distance(blended_m[3], (taken_by(1, 3) + taken_by(3, 3)) / 2.0) < kRounding_m);
}

TEST(BlendedVertices, NeedAFrameOfEachBone) {
  const BoundSkin skin = Skin();
  std::vector<BoneFrame> frames = BindFrames(skin);
  frames.pop_back();
  constexpr const char* kMessage = "a skin of 4 bones needs as many frames, not 3";
  try {
    static_cast<void>(BlendedVertices_m(skin, frames));
    FAIL() << "were taken";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), kMessage);
  }
  frames.resize(5);
  EXPECT_THROW(static_cast<void>(BlendedVertices_m(skin, frames)), std::invalid_argument);
}

}  // namespace
}  // namespace girdle::bound_skin_test
