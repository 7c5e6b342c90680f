// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Which bones skin moves with: heat that spreads over the skin from the bones under it.
#pragma once

#include <vector>

#include "anatomy/triangle_mesh.h"
#include "skin/bone_shapes.h"

namespace girdle {

/// Shares of the bones in every vertex: `weights[bone][vertex]`, not negative, 1 in sum over the
/// bones.
using SkinWeights = std::vector<std::vector<double>>;

/// How strongly bones hold their own skin against its spreading. At 1 the border of a bone shows as
/// a crease, at 0.05 the arm bends in mid-shaft.
inline constexpr double kHeatStrength = 0.3;

/// Returns the equilibrium of heat (Baran and Popovic 2007, eq. 1, without their test of
/// visibility): w_k of bone k solves
///
///     (L + A H) w_k = A H p_k,     H = c / max(d, d_0)^2
///
/// L the cotangent Laplacian [1], its entries off the diagonal not positive; A the vertices' areas
/// [m^2]; d a vertex's distance [m] from the nearest bone, d_0 = 4 mm; p_k 1 where that bone is k,
/// shared where several are as near; c the strength. The surface may be open. Throws
/// std::invalid_argument if there is no bone, or if a vertex belongs to no triangle or to none with
/// an area.
[[nodiscard]] SkinWeights BoneHeat(const TriangleMesh& surface, const std::vector<BoneShape>& bones,
                                   double strength = kHeatStrength);

}  // namespace girdle
