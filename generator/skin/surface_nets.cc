// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/surface_nets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <stdexcept>

namespace girdle {
namespace {

constexpr double kMostPoints = 50e6;
constexpr int kNoVertex = -1;
// Depth of a corner that was added to the inside, in cells.
constexpr double kFilled = 0.01;
// Points along an edge of the largest block that one value can represent; a power of 2.
constexpr std::size_t kLargestBlock = 8;
// Distance from the middle of a cube of side 1 to a corner.
constexpr double kHalfDiagonal = 0.8660254037844386;

using Step = std::array<std::size_t, 3>;

// Values of a function on a cubic grid, and the cells between its points.
class Grid {
 public:
  Grid(const std::function<double(const Vector3&)>& value_m, const Box& box, double cell_m,
       double steepest)
      : origin_m_(box.lowest_m), cell_m_(cell_m) {
    double points = 1;
    for (int i = 0; i < 3; ++i) {
      const double cells = std::ceil((box.highest_m[i] - box.lowest_m[i]) / cell_m);
      if (!(cell_m > 0) || !(cells >= 1)) {
        throw std::invalid_argument("surface nets need a box and cells of a size above 0");
      }
      points *= cells + 1;
      if (!(points <= kMostPoints)) {
        throw std::invalid_argument("surface nets: too many cells");
      }
      counts_[static_cast<std::size_t>(i)] = static_cast<std::size_t>(cells) + 1;
    }
    strides_ = {1, counts_[0], counts_[0] * counts_[1]};
    values_m_.resize(strides_[2] * counts_[2]);
    for (std::size_t z = 0; z < counts_[2]; z += kLargestBlock) {
      for (std::size_t y = 0; y < counts_[1]; y += kLargestBlock) {
        for (std::size_t x = 0; x < counts_[0]; x += kLargestBlock) {
          Evaluate(value_m, steepest, {x, y, z}, kLargestBlock);
        }
      }
    }
    while (FillAlternatingFaces()) {
    }
  }

  template <typename Visit>
  void ForEachPoint(const Visit& visit) const {
    std::size_t index = 0;
    for (std::size_t z = 0; z < counts_[2]; ++z) {
      for (std::size_t y = 0; y < counts_[1]; ++y) {
        for (std::size_t x = 0; x < counts_[0]; ++x) {
          visit(index++, Step{x, y, z});
        }
      }
    }
  }

  [[nodiscard]] Vector3 Place_m(const Step& at) const {
    return origin_m_ + cell_m_ * Vector3(at[0], at[1], at[2]);
  }
  [[nodiscard]] bool IsInside(std::size_t index) const { return values_m_[index] < 0; }
  [[nodiscard]] double value_m(std::size_t index) const { return values_m_[index]; }
  [[nodiscard]] double cell_m() const { return cell_m_; }
  [[nodiscard]] std::size_t stride(std::size_t axis) const { return strides_[axis]; }
  [[nodiscard]] std::size_t size() const { return values_m_.size(); }
  /// Whether a point is the lowest corner of a cell.
  [[nodiscard]] bool HasCell(const Step& at) const {
    return at[0] + 1 < counts_[0] && at[1] + 1 < counts_[1] && at[2] + 1 < counts_[2];
  }

 private:
  // Finds the values of the points of a cube, as far as it lies in the grid. One value represents
  // all points if the surface is farther from the middle than every neighbour of a point in the
  // cube: only the signs of such points are used.
  void Evaluate(const std::function<double(const Vector3&)>& value_m, double steepest,
                const Step& first, std::size_t size) {
    Step end{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (first[axis] >= counts_[axis]) {
        return;
      }
      end[axis] = std::min(first[axis] + size, counts_[axis]);
    }
    if (size == 1) {
      values_m_[first[0] + strides_[1] * first[1] + strides_[2] * first[2]] =
          value_m(Place_m(first));
      return;
    }
    if (std::isfinite(steepest)) {
      const double half = static_cast<double>(size - 1) / 2;
      const double middle_m = value_m(Place_m(first) + half * cell_m_);
      const double neighbours_m = (2 * half * kHalfDiagonal + 1) * cell_m_;
      if (std::abs(middle_m) > steepest * neighbours_m) {
        for (std::size_t z = first[2]; z < end[2]; ++z) {
          for (std::size_t y = first[1]; y < end[1]; ++y) {
            const std::size_t row = strides_[1] * y + strides_[2] * z;
            for (std::size_t x = first[0]; x < end[0]; ++x) {
              values_m_[row + x] = middle_m;
            }
          }
        }
        return;
      }
    }
    const std::size_t part = size / 2;
    for (const std::size_t z : {first[2], first[2] + part}) {
      for (const std::size_t y : {first[1], first[1] + part}) {
        for (const std::size_t x : {first[0], first[0] + part}) {
          Evaluate(value_m, steepest, {x, y, z}, part);
        }
      }
    }
  }

