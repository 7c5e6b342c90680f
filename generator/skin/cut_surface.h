// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Cuts a surface along a plane, together with the bones' shares in its vertices.
#pragma once

#include <vector>

#include "anatomy/triangle_mesh.h"
#include "skin/bone_heat.h"
#include "skin/smooth_union.h"

namespace girdle {

/// A surface and the bones' shares in its vertices.
struct WeightedSurface {
  TriangleMesh mesh;
  SkinWeights weights;
};

/// Vertices nearer to a cut than this [m] are moved onto it, so that the cut leaves no slivers.
inline constexpr double kNearCut_m = 0.002;

/// Returns the part of a surface in a half space, and all vertices that `spared` marks. Lids close
/// the holes that the cut leaves, so a closed surface stays closed. Where the cut crosses an edge,
/// there is a new vertex, whose shares are interpolated along the edge. A lid has further new
/// vertices inside its rim. Vertices keep their order, and new ones come last. Precondition: all of
/// a lid's rim is visible from its middle.
[[nodiscard]] WeightedSurface Cut(const WeightedSurface& surface, const HalfSpace& kept,
                                  const std::vector<bool>& spared);

}  // namespace girdle
