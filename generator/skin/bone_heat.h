// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Finds the bones that skin moves with: heat spreads over the skin from the bones below it.
#pragma once

#include <vector>

#include "anatomy/triangle_mesh.h"
#include "skin/bone_shapes.h"

namespace girdle {

/// Shares of the bones in every vertex: `weights[bone][vertex]`. They are not negative, and their
/// sum over the bones is 1.
using SkinWeights = std::vector<std::vector<double>>;

/// How strongly bones hold their own skin against spreading. At 1 the border of a bone is visible
/// as a crease. At 0.05 the arm bends in the middle of its shaft.
inline constexpr double kHeatStrength = 0.3;

/// Returns the equilibrium of heat (Baran and Popovic 2007, eq. 1, without their test of
/// visibility). The share w_k of bone k solves
///
///     (L + A H) w_k = A H p_k,     H = c / max(d, d_0)^2
///
///     L    cotangent Laplacian [1], its off-diagonal entries not positive
///     A    areas of the vertices [m^2]
///     d    distance of a vertex from the nearest bone [m], d_0 = 4 mm
///     p_k  1 if that bone is k, otherwise 0; shared if several bones are equally near
///     c    the strength
///
/// The surface may be open. Throws std::invalid_argument if there is no bone, if a vertex belongs
/// to no triangle, or if all its triangles have no area.
[[nodiscard]] SkinWeights BoneHeat(const TriangleMesh& surface, const std::vector<BoneShape>& bones,
                                   double strength = kHeatStrength);

}  // namespace girdle