  // If the signs of a face's four corners alternate, the surface would touch itself along an edge.
  // The outer corner that is nearer to the surface is then added to the inside. Returns whether
  // there was such a face. Each round adds corners, so that the rounds end.
  bool FillAlternatingFaces() {
    bool has_filled = false;
    ForEachPoint([&](std::size_t index, const Step& at) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t second = (axis + 1) % 3;
        if (at[axis] + 1 >= counts_[axis] || at[second] + 1 >= counts_[second]) {
          continue;
        }
        const std::array<std::size_t, 4> corners = {index, index + strides_[axis],
                                                    index + strides_[axis] + strides_[second],
                                                    index + strides_[second]};
        const bool is_inside = IsInside(corners[0]);
        if (IsInside(corners[2]) != is_inside || IsInside(corners[1]) == is_inside ||
            IsInside(corners[3]) == is_inside) {
          continue;
        }
        const std::size_t first = is_inside ? 1 : 0;
        const std::size_t a = corners[first];
        const std::size_t b = corners[first + 2];
        values_m_[values_m_[a] <= values_m_[b] ? a : b] = -kFilled * cell_m_;
        has_filled = true;
      }
    });
    return has_filled;
  }

  Vector3 origin_m_;
  double cell_m_;
  Step counts_{};
  Step strides_{};
  std::vector<double> values_m_;
};

// Computes the mean of the points where the surface crosses the edges of the cell above a point.
// Returns false if it crosses none.
bool MeanCrossing_m(const Grid& grid, std::size_t index, const Step& at, Vector3& mean_m) {
  Vector3 sum{0, 0, 0};
  int crossings = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t second = (axis + 1) % 3;
    const std::size_t third = (axis + 2) % 3;
    for (std::size_t corner = 0; corner < 4; ++corner) {
      const std::size_t b = corner & 1U;
      const std::size_t c = corner >> 1U;
      const std::size_t from = index + b * grid.stride(second) + c * grid.stride(third);
      const std::size_t to = from + grid.stride(axis);
      if (grid.IsInside(from) == grid.IsInside(to)) {
        continue;
      }
      Vector3 offset{0, 0, 0};
      offset[static_cast<int>(axis)] = grid.value_m(from) / (grid.value_m(from) - grid.value_m(to));
      offset[static_cast<int>(second)] = static_cast<double>(b);
      offset[static_cast<int>(third)] = static_cast<double>(c);
      sum += offset;
      ++crossings;
    }
  }
  if (crossings == 0) {
    return false;
  }
  mean_m = grid.Place_m(at) + grid.cell_m() * sum / static_cast<double>(crossings);
  return true;
}

// Moves a vertex by one Newton step along the gradient, no farther than it may leave its cell.
Vector3 DrawnToSurface_m(const std::function<double(const Vector3&)>& value_m,
                         const Vector3& point_m, double cell_m) {
  const double difference_m = 0.01 * cell_m;
  const double here_m = value_m(point_m);
  Vector3 gradient{0, 0, 0};
  for (int i = 0; i < 3; ++i) {
    Vector3 beside_m = point_m;
    beside_m[i] += difference_m;
    gradient[i] = (value_m(beside_m) - here_m) / difference_m;
  }
  const double steepness_squared = glm::dot(gradient, gradient);
  if (!(steepness_squared > 0)) {
    return point_m;
  }
  const Vector3 step_m = -here_m / steepness_squared * gradient;
  const double farthest_m = cell_m / 4;
  const double length_m = glm::length(step_m);
  return point_m + (length_m > farthest_m ? farthest_m / length_m : 1.0) * step_m;
}

}  // namespace

TriangleMesh SurfaceNets(const std::function<double(const Vector3&)>& value_m, const Box& box,
                         double cell_m, double steepest) {
  const Grid grid(value_m, box, cell_m, steepest);
  TriangleMesh mesh;
  std::vector<int> vertex_of(grid.size(), kNoVertex);
  grid.ForEachPoint([&](std::size_t index, const Step& at) {
    Vector3 mean_m;
    if (grid.HasCell(at) && MeanCrossing_m(grid, index, at, mean_m)) {
      vertex_of[index] = static_cast<int>(mesh.vertices_m.size());
      mesh.vertices_m.push_back(DrawnToSurface_m(value_m, mean_m, cell_m));
    }
  });

  const auto length_m = [&mesh](int a, int b) {
    return glm::length(mesh.vertices_m[static_cast<std::size_t>(a)] -
                       mesh.vertices_m[static_cast<std::size_t>(b)]);
  };
  grid.ForEachPoint([&](std::size_t index, const Step& at) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t second = (axis + 1) % 3;
      const std::size_t third = (axis + 2) % 3;
      // The edge from this point along the axis is used if all four cells around it exist.
      if (!grid.HasCell(at) || at[second] == 0 || at[third] == 0) {
        continue;
      }
      const bool is_inside = grid.IsInside(index);
      if (is_inside == grid.IsInside(index + grid.stride(axis))) {
        continue;
      }
      std::array<int, 4> quad = {vertex_of[index], vertex_of[index - grid.stride(second)],
                                 vertex_of[index - grid.stride(second) - grid.stride(third)],
                                 vertex_of[index - grid.stride(third)]};
      if (!is_inside) {
        std::swap(quad[1], quad[3]);
      }
      if (length_m(quad[0], quad[2]) <= length_m(quad[1], quad[3])) {
        mesh.triangles.push_back({quad[0], quad[1], quad[2]});
        mesh.triangles.push_back({quad[0], quad[2], quad[3]});
      } else {
        mesh.triangles.push_back({quad[1], quad[2], quad[3]});
        mesh.triangles.push_back({quad[1], quad[3], quad[0]});
      }
    }
  });
  return mesh;
}

}  // namespace girdle
