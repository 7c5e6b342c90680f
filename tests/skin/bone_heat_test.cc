// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/bone_heat.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <ostream>
#include <stdexcept>
#include <vector>

#include "skin/surface_nets.h"

namespace girdle::bone_heat_test {
namespace {

constexpr double kRadius_m = 0.04;
constexpr double kHalfLength_m = 0.2;

// An open cylinder around x, of rings that are turned by half a facet against each other.
TriangleMesh Cylinder(int facets, int rings) {
  TriangleMesh cylinder;
  for (int i = 0; i <= rings; ++i) {
    for (int j = 0; j < facets; ++j) {
      const double turn = 2 * kPi * (j + 0.5 * (i % 2)) / facets;
      cylinder.vertices_m.emplace_back(kHalfLength_m * (2.0 * i / rings - 1),
                                       kRadius_m * std::cos(turn), kRadius_m * std::sin(turn));
    }
  }
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < facets; ++j) {
      const int here = i * facets + j;
      const int beside = i * facets + (j + 1) % facets;
      const int above = here + facets;
      const int above_beside = beside + facets;
      if (i % 2 == 0) {
        cylinder.triangles.push_back({here, beside, above});
        cylinder.triangles.push_back({beside, above_beside, above});
      } else {
        cylinder.triangles.push_back({here, above_beside, above});
        cylinder.triangles.push_back({here, beside, above_beside});
      }
    }
  }
  return cylinder;
}

BoneShape Rod_m(double from_x_m, double to_x_m) {
  return {{{{from_x_m, 0, 0}, {to_x_m, 0, 0}, 0}}, {}};
}

// The cylinder's axis in two halves.
std::vector<BoneShape> Halves() { return {Rod_m(-kHalfLength_m, 0), Rod_m(0, kHalfLength_m)}; }

// Share of the half x > 0 on a cylinder of length 2 l, whose ends let no heat through:
// w'' = (w - p) c / R^2, w'(-l) = w'(l) = 0, so that for x < 0
// w = cosh(k (x + l)) / (2 cosh(k l)), k = sqrt(c) / R, and 1 - w(-x) for x > 0;
// exp(k x) / 2 on an endless one.
double ExactShare(double x_m, double strength) {
  const double k = std::sqrt(strength) / kRadius_m;
  const double below =
      std::cosh(k * (kHalfLength_m - std::abs(x_m))) / (2 * std::cosh(k * kHalfLength_m));
  return x_m < 0 ? below : 1 - below;
}

class BoneHeatOfACylinder : public testing::TestWithParam<double> {};

TEST_P(BoneHeatOfACylinder, HasTheSharesOfTheClosedForm) {
  constexpr int kRings = 80;
  const TriangleMesh cylinder = Cylinder(48, kRings);
  const SkinWeights weights = BoneHeat(cylinder, Halves(), GetParam());
  // Linear triangles are off by the square of how far a ring's width is of the way in which shares
  // change, 1 / k.
  const double ring_m = 2 * kHalfLength_m / kRings;
  const double off = GetParam() * ring_m * ring_m / (kRadius_m * kRadius_m) / 12;
  for (std::size_t i = 0; i < cylinder.vertices_m.size(); ++i) {
    const double x_m = cylinder.vertices_m[i].x;
    EXPECT_NEAR(weights[1][i], ExactShare(x_m, GetParam()), off) << "at " << x_m;
    EXPECT_NEAR(weights[0][i], 1 - ExactShare(x_m, GetParam()), off) << "at " << x_m;
  }
}

INSTANTIATE_TEST_SUITE_P(Strengths, BoneHeatOfACylinder, testing::Values(0.05, kHeatStrength, 2.0));

// The largest difference between a mesh's shares and the closed form's.
double LargestError(const TriangleMesh& cylinder) {
  const SkinWeights weights = BoneHeat(cylinder, Halves(), 1);
  double largest = 0;
  for (std::size_t i = 0; i < cylinder.vertices_m.size(); ++i) {
    largest = std::max(largest, std::abs(weights[1][i] - ExactShare(cylinder.vertices_m[i].x, 1)));
  }
  return largest;
}

