// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/cut_surface.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <utility>

namespace girdle {
namespace {

using Edge = std::pair<int, int>;

// A surface that is cut. Vertices are only added, until the unused ones are removed at the end.
class Cutter {
 public:
  Cutter(WeightedSurface surface, const HalfSpace& kept, const std::vector<bool>& spared)
      : surface_(std::move(surface)), height_m_(surface_.mesh.vertices_m.size(), 1) {
    for (std::size_t i = 0; i < height_m_.size(); ++i) {
      if (spared[i]) continue;
      Vector3& vertex = surface_.mesh.vertices_m[i];
      height_m_[i] = -glm::dot(vertex - kept.point_m, kept.outward);
      if (std::abs(height_m_[i]) < kNearCut_m) {
        vertex += height_m_[i] * kept.outward;
        height_m_[i] = 0;
      }
    }
  }

  WeightedSurface Result() {
    ClipTriangles();
    CloseLids();
    return WithoutUnused();
  }

 private:
  [[nodiscard]] double Height_m(int vertex) const {
    return height_m_[static_cast<std::size_t>(vertex)];
  }

  // Appends a vertex that is the mean of others, weighted with shares whose sum is 1.
  int Append(const std::vector<std::pair<int, double>>& shares) {
    const auto blend = [&shares](const auto& values) {
      auto sum = shares[0].second * values[static_cast<std::size_t>(shares[0].first)];
      for (std::size_t i = 1; i < shares.size(); ++i) {
        sum += shares[i].second * values[static_cast<std::size_t>(shares[i].first)];
      }
      return sum;
    };
    surface_.mesh.vertices_m.push_back(blend(surface_.mesh.vertices_m));
    for (std::vector<double>& weights : surface_.weights) weights.push_back(blend(weights));
    height_m_.push_back(0);
    return static_cast<int>(height_m_.size()) - 1;
  }

  // Returns the vertex where the plane crosses an edge. Both triangles at the edge get one vertex.
  int Crossing(int a, int b) {
    const Edge edge = std::minmax(a, b);
    const auto known = crossings_.find(edge);
    if (known != crossings_.end()) return known->second;
    const double first_m = std::abs(Height_m(edge.first));
    const double second_m = std::abs(Height_m(edge.second));
    const double share = first_m / (first_m + second_m);
    return crossings_[edge] = Append({{edge.first, 1 - share}, {edge.second, share}});
  }

  void ClipTriangles() {
    std::vector<Triangle> kept;
    for (const Triangle& triangle : surface_.mesh.triangles) {
      std::vector<int> corners;
      for (std::size_t i = 0; i < triangle.size(); ++i) {
        const int a = triangle[i];
        const int b = triangle[(i + 1) % triangle.size()];
        if (Height_m(a) >= 0) corners.push_back(a);
        if (Height_m(a) * Height_m(b) < 0) corners.push_back(Crossing(a, b));
      }
      for (std::size_t i = 2; i < corners.size(); ++i) {
        kept.push_back({corners[0], corners[i - 1], corners[i]});
      }
    }
    surface_.mesh.triangles = std::move(kept);
  }

  // Closes every hole whose rim lies in the plane with a lid.
  void CloseLids() {
    std::set<Edge> edges;
    for (const Triangle& triangle : surface_.mesh.triangles) {
      for (std::size_t i = 0; i < triangle.size(); ++i) {
        edges.emplace(triangle[i], triangle[(i + 1) % triangle.size()]);
      }
    }
    // Goes once around a hole, with the hole on the left.
    std::map<int, int> next;
    for (const auto& [a, b] : edges) {
      if (edges.count({b, a}) == 0 && Height_m(a) == 0 && Height_m(b) == 0) next[b] = a;
    }
    while (!next.empty()) {
      std::vector<int> rim;
      for (auto at = next.begin(); at != next.end(); at = next.find(rim.back())) {
        rim.push_back(at->second);
        next.erase(at);
      }
      CloseLid(rim);
    }
  }

  // A narrow ring inside the rim keeps the lid from changing the normals of the skin around it.
  void CloseLid(const std::vector<int>& rim) {
    constexpr double kRingShare = 0.03;
    std::vector<std::pair<int, double>> shares;
    shares.reserve(rim.size());
    for (const int vertex : rim) {
      shares.emplace_back(vertex, 1.0 / static_cast<double>(rim.size()));
    }
    const int middle = Append(shares);
    std::vector<int> ring;
    ring.reserve(rim.size());
    for (const int vertex : rim) {
      ring.push_back(Append({{vertex, 1 - kRingShare}, {middle, kRingShare}}));
    }
    for (std::size_t i = 0; i < rim.size(); ++i) {
      const std::size_t j = (i + 1) % rim.size();
      surface_.mesh.triangles.push_back({rim[i], rim[j], ring[j]});
      surface_.mesh.triangles.push_back({rim[i], ring[j], ring[i]});
      surface_.mesh.triangles.push_back({ring[i], ring[j], middle});
    }
  }

  WeightedSurface WithoutUnused() {
    std::vector<int> new_number(height_m_.size(), -1);
    for (const Triangle& triangle : surface_.mesh.triangles) {
      for (const int corner : triangle) new_number[static_cast<std::size_t>(corner)] = 0;
    }
    WeightedSurface used{{}, SkinWeights(surface_.weights.size())};
    int count = 0;
    for (std::size_t i = 0; i < new_number.size(); ++i) {
      if (new_number[i] < 0) continue;
      new_number[i] = count++;
      used.mesh.vertices_m.push_back(surface_.mesh.vertices_m[i]);
      for (std::size_t k = 0; k < surface_.weights.size(); ++k) {
        used.weights[k].push_back(surface_.weights[k][i]);
      }
    }
    for (Triangle triangle : surface_.mesh.triangles) {
      for (int& corner : triangle) corner = new_number[static_cast<std::size_t>(corner)];
      used.mesh.triangles.push_back(triangle);
    }
    return used;
  }

  WeightedSurface surface_;
  std::vector<double> height_m_;  // of vertices above the plane; spared vertices count as above
  std::map<Edge, int> crossings_;
};

}  // namespace

WeightedSurface Cut(const WeightedSurface& surface, const HalfSpace& kept,
                    const std::vector<bool>& spared) {
  return Cutter(surface, kept, spared).Result();
}

}  // namespace girdle
