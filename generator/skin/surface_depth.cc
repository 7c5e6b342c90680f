// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/surface_depth.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace girdle {
namespace {

double DistanceFromSegment_m(const Vector3& point, const Vector3& a, const Vector3& b) {
  const Vector3 along = b - a;
  const double length_squared = glm::dot(along, along);
  const double t =
      length_squared > 0 ? std::clamp(glm::dot(point - a, along) / length_squared, 0.0, 1.0) : 0.0;
  return glm::length(point - (a + t * along));
}

bool IsFinite(const Vector3& point_m) {
  return std::isfinite(point_m.x) && std::isfinite(point_m.y) && std::isfinite(point_m.z);
}

// The nearest point is within the triangle if the foot of the point is; otherwise it is on an edge.
double DistanceFromTriangle_m(const Vector3& point, const Vector3& a, const Vector3& b,
                              const Vector3& c) {
  const Vector3 normal = glm::cross(b - a, c - a);
  const double length = glm::length(normal);
  const auto is_left_of = [&](const Vector3& from, const Vector3& to) {
    return glm::dot(glm::cross(to - from, point - from), normal) >= 0;
  };
  if (length > 0 && is_left_of(a, b) && is_left_of(b, c) && is_left_of(c, a)) {
    return std::abs(glm::dot(point - a, normal)) / length;
  }
  return std::min({DistanceFromSegment_m(point, a, b), DistanceFromSegment_m(point, b, c),
                   DistanceFromSegment_m(point, c, a)});
}

// A direction in the plane, of any length: (cos, sin) of an angle in (-pi, pi].
struct PlaneDirection {
  double x = 1;
  double y = 0;
};

// Half the solid angle of a triangle seen from the origin (van Oosterom and Strackee 1983):
// tan(Omega / 2) = a . (b x c) / (|a| |b| |c| + (a . b) |c| + (b . c) |a| + (c . a) |b|).
PlaneDirection HalfSolidAngle(const Vector3& a, const Vector3& b, const Vector3& c) {
  const double a_m = glm::length(a);
  const double b_m = glm::length(b);
  const double c_m = glm::length(c);
  return {a_m * b_m * c_m + glm::dot(a, b) * c_m + glm::dot(b, c) * a_m + glm::dot(c, a) * b_m,
          glm::dot(a, glm::cross(b, c))};
}

// A sum of angles, kept as a number of whole turns and a direction, so that only the final angle
// needs an arc tangent. The direction of a sum is the product of the directions as complex numbers.
class AngleSum {
 public:
  void Add(const PlaneDirection& angle) noexcept {
    const double size = std::abs(angle.x) + std::abs(angle.y);
    if (!(size > 0)) {
      return;  // no direction: from its own corner, a triangle has no solid angle
    }
    const PlaneDirection sum{(sum_.x * angle.x - sum_.y * angle.y) / size,
                             (sum_.x * angle.y + sum_.y * angle.x) / size};
    // Two angles of one sign pass half a turn if their sum has the other sign.
    const bool first = sum_.y >= 0;
    const bool second = angle.y >= 0;
    const bool is_positive = sum.y >= 0;
    turns_ += static_cast<int>(first && second && !is_positive) -
              static_cast<int>(!first && !second && is_positive);
    sum_ = sum;
    if (++count_ % kMostProducts == 0) {
      const double length = std::abs(sum.x) + std::abs(sum.y);
      sum_ = {sum.x / length, sum.y / length};
    }
  }
  [[nodiscard]] double rad() const noexcept {
    // Half a turn counts as positive, as in Add(), even if its sine is -0.
    const double sine = sum_.y == 0 ? 0 : sum_.y;
    return std::atan2(sine, sum_.x) + 2 * kPi * turns_;
  }

 private:
  // Each product keeps at least 0.7 of the length. After this many products a length of 1 is still
  // 1e-5.
  static constexpr unsigned kMostProducts = 32;

  PlaneDirection sum_;
  int turns_ = 0;
  unsigned count_ = 0;
};

}  // namespace

SurfaceDepth::SurfaceDepth(TriangleMesh surface) : surface_(std::move(surface)) {
  if (surface_.triangles.empty()) {
    throw std::invalid_argument("a surface without triangles has no inside");
  }
  const auto count = static_cast<int>(surface_.vertices_m.size());
  balls_.reserve(surface_.triangles.size());
  for (const Triangle& triangle : surface_.triangles) {
    for (const int vertex : triangle) {
      if (vertex < 0 || vertex >= count) {
        throw std::invalid_argument("triangle " + std::to_string(balls_.size()) + " has vertex " +
                                    std::to_string(vertex) + ", of " + std::to_string(count));
      }
    }
    Ball ball{(At(triangle, 0) + At(triangle, 1) + At(triangle, 2)) / 3.0, 0};
    for (std::size_t corner = 0; corner < triangle.size(); ++corner) {
      ball.radius_m = std::max(ball.radius_m, glm::length(At(triangle, corner) - ball.center_m));
      is_finite_ = is_finite_ && IsFinite(At(triangle, corner));
    }
    balls_.push_back(ball);
  }
}

double SurfaceDepth::Depth_m(const Vector3& point_m) const noexcept {
  if (!is_finite_ || !IsFinite(point_m)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double distance_m = Distance_m(point_m);
  return WindingNumber(point_m) > 0.5 ? distance_m : -distance_m;
}

double SurfaceDepth::WindingNumber(const Vector3& point_m) const noexcept {
  AngleSum half_angles;
  for (const Triangle& triangle : surface_.triangles) {
    half_angles.Add(HalfSolidAngle(At(triangle, 0) - point_m, At(triangle, 1) - point_m,
                                   At(triangle, 2) - point_m));
  }
  return half_angles.rad() / (2 * kPi);
}

double SurfaceDepth::Distance_m(const Vector3& point_m) const noexcept {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < balls_.size(); ++i) {
    const Vector3 to_center = balls_[i].center_m - point_m;
    const double reach_m = nearest_m + balls_[i].radius_m;
    if (glm::dot(to_center, to_center) > reach_m * reach_m) {
      continue;
    }
    const Triangle& triangle = surface_.triangles[i];
    nearest_m = std::min(nearest_m, DistanceFromTriangle_m(point_m, At(triangle, 0),
                                                           At(triangle, 1), At(triangle, 2)));
  }
  return nearest_m;
}

}  // namespace girdle
