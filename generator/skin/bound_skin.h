// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Skin that moves with bones: linear blend skinning.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skin/bone_heat.h"
#include "skin/posed_body.h"

namespace girdle {

/// Share of a bone in a vertex.
struct VertexWeight {
  int vertex = 0;
  double weight = 0;
};

/// A bone, where it was when the skin was bound to it, and the vertices that move with it.
struct BoundBone {
  std::string body;  ///< name in a model
  BoneFrame bind;
  std::vector<VertexWeight> weights;
};

/// A surface as it was bound; frame and metres as those of the bones' `bind`.
struct BoundSkin {
  TriangleMesh surface;
  std::vector<BoundBone> bones;
};

/// Returns the body's surface bound to `bones` where they stand. A vertex's smallest shares are
/// dropped, but for one of each bone, since MuJoCo wants every bone to move something; the others
/// are rounded, and places to kSkinDecimals of a metre, so that the same body gives the same skin
/// on every machine.
[[nodiscard]] BoundSkin Bind(const PosedBody& body, const std::vector<SkinBone>& bones,
                             const SkinWeights& weights);
inline constexpr int kSkinDecimals = 5;
inline constexpr int kWeightDecimals = 4;

/// Returns where a bone was when the skin was bound to it; nothing if it hangs on none of that
/// name.
[[nodiscard]] std::optional<BoneFrame> BindOf(const BoundSkin& skin, const SkinBone& bone);

/// Returns the pose in which a skin is bound to the four bones of one side's shoulder, as that of a
/// right one; nothing if it does not hang on all of them.
[[nodiscard]] std::optional<ShoulderPose> BindPose(const BoundSkin& skin, Side side);

/// Returns the vertices [m] with the bones in other frames, one for each of skin.bones:
///
///     v' = sum_k w_k (R_k R_bind,k^T (v - p_bind,k) + p_k)
[[nodiscard]] std::vector<Vector3> BlendedVertices_m(const BoundSkin& skin,
                                                     const std::vector<BoneFrame>& frames);

}  // namespace girdle
