// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "anatomy/ellipsoid.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace girdle {

// The nearest point x of the surface has p - x = l grad/2, which gives x_i = r_i^2 p_i / (l +
// r_i^2). l is the largest root of sum (r_i p_i / (l + r_i^2))^2 = 1, which bisection finds
// (Eberly, Distance from a Point to an Ellipsoid).
SurfacePoint NearestOnEllipsoid(const Ellipsoid& ellipsoid, const Vector3& point_m) noexcept {
  const Vector3 p = point_m - ellipsoid.center_m;
  const Vector3& r = ellipsoid.radii_m;
  const Vector3 r_squared = r * r;
  int shortest = 0;
  for (int i = 1; i < 3; ++i) {
    if (r[i] < r[shortest]) {
      shortest = i;
    }
  }
  const auto excess = [&](double l) {
    const Vector3 term = r * p / (r_squared + l);
    return glm::dot(term, term) - 1;
  };
  double lower = -r_squared[shortest];
  double upper = glm::length(r) * glm::length(p) + glm::dot(p, p);
  // A range of at most some meters squared that is halved this often is exact to the last bit.
  constexpr int kHalvings = 100;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (lower + upper) / 2;
    (excess(middle) > 0 ? lower : upper) = middle;
  }

  Vector3 x{0, 0, 0};
  for (int i = 0; i < 3; ++i) {
    if (p[i] != 0) {
      x[i] = r_squared[i] * p[i] / (r_squared[i] + upper);
    }
  }
  // Near the plane across the shortest axis, deep inside, the quotient of that axis is 0 / 0. The
  // coordinate along that axis then comes from the equation of the surface.
  constexpr double kCancelled = 1e-6;
  if (r_squared[shortest] + upper < kCancelled * r_squared[shortest]) {
    Vector3 others = x / r;
    others[shortest] = 0;
    x[shortest] = std::copysign(
        r[shortest] * std::sqrt(std::max(0.0, 1 - glm::dot(others, others))), p[shortest]);
  }
  return {ellipsoid.center_m + x, glm::normalize(x / r_squared),
          std::copysign(glm::distance(p, x), excess(0))};
}

double DistanceFromEllipsoid(const Ellipsoid& ellipsoid, const Vector3& point_m) noexcept {
  return NearestOnEllipsoid(ellipsoid, point_m).distance_m;
}

}  // namespace girdle
