// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Surfaces that tests cut, bind and measure.
#pragma once

#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "skin/surface_nets.h"
#include "tables/triangle_mesh.h"

namespace girdle {

/// A ball about the origin.
inline TriangleMesh Ball(double radius_m, double cell_m) {
  const double reach_m = radius_m + 3 * cell_m;
  return SurfaceNets([radius_m](const Vector3& p) { return glm::length(p) - radius_m; },
                     {{-reach_m, -reach_m, -reach_m}, {reach_m, reach_m, reach_m}}, cell_m);
}

inline const Vector3& CornerOf(const TriangleMesh& mesh, const Triangle& triangle,
                               std::size_t corner) {
  return mesh.vertices_m[static_cast<std::size_t>(triangle[corner])];
}

/// The volume that a closed surface encloses, positive if its triangles look outside.
inline double Volume_m3(const TriangleMesh& mesh) {
  double six_volumes = 0;
  for (const Triangle& triangle : mesh.triangles) {
    six_volumes += glm::dot(CornerOf(mesh, triangle, 0),
                            glm::cross(CornerOf(mesh, triangle, 1), CornerOf(mesh, triangle, 2)));
  }
  return six_volumes / 6;
}

/// Whether every edge has one triangle on either side.
inline bool IsClosed(const TriangleMesh& mesh) {
  std::map<std::pair<int, int>, int> edges;
  for (const Triangle& triangle : mesh.triangles) {
    for (std::size_t corner = 0; corner < triangle.size(); ++corner) {
      ++edges[{triangle[corner], triangle[(corner + 1) % 3]}];
    }
  }
  for (const auto& [edge, count] : edges) {
    if (count != 1 || edges.count({edge.second, edge.first}) == 0) return false;
  }
  return !edges.empty();
}

}  // namespace girdle