TEST(BoneHeat, OfAFinerMeshIsNearerToTheClosedForm) {
  // Of the second order: half the width, a quarter of the error.
  EXPECT_NEAR(LargestError(Cylinder(24, 40)) / LargestError(Cylinder(48, 80)), 4, 0.4);
}

TEST(BoneHeat, HasTheDefaultStrength) {
  const TriangleMesh cylinder = Cylinder(12, 20);
  EXPECT_EQ(BoneHeat(cylinder, Halves()), BoneHeat(cylinder, Halves(), kHeatStrength));
}

// Within 4 mm of a bone heat would grow without bounds: nearer skin is as if it were 4 mm away.
TEST(BoneHeat, IsBoundedOnABone) {
  const TriangleMesh cylinder = Cylinder(24, 40);
  const auto thick = [](double radius_m) {
    std::vector<BoneShape> bones = Halves();
    bones[0].rods[0].radius_m = radius_m;
    bones[1].rods[0].radius_m = radius_m;
    return bones;
  };
  const SkinWeights near = BoneHeat(cylinder, thick(kRadius_m - 0.004), 0.001);
  const SkinWeights nearer = BoneHeat(cylinder, thick(kRadius_m - 0.001), 0.001);
  const SkinWeights farther = BoneHeat(cylinder, thick(kRadius_m - 0.008), 0.001);
  double change = 0;
  for (std::size_t i = 0; i < cylinder.vertices_m.size(); ++i) {
    // Sums of some thousand roundings.
    EXPECT_NEAR(nearer[0][i], near[0][i], 1e-9);
    change = std::max(change, std::abs(farther[0][i] - near[0][i]));
  }
  EXPECT_GT(change, 0.01);
}

// A ball about three bones that meet askew, one of them with an ellipsoid.
TriangleMesh Ball(double cell_m) {
  return SurfaceNets([](const Vector3& p) { return glm::length(p) - 0.1; },
                     {Vector3(-0.13), Vector3(0.13)}, cell_m);
}

std::vector<BoneShape> Askew() {
  return {{{{{0, 0, 0}, {0.07, 0, 0}, 0.01}}, {}},
          {{{{0, 0, 0}, {-0.04, 0.05, 0.02}, 0.005}}, {}},
          {{}, {{{-0.02, -0.05, 0}, {0.02, 0.03, 0.03}}}}};
}

TEST(BoneHeat, HasSharesThatAreNotNegativeAndOneInSum) {
  const TriangleMesh ball = Ball(0.008);
  const SkinWeights weights = BoneHeat(ball, Askew());
  ASSERT_EQ(weights.size(), 3U);
  for (std::size_t i = 0; i < ball.vertices_m.size(); ++i) {
    double sum = 0;
    for (const std::vector<double>& of_bone : weights) {
      ASSERT_EQ(of_bone.size(), ball.vertices_m.size());
      EXPECT_GE(of_bone[i], 0);
      sum += of_bone[i];
    }
    EXPECT_NEAR(sum, 1, 1e-12);
  }
}

// The smallest share is far above rounding where heat has spread: nothing was cut off at 0.
TEST(BoneHeat, ReachesAllOfASurfaceInOnePiece) {
  for (const std::vector<double>& of_bone : BoneHeat(Ball(0.008), Askew())) {
    EXPECT_GT(*std::min_element(of_bone.begin(), of_bone.end()), 1e-6);
  }
}

