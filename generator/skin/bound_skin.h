// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Skin that moves with bones, by linear blend skinning.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skin/bone_heat.h"
#include "skin/posed_body.h"

namespace girdle {

/// The share of a bone in a vertex.
struct VertexWeight {
  int vertex = 0;
  double weight = 0;
};

/// A bone, its frame at the time when the skin was bound to it, and the vertices that move with it.
struct BoundBone {
  std::string body;  ///< name in a model
  BoneFrame bind;
  std::vector<VertexWeight> weights;
};

/// A surface that is bound to bones. Its frame and unit (metres) are those of the bones' `bind`.
struct BoundSkin {
  TriangleMesh surface;
  std::vector<BoundBone> bones;
};

/// Returns the body's surface, bound to `bones` in their present positions. The smallest shares of
/// a vertex are dropped, except one for each bone, because MuJoCo requires that every bone moves
/// something. The other shares are rounded to kWeightDecimals, and positions to kSkinDecimals of a
/// metre. So the same body gives the same skin on every machine.
[[nodiscard]] BoundSkin Bind(const PosedBody& body, const std::vector<SkinBone>& bones,
                             const SkinWeights& weights);
inline constexpr int kSkinDecimals = 5;
inline constexpr int kWeightDecimals = 4;

/// Returns the frame of a bone at the time when the skin was bound to it. Returns nothing if the
/// skin is not bound to a bone of that name.
[[nodiscard]] std::optional<BoneFrame> BindOf(const BoundSkin& skin, const SkinBone& bone);

/// Returns the pose in which a skin is bound to the four bones of one side's shoulder, as that of a
/// right shoulder. Returns nothing if the skin is not bound to all of them.
[[nodiscard]] std::optional<ShoulderPose> BindPose(const BoundSkin& skin, Side side);

/// Returns the vertices [m] for other frames of the bones, one frame for each of skin.bones:
///
///     v' = sum_k w_k (R_k R_bind,k^T (v - p_bind,k) + p_k)
[[nodiscard]] std::vector<Vector3> BlendedVertices_m(const BoundSkin& skin,
                                                     const std::vector<BoneFrame>& frames);

}  // namespace girdle
