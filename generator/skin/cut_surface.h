// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Cutting a surface with shares of bones along a plane.
#pragma once

#include <vector>

#include "anatomy/triangle_mesh.h"
#include "skin/bone_heat.h"
#include "skin/smooth_union.h"

namespace girdle {

/// A surface and the shares of bones in its vertices.
struct WeightedSurface {
  TriangleMesh mesh;
  SkinWeights weights;
};

/// Vertices that are nearer to a cut are moved onto it, so that it leaves no slivers [m].
inline constexpr double kNearCut_m = 0.002;

/// Returns what lies in a half space, and all of the vertices that `spared` names, with lids on the
/// holes that the cut leaves: a closed surface stays closed. Where the cut crosses an edge there is
/// a new vertex with the shares that are right for its place; a lid has more of them inside its
/// rim. Vertices keep their order, new ones come last. A lid has to be such that one can see all of
/// its rim from its middle.
[[nodiscard]] WeightedSurface Cut(const WeightedSurface& surface, const HalfSpace& kept,
                                  const std::vector<bool>& spared);

}  // namespace girdle
