// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Simple solids that replace bones, to find the bone below a piece of skin.
#pragma once

#include <vector>

#include "skin/posed_body.h"

namespace girdle {

/// A straight rod with round ends, in the thorax frame.
struct Rod {
  Vector3 from_m{0, 0, 0};
  Vector3 to_m{0, 0, 0};
  double radius_m = 0;
};

struct BoneShape {
  std::vector<Rod> rods;
  std::vector<Ellipsoid> ellipsoids;  ///< in the thorax frame
};

/// Returns the shapes of bones, in their order. Thorax: rib cage, neck, spine and sternum.
/// Clavicle: SC to AC. Scapula: spine, acromion, medial border, neck and coracoid process. Humerus:
/// the head, and the shaft to the elbow. If `bones` has no shoulder of a side, all bones of that
/// side belong to the thorax, in their present positions.
[[nodiscard]] std::vector<BoneShape> BoneShapesOf(const PosedBody& body,
                                                  const std::vector<SkinBone>& bones);

/// Returns the distance [m] of a point from the nearest solid of a shape; 0 inside.
[[nodiscard]] double DistanceFrom_m(const BoneShape& shape, const Vector3& point_m) noexcept;

}  // namespace girdle
