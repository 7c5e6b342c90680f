// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/cut_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "skin/solids.h"
#include "skin/surface_topology.h"

namespace girdle::cut_surface_test {
namespace {

// Not a multiple of the cells, whose corners would lie on the surface.
constexpr double kRadius_m = 0.1003;
constexpr double kCell_m = 0.01;
// Sums of some roundings.
constexpr double kExact = 1e-12;

// A share that is linear in the place, and what is left of 1.
double Share(const Vector3& p) { return 0.5 + 2 * p.x + p.y; }

WeightedSurface WeightedBall() {
  WeightedSurface ball{Ball(kRadius_m, kCell_m), SkinWeights(2)};
  for (const Vector3& vertex : ball.mesh.vertices_m) {
    ball.weights[0].push_back(Share(vertex));
    ball.weights[1].push_back(1 - Share(vertex));
  }
  return ball;
}

std::vector<bool> NoneOf(const WeightedSurface& surface) {
  return std::vector<bool>(surface.mesh.vertices_m.size(), false);
}

class CutAtHeight : public testing::TestWithParam<double> {};

// A cap of height h of a ball: pi h^2 (3 r - h) / 3.
TEST_P(CutAtHeight, LeavesAClosedCapOfABall) {
  const double y_m = GetParam();
  const WeightedSurface ball = WeightedBall();
  const TriangleMesh cap = Cut(ball, {{0, y_m, 0}, {0, 1, 0}}, NoneOf(ball)).mesh;
  EXPECT_TRUE(IsClosed(cap));
  const double height_m = kRadius_m + y_m;
  const double volume_m3 = kPi * height_m * height_m * (3 * kRadius_m - height_m) / 3;
  // The mesh lies within its sagitta of the ball, and so does what was moved onto the cut.
  const double allowed_m3 = 4 * kPi * kRadius_m * kRadius_m * kCell_m * kCell_m / kRadius_m;
  EXPECT_NEAR(Volume_m3(cap), volume_m3, allowed_m3);
}

TEST_P(CutAtHeight, LeavesNothingBeyond) {
  const WeightedSurface ball = WeightedBall();
  for (const Vector3& vertex :
       Cut(ball, {{0, GetParam(), 0}, {0, 1, 0}}, NoneOf(ball)).mesh.vertices_m) {
    EXPECT_LE(vertex.y, GetParam() + kExact);
  }
}

TEST_P(CutAtHeight, LeavesNoSlivers) {
  const WeightedSurface ball = WeightedBall();
  const TriangleMesh cap = Cut(ball, {{0, GetParam(), 0}, {0, 1, 0}}, NoneOf(ball)).mesh;
  for (const Triangle& triangle : cap.triangles) {
    const Vector3& a = Corner_m(cap, triangle, 0);
    const double twice_area_m2 =
        glm::length(glm::cross(Corner_m(cap, triangle, 1) - a, Corner_m(cap, triangle, 2) - a));
    // The narrow ring of a lid is some hundredths as wide as the lid.
    EXPECT_GT(twice_area_m2, 1e-3 * kCell_m * kCell_m);
  }
}

TEST_P(CutAtHeight, GivesNewVerticesTheSharesOfTheirPlaces) {
  const WeightedSurface ball = WeightedBall();
  const WeightedSurface cap = Cut(ball, {{0, GetParam(), 0}, {0, 1, 0}}, NoneOf(ball));
  ASSERT_EQ(cap.weights[0].size(), cap.mesh.vertices_m.size());
  for (std::size_t i = 0; i < cap.mesh.vertices_m.size(); ++i) {
    // Vertices that were moved onto the cut keep their shares.
    EXPECT_NEAR(cap.weights[0][i], Share(cap.mesh.vertices_m[i]), kNearCut_m);
    EXPECT_NEAR(cap.weights[0][i] + cap.weights[1][i], 1, kExact);
  }
}

INSTANTIATE_TEST_SUITE_P(Heights, CutAtHeight, testing::Values(-0.07, -0.0313, 0.0, 0.005, 0.0717));

TEST(Cut, LeavesWhatIsSparedAsItIs) {
  const WeightedSurface ball = WeightedBall();
  const WeightedSurface spared =
      Cut(ball, {{0, 0, 0}, {0, 1, 0}}, std::vector<bool>(ball.mesh.vertices_m.size(), true));
  EXPECT_EQ(spared.mesh.vertices_m, ball.mesh.vertices_m);
  EXPECT_EQ(spared.mesh.triangles, ball.mesh.triangles);
}

TEST(Cut, BeyondTheSurfaceLeavesItAsItIs) {
  const WeightedSurface ball = WeightedBall();
  const WeightedSurface whole = Cut(ball, {{0, 0.2, 0}, {0, 1, 0}}, NoneOf(ball));
  EXPECT_EQ(whole.mesh.vertices_m, ball.mesh.vertices_m);
  EXPECT_EQ(whole.mesh.triangles, ball.mesh.triangles);
}

}  // namespace
}  // namespace girdle::cut_surface_test
