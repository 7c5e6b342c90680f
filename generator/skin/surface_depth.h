// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Depths of points under a surface.
#pragma once

#include <vector>

#include "anatomy/triangle_mesh.h"

namespace girdle {

/// Answers how deep points are under a surface. Points are in the frame of its vertices.
///
/// A point is inside if the winding number of the surface about it is more than a half (the
/// generalized winding number of Jacobson, Kavan and Sorkine-Hornung 2013). So closed surfaces may
/// intersect themselves, as skin does in an armpit. Open surfaces have an inside too, except near
/// their holes.
class SurfaceDepth {
 public:
  /// Stores the surface unchanged. Throws std::invalid_argument if it has no triangles or if a
  /// triangle has a vertex that does not exist.
  explicit SurfaceDepth(TriangleMesh surface);

  /// Returns the distance [m] of a point from the surface, positive inside. It is NaN if the point
  /// or a corner of a triangle is not finite. The time grows with the number of triangles: about 1
  /// ms for 15,000.
  [[nodiscard]] double Depth_m(const Vector3& point_m) const noexcept;

  /// Returns the winding number of the surface about a point. It is 1 inside a closed surface, 0
  /// outside, and between both under an open one.
  [[nodiscard]] double WindingNumber(const Vector3& point_m) const noexcept;

  /// Returns the distance [m] of a point from the nearest point of a triangle. It is not negative.
  [[nodiscard]] double Distance_m(const Vector3& point_m) const noexcept;

 private:
  // A ball around a triangle. It shows quickly that another triangle is nearer.
  struct Ball {
    Vector3 center_m{0, 0, 0};
    double radius_m = 0;
  };

  [[nodiscard]] const Vector3& At(const Triangle& triangle, std::size_t corner) const noexcept {
    return surface_.vertices_m[static_cast<std::size_t>(triangle[corner])];
  }

  TriangleMesh surface_;
  std::vector<Ball> balls_;  ///< one for each triangle
  bool is_finite_ = true;    ///< every corner of every triangle is finite
};

}  // namespace girdle
