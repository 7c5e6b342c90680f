// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Simple solids in the place of bones, for telling which bone a piece of skin lies over.
#pragma once

#include <vector>

#include "skin/posed_body.h"

namespace girdle {

/// A straight rod with round ends, thorax frame.
struct Rod {
  Vector3 from_m{0, 0, 0};
  Vector3 to_m{0, 0, 0};
  double radius_m = 0;
};

struct BoneShape {
  std::vector<Rod> rods;
  std::vector<Ellipsoid> ellipsoids;  ///< thorax frame
};

/// Returns the shapes of bones, in their order. Thorax: a rib cage, the neck, the spine and the
/// sternum; clavicle: SC to AC; scapula: its
/// spine, acromion, medial border, neck and coracoid process; humerus: the
/// head and the shaft to the elbow. A side without a shoulder of its own in `bones` belongs to the
/// thorax, with all its bones as they stand.
[[nodiscard]] std::vector<BoneShape> BoneShapesOf(const PosedBody& body,
                                                  const std::vector<SkinBone>& bones);

/// Returns the distance [m] of a point from the nearest of a shape's solids; 0 inside.
[[nodiscard]] double DistanceFrom_m(const BoneShape& shape, const Vector3& point_m) noexcept;

}  // namespace girdle
