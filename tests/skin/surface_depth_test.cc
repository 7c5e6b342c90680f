// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/surface_depth.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <stdexcept>
#include <utility>

#include "skin/surface_nets.h"

namespace girdle::surface_depth_test {
namespace {

// Sums of some thousand roundings.
constexpr double kExact = 1e-12;

// The cube from 0 to 1, counter-clockwise seen from outside.
TriangleMesh Cube() {
  TriangleMesh cube;
  for (int i = 0; i < 8; ++i) {
    cube.vertices_m.emplace_back(i & 1, (i >> 1) & 1, (i >> 2) & 1);
  }
  cube.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return cube;
}

// Closed form of a box's signed distance, positive inside.
double DepthInCube(const Vector3& point) {
  const Vector3 beyond = glm::abs(point - Vector3{0.5, 0.5, 0.5}) - Vector3{0.5, 0.5, 0.5};
  const double outside = glm::length(glm::max(beyond, Vector3{0, 0, 0}));
  return outside > 0 ? -outside : -std::max({beyond.x, beyond.y, beyond.z});
}

RC_GTEST_PROP(SurfaceDepth, IsThatOfACubeEverywhere, ()) {
  const auto coordinate = rc::gen::map(rc::gen::inRange(-1000, 2000),
                                       [](int thousandths) { return thousandths / 1000.0 + 1e-5; });
  const Vector3 point{*coordinate, *coordinate, *coordinate};
  RC_ASSERT(std::abs(SurfaceDepth(Cube()).Depth_m(point) - DepthInCube(point)) < kExact);
}

TEST(SurfaceDepth, WindsOnceInsideAndNotAtAllOutside) {
  const SurfaceDepth depth(Cube());
  EXPECT_NEAR(depth.WindingNumber({0.2, 0.7, 0.4}), 1, kExact);
  EXPECT_NEAR(depth.WindingNumber({1.2, 0.7, 0.4}), 0, kExact);
}

// Every surface lies around the point once more, so that the angles sum to many half turns.
TEST(SurfaceDepth, CountsEveryTurnEitherWay) {
  TriangleMesh nested;
  for (int i = 0; i < 5; ++i) {
    const int first = static_cast<int>(nested.vertices_m.size());
    for (const Vector3& corner : Cube().vertices_m) {
      nested.vertices_m.push_back(corner * (1.0 + i) - Vector3(0.4 * i));
    }
    for (const Triangle& triangle : Cube().triangles) {
      nested.triangles.push_back({triangle[0] + first, triangle[1] + first, triangle[2] + first});
    }
  }
  constexpr Vector3 kInAll{0.2, 0.7, 0.4};
  EXPECT_NEAR(SurfaceDepth(nested).WindingNumber(kInAll), 5, kExact);
  for (Triangle& triangle : nested.triangles) {
    std::swap(triangle[1], triangle[2]);
  }
  EXPECT_NEAR(SurfaceDepth(nested).WindingNumber(kInAll), -5, kExact);
}

// A corner has no solid angle of the triangles that end in it; the others see an eighth.
TEST(SurfaceDepth, WindsAnEighthAroundACornerOfACube) {
  EXPECT_NEAR(SurfaceDepth(Cube()).WindingNumber({0, 0, 0}), 0.125, kExact);
}

TEST(SurfaceDepth, IsThatOfABallThatNetsHaveMeshed) {
  constexpr double kRadius_m = 0.1;
  constexpr double kCell_m = 0.01;
  // Chords of the cell's size lie this far under the ball's surface.
  constexpr double kSagitta_m = kCell_m * kCell_m / kRadius_m;
  const SurfaceDepth depth(SurfaceNets([](const Vector3& p) { return glm::length(p) - kRadius_m; },
                                       {{-0.13, -0.13, -0.13}, {0.13, 0.13, 0.13}}, kCell_m));
  for (const double distance_m : {0.0, 0.03, 0.07, 0.095, 0.12, 0.3}) {
    const Vector3 point_m = distance_m * glm::normalize(Vector3{1, -2, 0.5});
    EXPECT_NEAR(depth.Depth_m(point_m), kRadius_m - distance_m, kSagitta_m) << distance_m;
  }
}

TEST(SurfaceDepth, HasAnInsideWithAHole) {
  TriangleMesh open = Cube();
  open.triangles.resize(10);  // without the face x = 1
  const SurfaceDepth depth(open);
  EXPECT_NEAR(depth.Depth_m({0.3, 0.5, 0.5}), 0.3, kExact);
  EXPECT_NEAR(depth.Depth_m({-0.3, 0.5, 0.5}), -0.3, kExact);
}

TEST(SurfaceDepth, IsNegativeEverywhereInsideOut) {
  TriangleMesh flipped = Cube();
  for (Triangle& triangle : flipped.triangles) {
    std::swap(triangle[1], triangle[2]);
  }
  EXPECT_NEAR(SurfaceDepth(flipped).Depth_m({0.5, 0.5, 0.4}), -0.4, kExact);
}

// Sums and the least of some numbers pass over what is none.
TEST(SurfaceDepth, IsNotKnownWhereACornerOrThePointIsNoNumber) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr Vector3 kInside{0.5, 0.5, 0.4};
  for (std::size_t vertex = 0; vertex < Cube().vertices_m.size(); ++vertex) {
    TriangleMesh broken = Cube();
    broken.vertices_m[vertex].y = kNan;
    EXPECT_TRUE(std::isnan(SurfaceDepth(broken).Depth_m(kInside))) << vertex;
  }
  EXPECT_TRUE(std::isnan(SurfaceDepth(Cube()).Depth_m({0.5, kNan, 0.4})));
}

TEST(SurfaceDepth, OfNoTrianglesIsRefused) {
  EXPECT_THROW(SurfaceDepth({{{0, 0, 0}}, {}}), std::invalid_argument);
}

TEST(SurfaceDepth, OfAVertexThatIsNotThereIsRefused) {
  TriangleMesh broken = Cube();
  broken.triangles[3] = {0, 8, 1};
  EXPECT_THROW(SurfaceDepth{broken}, std::invalid_argument);
}

}  // namespace
}  // namespace girdle::surface_depth_test
