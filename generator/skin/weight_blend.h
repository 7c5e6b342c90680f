// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Computes bones' shares from other shares.
#pragma once

#include <vector>

#include "anatomy/triangle_mesh.h"
#include "skin/bone_heat.h"
#include "skin/posed_body.h"

namespace girdle {

/// Returns (1 - t) a + t b. Precondition: both have the same bones and vertices.
[[nodiscard]] SkinWeights Mixed(const SkinWeights& a, const SkinWeights& b, double t);

/// Returns smoothed shares: `steps` times, the shares of each vertex move half the way to the mean
/// of its neighbours' shares. This removes the rest of creases between bones.
[[nodiscard]] SkinWeights Smoothed(const TriangleMesh& surface, SkinWeights weights, int steps);

/// Returns the shares of the bones `to` from known shares of the bones `from`. Bones that are not
/// in `to` give their shares to the thorax. Precondition: the thorax is the first of both lists.
[[nodiscard]] SkinWeights SharesOf(const std::vector<SkinBone>& to,
                                   const std::vector<SkinBone>& from, const SkinWeights& weights);

}  // namespace girdle
