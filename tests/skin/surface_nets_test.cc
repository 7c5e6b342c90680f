// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/surface_nets.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <ostream>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/rotation.h"
#include "skin/surface_topology.h"

namespace girdle::surface_nets_test {
namespace {

using Value = std::function<double(const Vector3&)>;

constexpr double kRadius_m = 0.1;
constexpr double kCell_m = 0.01;
// No grid point or plane of symmetry.
const Vector3 kCenter_m{0.0013, -0.0027, 0.0041};
const Box kAroundBall{Vector3(-0.13), Vector3(0.13)};

// Triangles are chords: they lie about (cell / radius)^2 / 6 under the surface, and as a share
// their area and their volume are short of the closed form's by less than that square.
constexpr double kChordShare = kCell_m * kCell_m / (kRadius_m * kRadius_m);

double Ball(const Vector3& p) { return glm::length(p - kCenter_m) - kRadius_m; }

TriangleMesh BallMesh() { return SurfaceNets(Ball, kAroundBall, kCell_m); }

TEST(SurfaceNetsOfABall, AreClosed) { EXPECT_TRUE(UnpairedEdges(BallMesh()).empty()); }

TEST(SurfaceNetsOfABall, AreASphere) { EXPECT_EQ(EulerCharacteristic(BallMesh()), 2); }

TEST(SurfaceNetsOfABall, UseEveryVertex) {
  const TriangleMesh mesh = BallMesh();
  std::vector<bool> used(mesh.vertices_m.size());
  for (const Triangle& triangle : mesh.triangles) {
    for (const int vertex : triangle) {
      used.at(static_cast<std::size_t>(vertex)) = true;
    }
  }
  EXPECT_EQ(std::count(used.begin(), used.end(), false), 0);
}

TEST(SurfaceNetsOfABall, HaveItsVolumeOutward) {
  const double exact_m3 = 4 * kPi / 3 * kRadius_m * kRadius_m * kRadius_m;
  EXPECT_NEAR(Volume_m3(BallMesh()) / exact_m3, 1, kChordShare);
}

TEST(SurfaceNetsOfABall, HaveItsArea) {
  EXPECT_NEAR(Area_m2(BallMesh()) / (4 * kPi * kRadius_m * kRadius_m), 1, kChordShare);
}

TEST(SurfaceNetsOfABall, HaveVerticesOnIt) {
  // A step of Newton's from within a tenth of a cell, along a gradient that is a difference over a
  // hundredth of one: off by their product over the radius.
  constexpr double kOff_m = 0.1 * kCell_m * 0.01 * kCell_m / kRadius_m;
  for (const Vector3& vertex_m : BallMesh().vertices_m) {
    EXPECT_NEAR(Ball(vertex_m), 0, kOff_m);
  }
}

TEST(SurfaceNetsOfABall, HaveNoSlivers) {
  // Marching cubes cut corners off cells, however little; here vertices are those of whole cells.
  for (const TriangleMesh mesh = BallMesh(); const auto& [edge, count] : EdgeCounts(mesh)) {
    const double length_m = glm::length(mesh.vertices_m.at(static_cast<std::size_t>(edge.first)) -
                                        mesh.vertices_m.at(static_cast<std::size_t>(edge.second)));
    EXPECT_GT(length_m, kCell_m / 8);
    EXPECT_LT(length_m, 1.6 * kCell_m) << "a quadrilateral's longer diagonal";
  }
}

TEST(SurfaceNetsOfATorus, HaveAHole) {
  constexpr double kRing_m = 0.1;
  constexpr double kTube_m = 0.04;
  const TriangleMesh mesh = SurfaceNets(
      [](const Vector3& point_m) {
        const Vector3 p = point_m - kCenter_m;
        return std::hypot(std::hypot(p.x, p.y) - kRing_m, p.z) - kTube_m;
      },
      {Vector3(-0.17), Vector3(0.17)}, kCell_m);
  EXPECT_TRUE(UnpairedEdges(mesh).empty());
  EXPECT_EQ(EulerCharacteristic(mesh), 0);
  const double exact_m3 = 2 * kPi * kPi * kRing_m * kTube_m * kTube_m;
  // As of the ball, with the tube's radius.
  EXPECT_NEAR(Volume_m3(mesh) / exact_m3, 1, kCell_m * kCell_m / (kTube_m * kTube_m));
}

TEST(SurfaceNets, OfNothingAreEmpty) {
  const TriangleMesh mesh = SurfaceNets([](const Vector3&) { return 1.0; }, kAroundBall, kCell_m);
  EXPECT_TRUE(mesh.vertices_m.empty());
  EXPECT_TRUE(mesh.triangles.empty());
}

// Two balls whose nearest corners of the grid are those of a face's diagonal, a quarter of a cell
// apart: the quadrilaterals of both would share an edge, four to it.
TEST(SurfaceNets, OfBallsThatNearlyTouchInsideACellCloseTheGap) {
  constexpr double kBall_cells = 2;
  const Vector3 other{3, 3, 0};
  const TriangleMesh mesh = SurfaceNets(
      [other](const Vector3& p) {
        return std::min(glm::length(p), glm::length(p - other)) - kBall_cells;
      },
      {Vector3(-4), Vector3(8)}, 1);
  EXPECT_TRUE(UnpairedEdges(mesh).empty());
  EXPECT_EQ(EulerCharacteristic(mesh), 2) << "one piece without a hole";
}

TEST(SurfaceNets, OfBallsFartherApartThanACellAreTwo) {
  const Vector3 other{4, 4, 0};
  const TriangleMesh mesh = SurfaceNets(
      [other](const Vector3& p) { return std::min(glm::length(p), glm::length(p - other)) - 2; },
      {Vector3(-4), Vector3(8)}, 1);
  EXPECT_TRUE(UnpairedEdges(mesh).empty());
  EXPECT_EQ(EulerCharacteristic(mesh), 4);
}

// Corners of the grid that are inside or outside by chance: every case of a cell and its
// neighbours comes up.
RC_GTEST_PROP(SurfaceNets, AreClosedWhateverTheSignsOfTheCorners, ()) {
  constexpr int kCorners = 9;
  std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
  std::uniform_real_distribution<double> value(-1, 1);
  std::vector<double> values(kCorners * kCorners * kCorners);
  std::generate(values.begin(), values.end(), [&] { return value(random); });
  const auto at = [&](const Vector3& p) {
    std::size_t index = 0;
    for (int i = 0; i < 3; ++i) {
      const int corner = static_cast<int>(std::round(p[i]));
      if (corner <= 0 || corner >= kCorners - 1) {
        return 1.0;  // the surface lies within the box
      }
      index = kCorners * index + static_cast<std::size_t>(corner);
    }
    return values[index];
  };
  const TriangleMesh mesh = SurfaceNets(at, {Vector3(0), Vector3(kCorners - 1)}, 1);
  RC_ASSERT(!mesh.triangles.empty());
  RC_ASSERT(UnpairedEdges(mesh).empty());
  RC_ASSERT(Volume_m3(mesh) > 0);
}

// Balls by chance, of which many touch, run into each other or leave the box.
RC_GTEST_PROP(SurfaceNets, AreTheSameWhereABoundOfTheSlopeSavesValues, ()) {
  constexpr int kBalls = 5;
  std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
  std::uniform_real_distribution<double> place(0, 30);
  std::uniform_real_distribution<double> radius(1, 9);
  std::array<std::pair<Vector3, double>, kBalls> balls;
  for (auto& [center, size] : balls) {
    center = {place(random), place(random), place(random)};
    size = radius(random);
  }
  int asked = 0;
  const double slope = *rc::gen::element(1.0, 0.25, 3.0);
  const auto value = [&](const Vector3& p) {
    ++asked;
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [center, size] : balls) {
      nearest = std::min(nearest, slope * (glm::length(p - center) - size));
    }
    return nearest;
  };
  const Box box{Vector3(0), Vector3(30)};
  const TriangleMesh every = SurfaceNets(value, box, 1);
  const int asked_for_every = std::exchange(asked, 0);
  const TriangleMesh same = SurfaceNets(value, box, 1, slope);
  RC_ASSERT(same.vertices_m == every.vertices_m);
  RC_ASSERT(same.triangles == every.triangles);
  RC_ASSERT(asked < asked_for_every);
}

TEST(SurfaceNets, AskForFewValuesFarFromTheSurface) {
  int asked = 0;
  const auto ball = [&asked](const Vector3& p) {
    ++asked;
    return Ball(p);
  };
  const Box far{Vector3(-1), Vector3(1)};
  const TriangleMesh mesh = SurfaceNets(ball, far, kCell_m, 1);
  EXPECT_EQ(EulerCharacteristic(mesh), 2);
  // The grid has 201^3 points, 8.1 million.
  EXPECT_LT(asked, 100'000);
}

TEST(SurfaceNets, AreOpenOnlyAtTheBox) {
  Box cut = kAroundBall;
  cut.highest_m.x = 0.05;
  const TriangleMesh mesh = SurfaceNets(Ball, cut, kCell_m);
  const std::vector<Edge> open = UnpairedEdges(mesh);
  EXPECT_FALSE(open.empty());
  for (const Edge& edge : open) {
    EXPECT_NEAR(mesh.vertices_m.at(static_cast<std::size_t>(edge.first)).x, cut.highest_m.x,
                kCell_m);
  }
}

TEST(SurfaceNets, MoveWithTheSolidAndItsBox) {
  // Sums of binary fractions are exact.
  constexpr double kBinaryCell_m = 1.0 / 128;
  const Vector3 cells{3, -7, 40};
  const Vector3 by_m = kBinaryCell_m * cells;
  const Box box{Vector3(-18 * kBinaryCell_m), Vector3(18 * kBinaryCell_m)};
  const TriangleMesh mesh = SurfaceNets(Ball, box, kBinaryCell_m);
  const TriangleMesh moved =
      SurfaceNets([by_m](const Vector3& p) { return Ball(p - by_m); },
                  {box.lowest_m + by_m, box.highest_m + by_m}, kBinaryCell_m);
  ASSERT_EQ(moved.triangles, mesh.triangles);
  constexpr double kRounding_m = 1e-12;
  for (std::size_t i = 0; i < mesh.vertices_m.size(); ++i) {
    EXPECT_LT(glm::length(moved.vertices_m[i] - by_m - mesh.vertices_m[i]), kRounding_m);
  }
}

// Of what is wrong, one thing.
struct BadGrid {
  const char* name;
  Box box;
  double cell_m;
  const char* message;
};

void PrintTo(const BadGrid& grid, std::ostream* out) { *out << grid.name; }

class SurfaceNetsOfABadGrid : public testing::TestWithParam<BadGrid> {};

TEST_P(SurfaceNetsOfABadGrid, AreRefused) {
  try {
    static_cast<void>(SurfaceNets(Ball, GetParam().box, GetParam().cell_m));
    FAIL() << "was taken";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(GetParam().message), std::string::npos)
        << error.what();
  }
}

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr const char* kNoGrid = "a box and cells of a size above 0";

INSTANTIATE_TEST_SUITE_P(
    Grids, SurfaceNetsOfABadGrid,
    testing::Values(BadGrid{"cells without size", kAroundBall, 0, kNoGrid},
                    BadGrid{"cells of a size below 0", kAroundBall, -kCell_m, kNoGrid},
                    BadGrid{"cells of no size", kAroundBall, kNaN, kNoGrid},
                    BadGrid{"a flat box", {Vector3(0), {1, 0, 1}}, kCell_m, kNoGrid},
                    BadGrid{"a box inside out", {Vector3(1), {2, 0, 2}}, kCell_m, kNoGrid},
                    BadGrid{"a box of no size", {Vector3(0), {1, kNaN, 1}}, kCell_m, kNoGrid},
                    BadGrid{"an endless box", {Vector3(0), {1, kInfinity, 1}}, kCell_m, "too many"},
                    BadGrid{"cells too small", kAroundBall, kCell_m / 20, "too many"}));

}  // namespace
}  // namespace girdle::surface_nets_test
