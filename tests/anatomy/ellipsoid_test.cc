// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "anatomy/ellipsoid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

namespace girdle::ellipsoid_test {
namespace {

// Nearest distance to the points of a grid over the surface, and half of the grid's widest gap.
struct GridDistance {
  double distance_m;
  double uncertainty_m;
};
GridDistance DistanceFromGrid(const Ellipsoid& ellipsoid, const Vector3& point_m) {
  constexpr int kSteps = 720;
  double nearest_m = 1e9;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const double latitude = kPi * (i - kSteps / 2.0) / kSteps;
      const double longitude = 2 * kPi * j / kSteps;
      const Vector3 direction{std::cos(latitude) * std::cos(longitude),
                              std::cos(latitude) * std::sin(longitude), std::sin(latitude)};
      nearest_m = std::min(
          nearest_m, glm::distance(point_m, ellipsoid.center_m + ellipsoid.radii_m * direction));
    }
  }
  const double longest_m =
      std::max({ellipsoid.radii_m.x, ellipsoid.radii_m.y, ellipsoid.radii_m.z});
  return {nearest_m, 2 * kPi / kSteps * longest_m};
}

TEST(DistanceFromEllipsoid, IsThatOfASphereForEqualRadii) {
  const Ellipsoid sphere{{0.1, -0.2, 0.3}, {0.5, 0.5, 0.5}};
  std::mt19937 random(5);
  std::normal_distribution<double> coordinate(0, 0.5);
  for (int sample = 0; sample < 100; ++sample) {
    const Vector3 point{coordinate(random), coordinate(random), coordinate(random)};
    EXPECT_NEAR(DistanceFromEllipsoid(sphere, point), glm::distance(point, sphere.center_m) - 0.5,
                1e-12)
        << point.x << " " << point.y << " " << point.z;
  }
}

TEST(DistanceFromEllipsoid, UndoesAStepAlongTheNormal) {
  const Ellipsoid ellipsoid{{-0.087, -0.083, 0.049}, {0.077, 0.201, 0.076}};
  std::mt19937 random(6);
  std::uniform_real_distribution<double> angle(0, 2 * kPi);
  for (int sample = 0; sample < 100; ++sample) {
    const double u = angle(random);
    const double v = angle(random);
    const Vector3 direction{std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v)};
    const Vector3 normal = glm::normalize(direction / ellipsoid.radii_m);
    for (const double step_m : {0.03, 1e-6, -0.01}) {
      // The smallest radius of curvature is 0.076^2 / 0.201 = 29 mm: 10 mm inside is still
      // unambiguous.
      const Vector3 point = ellipsoid.center_m + ellipsoid.radii_m * direction + step_m * normal;
      EXPECT_NEAR(DistanceFromEllipsoid(ellipsoid, point), step_m, 1e-9) << "u " << u << " v " << v;
    }
  }
}

TEST(NearestOnEllipsoid, AgreesWithASearchDeepInside) {
  const Ellipsoid ellipsoid{{0, 0, 0}, {0.09, 0.2, 0.07}};
  // Beyond the centres of curvature, where a step along a normal is no test: the middle, the axes,
  // the plane across the shortest one, and beside it by less than rounding.
  for (const Vector3 point : {Vector3{0, 0, 0},
                              {0.01, 0, 0},
                              {0, 0.05, 0},
                              {0, 0, 0.01},
                              {0.005, 0.03, 0},
                              {0.005, 0.03, 1e-18},
                              {0.005, -0.03, -0.02}}) {
    const GridDistance searched = DistanceFromGrid(ellipsoid, point);
    const SurfacePoint nearest = NearestOnEllipsoid(ellipsoid, point);
    EXPECT_LE(-nearest.distance_m, searched.distance_m + 1e-12) << point.y;
    EXPECT_NEAR(-nearest.distance_m, searched.distance_m, searched.uncertainty_m) << point.y;
    const Vector3 scaled = nearest.position_m / ellipsoid.radii_m;
    EXPECT_NEAR(glm::dot(scaled, scaled), 1, 1e-9) << "on the surface";
  }
}

TEST(NearestOnEllipsoid, LiesBelowThePointAlongItsNormal) {
  const Ellipsoid ellipsoid{{-0.087, -0.083, 0.049}, {0.077, 0.201, 0.076}};
  std::mt19937 random(7);
  std::normal_distribution<double> coordinate(0, 0.2);
  for (int sample = 0; sample < 100; ++sample) {
    const Vector3 point{coordinate(random), coordinate(random), coordinate(random)};
    const SurfacePoint nearest = NearestOnEllipsoid(ellipsoid, point);
    EXPECT_LT(glm::distance(nearest.position_m + nearest.distance_m * nearest.normal, point), 1e-9)
        << point.x << " " << point.y << " " << point.z;
  }
}

}  // namespace
}  // namespace girdle::ellipsoid_test
