// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Shares of bones out of those of others.
#pragma once

#include <vector>

#include "anatomy/triangle_mesh.h"
#include "skin/bone_heat.h"
#include "skin/posed_body.h"

namespace girdle {

/// Returns (1 - t) a + t b, for the same bones and vertices.
[[nodiscard]] SkinWeights Mixed(const SkinWeights& a, const SkinWeights& b, double t);

/// Returns shares that have moved `steps` times half the way to the mean of the vertices around
/// each: what is left of creases between bones goes.
[[nodiscard]] SkinWeights Smoothed(const TriangleMesh& surface, SkinWeights weights, int steps);

/// Returns the shares of `to` where those of `from` are known: bones that are not in `to` give
/// theirs to the thorax, which has to be the first of both.
[[nodiscard]] SkinWeights SharesOf(const std::vector<SkinBone>& to,
                                   const std::vector<SkinBone>& from, const SkinWeights& weights);

}  // namespace girdle
