// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/bone_heat.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <glm/geometric.hpp>
#include <stdexcept>
#include <string>

namespace girdle {
namespace {

// Least distance in the formula: the heat of skin directly on a bone would be unbounded.
constexpr double kNearest_m = 0.004;
// Distances that differ by no more than this count as equal.
constexpr double kSameDistance_m = 1e-9;
// Limit of a cotangent, so that a very thin triangle does not outweigh all others.
constexpr double kLargestCotangent = 100;

double Cotangent(const Vector3& corner, const Vector3& a, const Vector3& b) {
  const Vector3 u = a - corner;
  const Vector3 v = b - corner;
  const double twice_area = glm::length(glm::cross(u, v));
  const double adjacent = glm::dot(u, v);
  return twice_area * kLargestCotangent > adjacent ? adjacent / twice_area : kLargestCotangent;
}

Eigen::Index Index(int i) { return static_cast<Eigen::Index>(i); }

}  // namespace

SkinWeights BoneHeat(const TriangleMesh& surface, const std::vector<BoneShape>& bones,
                     double strength) {
  if (bones.empty()) {
    throw std::invalid_argument("heat needs a bone to come from");
  }
  const auto& vertices = surface.vertices_m;
  const auto count = static_cast<Eigen::Index>(vertices.size());
  Eigen::VectorXd area_m2 = Eigen::VectorXd::Zero(count);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(surface.triangles.size() * 12 + vertices.size());
  for (const Triangle& triangle : surface.triangles) {
    const auto at = [&](std::size_t corner) {
      return vertices[static_cast<std::size_t>(triangle[corner % 3])];
    };
    const double third_m2 = glm::length(glm::cross(at(1) - at(0), at(2) - at(0))) / 6;
    if (!(third_m2 > 0)) {
      continue;
    }
    for (std::size_t corner = 0; corner < 3; ++corner) {
      area_m2[Index(triangle[corner])] += third_m2;
      // The edge opposite this corner. An obtuse angle would make its ends repel each other.
      const double half_cotangent =
          std::max(Cotangent(at(corner), at(corner + 1), at(corner + 2)) / 2, 0.0);
      const Eigen::Index i = Index(triangle[(corner + 1) % 3]);
      const Eigen::Index j = Index(triangle[(corner + 2) % 3]);
      entries.emplace_back(i, i, half_cotangent);
      entries.emplace_back(j, j, half_cotangent);
      entries.emplace_back(i, j, -half_cotangent);
      entries.emplace_back(j, i, -half_cotangent);
    }
  }

  Eigen::MatrixXd source = Eigen::MatrixXd::Zero(count, static_cast<Eigen::Index>(bones.size()));
  std::vector<double> distance_m(bones.size());
  for (Eigen::Index i = 0; i < count; ++i) {
    if (!(area_m2[i] > 0)) {
      throw std::invalid_argument("vertex " + std::to_string(i) +
                                  " of the surface belongs to no triangle with an area");
    }
    for (std::size_t k = 0; k < bones.size(); ++k) {
      distance_m[k] = DistanceFrom_m(bones[k], vertices[static_cast<std::size_t>(i)]);
    }
    const double nearest_m = *std::min_element(distance_m.begin(), distance_m.end());
    const double depth_m = std::max(nearest_m, kNearest_m);
    const double heat = area_m2[i] * strength / (depth_m * depth_m);
    entries.emplace_back(i, i, heat);
    const auto is_nearest = [nearest_m](double d) { return d <= nearest_m + kSameDistance_m; };
    const auto sharing =
        static_cast<double>(std::count_if(distance_m.begin(), distance_m.end(), is_nearest));
    for (std::size_t k = 0; k < bones.size(); ++k) {
      if (is_nearest(distance_m[k])) {
        source(i, static_cast<Eigen::Index>(k)) = heat / sharing;
      }
    }
  }

  Eigen::SparseMatrix<double> system(count, count);
  system.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(system);
  if (factors.info() != Eigen::Success) {
    throw std::invalid_argument("heat has no equilibrium on this surface");
  }
  const Eigen::MatrixXd heat = factors.solve(source);

  // Exact shares are within 0 and 1 and their sum is 1. Rounding errors are removed here.
  SkinWeights weights(bones.size(), std::vector<double>(vertices.size()));
  for (Eigen::Index i = 0; i < count; ++i) {
    double sum = 0;
    for (Eigen::Index k = 0; k < heat.cols(); ++k) {
      sum += std::max(heat(i, k), 0.0);
    }
    for (Eigen::Index k = 0; k < heat.cols(); ++k) {
      weights[static_cast<std::size_t>(k)][static_cast<std::size_t>(i)] =
          std::max(heat(i, k), 0.0) / sum;
    }
  }
  return weights;
}

}  // namespace girdle
