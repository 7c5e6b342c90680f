// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/weight_blend.h"

#include <algorithm>
#include <set>

namespace girdle {
namespace {

// Returns the vertices that share an edge with each vertex, by number.
std::vector<std::vector<int>> NeighboursIn(const TriangleMesh& surface) {
  std::vector<std::set<int>> around(surface.vertices_m.size());
  for (const Triangle& triangle : surface.triangles) {
    for (const int a : triangle) {
      for (const int b : triangle) {
        if (a != b) around[static_cast<std::size_t>(a)].insert(b);
      }
    }
  }
  std::vector<std::vector<int>> neighbours;
  neighbours.reserve(around.size());
  for (const std::set<int>& vertices : around) {
    neighbours.emplace_back(vertices.begin(), vertices.end());
  }
  return neighbours;
}

}  // namespace

SkinWeights Mixed(const SkinWeights& a, const SkinWeights& b, double t) {
  SkinWeights mixed = a;
  for (std::size_t k = 0; k < mixed.size(); ++k) {
    for (std::size_t i = 0; i < mixed[k].size(); ++i) {
      mixed[k][i] = (1 - t) * a[k][i] + t * b[k][i];
    }
  }
  return mixed;
}

SkinWeights Smoothed(const TriangleMesh& surface, SkinWeights weights, int steps) {
  const std::vector<std::vector<int>> neighbours = NeighboursIn(surface);
  for (std::vector<double>& shares : weights) {
    for (int step = 0; step < steps; ++step) {
      const std::vector<double> before = shares;
      for (std::size_t i = 0; i < shares.size(); ++i) {
        if (neighbours[i].empty()) continue;
        double sum = 0;
        for (const int j : neighbours[i]) sum += before[static_cast<std::size_t>(j)];
        shares[i] = (before[i] + sum / static_cast<double>(neighbours[i].size())) / 2;
      }
    }
  }
  return weights;
}

SkinWeights SharesOf(const std::vector<SkinBone>& to, const std::vector<SkinBone>& from,
                     const SkinWeights& weights) {
  SkinWeights shares(to.size(), std::vector<double>(weights[0].size()));
  for (std::size_t k = 0; k < from.size(); ++k) {
    const auto same = std::find_if(to.begin(), to.end(), [&](const SkinBone& bone) {
      return bone.segment == from[k].segment &&
             (bone.side == from[k].side || bone.segment == Segment::kThorax);
    });
    std::vector<double>& sum =
        shares[same == to.end() ? 0 : static_cast<std::size_t>(same - to.begin())];
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weights[k][i];
  }
  return shares;
}

}  // namespace girdle