TEST(BoneHeat, HardlyDependsOnTheMesh) {
  const TriangleMesh coarse = Ball(0.008);
  const TriangleMesh fine = Ball(0.004);
  const SkinWeights of_coarse = BoneHeat(coarse, Askew());
  const SkinWeights of_fine = BoneHeat(fine, Askew());
  // A fine vertex lies within half a coarse cell's diagonal of a coarse one's place, over which
  // shares change by no more than over the ball's radius in all: 0.0035 / 0.1, and the mesh's part.
  constexpr double kClose = 0.04;
  for (std::size_t i = 0; i < coarse.vertices_m.size(); ++i) {
    std::size_t nearest = 0;
    for (std::size_t j = 0; j < fine.vertices_m.size(); ++j) {
      if (glm::distance(fine.vertices_m[j], coarse.vertices_m[i]) <
          glm::distance(fine.vertices_m[nearest], coarse.vertices_m[i])) {
        nearest = j;
      }
    }
    for (std::size_t k = 0; k < of_coarse.size(); ++k) {
      EXPECT_NEAR(of_coarse[k][i], of_fine[k][nearest], kClose);
    }
  }
}

TEST(BoneHeat, IsSharedByBonesThatAreAsNear) {
  const TriangleMesh cylinder = Cylinder(12, 20);
  const BoneShape bone = Rod_m(-kHalfLength_m, kHalfLength_m);
  const SkinWeights weights = BoneHeat(cylinder, {bone, bone, Rod_m(1, 1.1)});
  for (std::size_t i = 0; i < cylinder.vertices_m.size(); ++i) {
    EXPECT_NEAR(weights[0][i], 0.5, 1e-12);
    EXPECT_NEAR(weights[1][i], 0.5, 1e-12);
    EXPECT_NEAR(weights[2][i], 0, 1e-12) << "farther from everywhere";
  }
}

TEST(BoneHeat, OfOneBoneIsAllItsOwn) {
  const SkinWeights weights = BoneHeat(Cylinder(12, 20), {Rod_m(0, 0.1)});
  for (const double weight : weights[0]) {
    EXPECT_NEAR(weight, 1, 1e-12);
  }
}

TEST(BoneHeat, ChangesPlacesWithTheBones) {
  const TriangleMesh ball = Ball(0.01);
  std::vector<BoneShape> bones = Askew();
  const SkinWeights weights = BoneHeat(ball, bones);
  std::swap(bones[0], bones[2]);
  const SkinWeights swapped = BoneHeat(ball, bones);
  for (std::size_t i = 0; i < ball.vertices_m.size(); ++i) {
    EXPECT_NEAR(weights[0][i], swapped[2][i], 1e-9);
    EXPECT_NEAR(weights[1][i], swapped[1][i], 1e-9);
  }
}

TEST(BoneHeat, WithoutABoneIsRefused) {
  EXPECT_THROW(static_cast<void>(BoneHeat(Cylinder(12, 20), {})), std::invalid_argument);
}

TEST(BoneHeat, OfAVertexWithoutTriangleIsRefusedWithItsNumber) {
  TriangleMesh cylinder = Cylinder(12, 20);
  cylinder.vertices_m.emplace_back(0, 0, 0.1);
  try {
    static_cast<void>(BoneHeat(cylinder, Halves()));
    FAIL() << "was taken";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "vertex 252 of the surface belongs to no triangle with an area");
  }
}

TEST(BoneHeat, OfAVertexWhoseTrianglesHaveNoAreaIsRefused) {
  TriangleMesh cylinder = Cylinder(12, 20);
  const auto last = static_cast<int>(cylinder.vertices_m.size());
  cylinder.vertices_m.push_back((cylinder.vertices_m[0] + cylinder.vertices_m[1]) / 2.0);
  // Halving is exact: all three lie on one line.
  cylinder.triangles.push_back({0, last, last});
  EXPECT_THROW(static_cast<void>(BoneHeat(cylinder, Halves())), std::invalid_argument);
}

TEST(BoneHeat, PassesATriangleWithoutAreaBetweenOthers) {
  TriangleMesh cylinder = Cylinder(12, 20);
  const SkinWeights weights = BoneHeat(cylinder, Halves());
  cylinder.triangles.push_back({0, 0, 1});
  EXPECT_EQ(BoneHeat(cylinder, Halves()), weights);
}

}  // namespace
}  // namespace girdle::bone_heat_test
