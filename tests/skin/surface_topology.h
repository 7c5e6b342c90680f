// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// What tests ask of a surface of triangles: whether it is closed, of which kind it is, how large.
#pragma once

#include <cstddef>
#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "anatomy/triangle_mesh.h"

namespace girdle {

/// From one vertex to another.
using Edge = std::pair<int, int>;

inline const Vector3& Corner_m(const TriangleMesh& mesh, const Triangle& triangle,
                               std::size_t corner) {
  return mesh.vertices_m.at(static_cast<std::size_t>(triangle.at(corner)));
}

/// How often triangles run along each edge, in the direction in which they do.
inline std::map<Edge, int> EdgeCounts(const TriangleMesh& mesh) {
  std::map<Edge, int> counts;
  for (const Triangle& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      ++counts[{triangle[i], triangle[(i + 1) % 3]}];
    }
  }
  return counts;
}

/// The edges that are not run along once in each direction: none on a closed surface that turns
/// the same side outward everywhere and nowhere touches itself along an edge.
inline std::vector<Edge> UnpairedEdges(const TriangleMesh& mesh) {
  const std::map<Edge, int> counts = EdgeCounts(mesh);
  std::vector<Edge> unpaired;
  for (const auto& [edge, count] : counts) {
    const auto reverse = counts.find({edge.second, edge.first});
    if (count != 1 || reverse == counts.end() || reverse->second != 1) {
      unpaired.push_back(edge);
    }
  }
  return unpaired;
}

inline bool IsClosed(const TriangleMesh& mesh) {
  return !mesh.triangles.empty() && UnpairedEdges(mesh).empty();
}

/// Vertices - edges + triangles of a closed surface: 2 for every ball, 0 for every torus in it.
/// Vertices of no triangle do not count.
inline int EulerCharacteristic(const TriangleMesh& mesh) {
  std::set<int> vertices;
  std::set<Edge> edges;
  for (const auto& [edge, count] : EdgeCounts(mesh)) {
    vertices.insert(edge.first);
    edges.insert(std::minmax(edge.first, edge.second));
  }
  return static_cast<int>(vertices.size()) - static_cast<int>(edges.size()) +
         static_cast<int>(mesh.triangles.size());
}

inline double Area_m2(const TriangleMesh& mesh, const Triangle& triangle) {
  const Vector3& a = Corner_m(mesh, triangle, 0);
  return glm::length(glm::cross(Corner_m(mesh, triangle, 1) - a, Corner_m(mesh, triangle, 2) - a)) /
         2;
}

inline double Area_m2(const TriangleMesh& mesh) {
  double area_m2 = 0;
  for (const Triangle& triangle : mesh.triangles) {
    area_m2 += Area_m2(mesh, triangle);
  }
  return area_m2;
}

/// Positive where triangles run counter-clockwise seen from outside.
inline double Volume_m3(const TriangleMesh& mesh) {
  double volume_m3 = 0;
  for (const Triangle& triangle : mesh.triangles) {
    volume_m3 += glm::dot(Corner_m(mesh, triangle, 0),
                          glm::cross(Corner_m(mesh, triangle, 1), Corner_m(mesh, triangle, 2))) /
                 6;
  }
  return volume_m3;
}

}  // namespace girdle
