// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/bound_skin.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/gtc/quaternion.hpp>
#include <stdexcept>

#include "anatomy/posed_bones.h"

namespace girdle {
namespace {

double RoundedTo(int decimals, double value) {
  const double steps = std::pow(10.0, decimals);
  return std::round(value * steps) / steps;
}

// Motion of a bone, and of the skin bound to it: v -> turn v + shift.
struct Motion {
  Matrix3 turn;
  Vector3 shift;
};

Motion MotionOf(const BoneFrame& bind, const BoneFrame& now) {
  const Matrix3 turn = glm::mat3_cast(now.q_TB * glm::conjugate(bind.q_TB));
  return {turn, now.p_TB_m - turn * bind.p_TB_m};
}

}  // namespace

BoundSkin Bind(const PosedBody& body, const std::vector<SkinBone>& bones,
               const SkinWeights& weights) {
  BoundSkin skin{body.surface, {}};
  for (Vector3& vertex : skin.surface.vertices_m) {
    for (int i = 0; i < 3; ++i) {
      vertex[i] = RoundedTo(kSkinDecimals, vertex[i]);
    }
  }
  for (const SkinBone& bone : bones) {
    skin.bones.push_back({bone.name(), FrameInThorax(body.anatomy, body.pose, bone), {}});
  }
  std::vector<std::ptrdiff_t> strongest;  // vertex of each bone
  for (const std::vector<double>& shares : weights) {
    strongest.push_back(std::max_element(shares.begin(), shares.end()) - shares.begin());
  }
  const double smallest = std::pow(10.0, -kWeightDecimals);
  for (std::size_t i = 0; i < skin.surface.vertices_m.size(); ++i) {
    // The largest share takes the difference that rounding leaves.
    std::size_t largest = 0;
    double others = 0;
    std::vector<double> rounded(bones.size());
    for (std::size_t k = 0; k < bones.size(); ++k) {
      const bool is_strongest = strongest[k] == static_cast<std::ptrdiff_t>(i);
      rounded[k] =
          std::max(RoundedTo(kWeightDecimals, weights[k][i]), is_strongest ? smallest : 0.0);
      others += rounded[k];
      if (weights[k][i] > weights[largest][i]) {
        largest = k;
      }
    }
    others -= rounded[largest];
    rounded[largest] = RoundedTo(kWeightDecimals, 1 - others);
    for (std::size_t k = 0; k < bones.size(); ++k) {
      if (rounded[k] > 0) {
        skin.bones[k].weights.push_back({static_cast<int>(i), rounded[k]});
      }
    }
  }
  return skin;
}

std::optional<BoneFrame> BindOf(const BoundSkin& skin, const SkinBone& bone) {
  const std::string name = bone.name();
  const auto found = std::find_if(skin.bones.begin(), skin.bones.end(),
                                  [&name](const BoundBone& bound) { return bound.body == name; });
  return found == skin.bones.end() ? std::nullopt : std::optional(found->bind);
}

std::optional<ShoulderPose> BindPose(const BoundSkin& skin, Side side) {
  std::array<Quaternion, kSegmentCount> q_AB{};
  for (std::size_t i = 0; i < kSegmentCount; ++i) {
    const std::optional<BoneFrame> bind = BindOf(skin, {static_cast<Segment>(i), side});
    if (!bind) {
      return std::nullopt;
    }
    q_AB[i] = bind->q_TB;
  }
  return PoseOfBones(side, q_AB);
}

std::vector<Vector3> BlendedVertices_m(const BoundSkin& skin,
                                       const std::vector<BoneFrame>& frames) {
  if (frames.size() != skin.bones.size()) {
    throw std::invalid_argument("a skin of " + std::to_string(skin.bones.size()) +
                                " bones needs as many frames, not " +
                                std::to_string(frames.size()));
  }
  std::vector<Vector3> blended_m(skin.surface.vertices_m.size(), Vector3{0, 0, 0});
  for (std::size_t k = 0; k < skin.bones.size(); ++k) {
    const Motion motion = MotionOf(skin.bones[k].bind, frames[k]);
    for (const VertexWeight& share : skin.bones[k].weights) {
      const auto i = static_cast<std::size_t>(share.vertex);
      blended_m[i] += share.weight * (motion.turn * skin.surface.vertices_m[i] + motion.shift);
    }
  }
  return blended_m;
}

}  // namespace girdle
