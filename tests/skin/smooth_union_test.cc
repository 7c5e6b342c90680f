// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/smooth_union.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>
#include <vector>

#include "anatomy/ellipsoid.h"
#include "kinematics/random_rotations.h"

namespace girdle::smooth_union_test {
namespace {

// Places and radii are below a metre.
constexpr double kRounding_m = 1e-12;

double DistanceFromSegment_m(const Vector3& point_m, const Vector3& from_m, const Vector3& to_m) {
  const Vector3 along = to_m - from_m;
  const double t = std::clamp(glm::dot(point_m - from_m, along) / glm::dot(along, along), 0.0, 1.0);
  return glm::length(point_m - (from_m + t * along));
}

double DistanceFromBall_m(const Vector3& point_m, const Vector3& center_m, double radius_m) {
  return glm::length(point_m - center_m) - radius_m;
}

RC_GTEST_PROP(RoundConeDistance, IsThatOfACapsuleForEqualRadii, ()) {
  const Vector3 from_m = *VectorWithin(-0.3, 0.3);
  const Vector3 to_m = from_m + *NumberWithin(0.01, 0.4) * *UnitVector();
  const double radius_m = *NumberWithin(0.001, 0.2);
  const Vector3 point_m = *VectorWithin(-0.5, 0.5);
  const double expected_m = DistanceFromSegment_m(point_m, from_m, to_m) - radius_m;
  RC_ASSERT(std::abs(SignedDistance_m(RoundCone{from_m, radius_m, to_m, radius_m}, point_m) -
                     expected_m) < kRounding_m);
}

RC_GTEST_PROP(RoundConeDistance, IsThatOfTheLargerBallIfTheOtherIsInside, ()) {
  const Vector3 center_m = *VectorWithin(-0.3, 0.3);
  const double radius_m = *NumberWithin(0.05, 0.2);
  // Touching from inside is the last that is still inside.
  const double gap_m = *NumberWithin(0, radius_m);
  const Vector3 inner_m = center_m + gap_m * *UnitVector();
  const double inner_radius_m = *NumberWithin(0, radius_m - gap_m);
  const Vector3 point_m = *VectorWithin(-0.5, 0.5);
  const double expected_m = DistanceFromBall_m(point_m, center_m, radius_m);
  // Outside all of it: a smaller ball within a ball is no nearer to any point.
  RC_PRE(expected_m >= 0);
  const RoundCone cone{center_m, radius_m, inner_m, inner_radius_m};
  const RoundCone turned{inner_m, inner_radius_m, center_m, radius_m};
  RC_ASSERT(std::abs(SignedDistance_m(cone, point_m) - expected_m) < kRounding_m);
  RC_ASSERT(std::abs(SignedDistance_m(turned, point_m) - expected_m) < kRounding_m);
}

TEST(RoundConeDistance, IsThatOfABallWithoutLength) {
  const Vector3 center_m{0.1, -0.2, 0.3};
  const RoundCone ball{center_m, 0.04, center_m, 0.04};
  for (const Vector3 point_m : {Vector3{0.1, -0.2, 0.3}, {0.12, -0.2, 0.3}, {0.3, 0.2, -0.1}}) {
    EXPECT_NEAR(SignedDistance_m(ball, point_m), DistanceFromBall_m(point_m, center_m, 0.04),
                kRounding_m);
  }
}

RC_GTEST_PROP(RoundConeDistance, IsTheLeastOfManyBallsAlongIt, ()) {
  const double length_m = *NumberWithin(0.05, 0.4);
  const Vector3 from_m = *VectorWithin(-0.2, 0.2);
  const Vector3 to_m = from_m + length_m * *UnitVector();
  const double from_radius_m = *NumberWithin(0.005, 0.1);
  const double to_radius_m = *NumberWithin(0.005, 0.1);
  const Vector3 point_m = *VectorWithin(-0.5, 0.5);
  constexpr int kBalls = 4000;
  double least_m = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= kBalls; ++i) {
    const double t = static_cast<double>(i) / kBalls;
    least_m =
        std::min(least_m, DistanceFromBall_m(point_m, from_m + t * (to_m - from_m),
                                             from_radius_m + t * (to_radius_m - from_radius_m)));
  }
  // Balls are half a gap from the nearest one at most, which from the side makes little
  // difference, and on the axis itself all of it, and as much again by their radii.
  const double gap_m = (length_m + std::abs(to_radius_m - from_radius_m)) / kBalls;
  const double cone_m =
      SignedDistance_m(RoundCone{from_m, from_radius_m, to_m, to_radius_m}, point_m);
  RC_ASSERT(cone_m <= least_m + kRounding_m);
  RC_ASSERT(cone_m >= least_m - gap_m);
}

RC_GTEST_PROP(TurnedEllipsoidDistance, IsExactForABallHoweverTurned, ()) {
  const Vector3 center_m = *VectorWithin(-0.3, 0.3);
  const double radius_m = *NumberWithin(0.01, 0.3);
  const Vector3 point_m = *VectorWithin(-0.5, 0.5);
  const TurnedEllipsoid ball{center_m, Vector3(radius_m), *UnitQuaternion()};
  RC_ASSERT(std::abs(SignedDistance_m(ball, point_m) -
                     DistanceFromBall_m(point_m, center_m, radius_m)) < kRounding_m);
}

TEST(TurnedEllipsoidDistance, IsItsRadiusAtTheCentre) {
  const TurnedEllipsoid ball{{0.1, 0.2, 0.3}, {0.05, 0.05, 0.05}};
  EXPECT_NEAR(SignedDistance_m(ball, {0.1, 0.2, 0.3}), -0.05, kRounding_m);
}

RC_GTEST_PROP(TurnedEllipsoidDistance, IsNearlyExactNearTheSurface, ()) {
  // A rib cage's.
  const Vector3 radii_m{0.098, 0.21, 0.155};
  const Vector3 center_m = *VectorWithin(-0.2, 0.2);
  const Quaternion q_AB = *UnitQuaternion();
  const Vector3 direction = *UnitVector();
  const double step_m = *NumberWithin(-0.01, 0.01);
  const Vector3 normal = glm::normalize(direction / radii_m);
  const Vector3 place_m = radii_m * direction + step_m * normal;
  const double distance_m =
      SignedDistance_m(TurnedEllipsoid{center_m, radii_m, q_AB}, center_m + q_AB * place_m);
  // The formula is the first step of Newton's: what it lacks is half the step's square over the
  // least radius of curvature, which is 0.098^2 / 0.21 = 46 mm, with which the step changes again.
  constexpr double kLeastCurvature_m = 0.098 * 0.098 / 0.21;
  RC_ASSERT(std::abs(distance_m - step_m) <= step_m * step_m / kLeastCurvature_m + kRounding_m);
  RC_ASSERT(distance_m * step_m >= -kRounding_m);
}

// A chest, an arm and a shoulder between them.
SmoothUnion Torso() {
  SmoothUnion solids;
  solids.cones = {{{0, 0.1, 0.05}, 0.03, {0, 0.05, 0.2}, 0.04},
                  {{0, 0.05, 0.2}, 0.04, {0.05, -0.25, 0.3}, 0.03}};
  solids.ellipsoids = {{{0, 0, 0}, {0.1, 0.2, 0.15}}};
  return solids;
}

RC_GTEST_PROP(SmoothUnion, OfOneSolidIsThatSolid, ()) {
  SmoothUnion one;
  one.cones = {Torso().cones[0]};
  const Vector3 point_m = *VectorWithin(-0.5, 0.5);
  RC_ASSERT(std::abs(one(point_m) - SignedDistance_m(one.cones[0], point_m)) < kRounding_m);
}

TEST(SmoothUnion, OfNothingHasNoInside) { EXPECT_GT(SmoothUnion()({0, 0, 0}), 0); }

RC_GTEST_PROP(SmoothUnion, DoesNotDependOnTheOrder, ()) {
  const SmoothUnion solids = Torso();
  SmoothUnion turned = solids;
  std::reverse(turned.cones.begin(), turned.cones.end());
  const Vector3 point_m = *VectorWithin(-0.5, 0.5);
  RC_ASSERT(std::abs(solids(point_m) - turned(point_m)) < kRounding_m);
}

TEST(SmoothUnion, IsTheNearestOfSolidsFarApart) {
  SmoothUnion solids;
  solids.cones = {{{-0.5, 0, 0}, 0.1, {-0.5, 0.1, 0}, 0.05},
                  {{0.5, 0, 0}, 0.1, {0.5, 0.1, 0}, 0.05}};
  // The other solid is 40 blends farther than this one.
  const double others_m = solids.blend_m * std::exp(-40.0);
  for (const Vector3 point_m : {Vector3{-0.5, 0.2, 0}, {-0.4, 0, 0.02}, {-0.5, 0.01, 0.01}}) {
    EXPECT_NEAR(solids(point_m), SignedDistance_m(solids.cones[0], point_m),
                others_m + kRounding_m);
  }
}

// -k log(2 exp(-d / k)) = d - k log 2
RC_GTEST_PROP(SmoothUnion, OfASolidWithItselfIsThickerByBlendTimesLogTwo, ()) {
  SmoothUnion twice;
  twice.blend_m = *NumberWithin(0.005, 0.03);
  const RoundCone cone = Torso().cones[1];
  twice.cones = {cone, cone};
  const Vector3 point_m = *VectorWithin(-0.5, 0.5);
  RC_ASSERT(std::abs(twice(point_m) - (SignedDistance_m(cone, point_m) -
                                       twice.blend_m * std::log(2.0))) < kRounding_m);
}

RC_GTEST_PROP(SmoothUnion, IsNowhereThinnerThanItsSolids, ()) {
  const SmoothUnion solids = Torso();
  const Vector3 point_m = *VectorWithin(-0.5, 0.5);
  for (const RoundCone& cone : solids.cones) {
    RC_ASSERT(solids(point_m) <= SignedDistance_m(cone, point_m) + kRounding_m);
  }
  RC_ASSERT(solids(point_m) <= SignedDistance_m(solids.ellipsoids[0], point_m) + kRounding_m);
}

TEST(SmoothUnion, EndsAtACut) {
  SmoothUnion solids = Torso();
  const SmoothUnion whole = solids;
  solids.cuts = {{{0, -0.1, 0}, {0, -1, 0}}};
  const Vector3 beyond_m{0, -0.15, 0};
  // Both the solid's surface and the plane are far enough for the rounding to have faded: each is
  // nearer than the other by 30 mm or more, ten times its size.
  const double faded_m = solids.rounding_m * std::exp(-10.0);
  EXPECT_LT(whole(beyond_m), 0);
  EXPECT_NEAR(solids(beyond_m), 0.05, faded_m) << "the distance from the cut";
  const Vector3 kept_m{0.05, 0.05, 0};
  EXPECT_LT(whole(kept_m), 0);
  EXPECT_NEAR(solids(kept_m), whole(kept_m), faded_m);
}

// A part with its own cut: the cut ends that part alone.
TEST(SmoothUnion, CutsAPartByItself) {
  SmoothUnion arm;
  arm.cones = {{{0, 0, 0.2}, 0.04, {0, -0.4, 0.2}, 0.04}};
  arm.cuts = {{{0, -0.2, 0}, {0, -1, 0}}};
  SmoothUnion solids;
  solids.cones = {{{0, 0, -0.2}, 0.04, {0, -0.4, -0.2}, 0.04}};
  solids.parts = {arm};
  EXPECT_GT(solids({0, -0.3, 0.2}), 0) << "the part";
  EXPECT_LT(solids({0, -0.1, 0.2}), 0) << "what is left of it";
  EXPECT_LT(solids({0, -0.3, -0.2}), 0) << "what it is a part of";
}

RC_GTEST_PROP(SmoothUnion, OfAPartIsThatOfItsSolids, ()) {
  const SmoothUnion solids = Torso();
  SmoothUnion nested = solids;
  nested.cones.pop_back();
  SmoothUnion part;
  part.cones = {solids.cones.back()};
  nested.parts = {part};
  const Vector3 point_m = *VectorWithin(-0.5, 0.5);
  RC_ASSERT(std::abs(nested(point_m) - solids(point_m)) < kRounding_m);
}

RC_GTEST_PROP(SmoothUnion, IsCutByTheFormulaOfItsHeader, ()) {
  SmoothUnion solids = Torso();
  const SmoothUnion whole = solids;
  solids.rounding_m = *NumberWithin(0.002, 0.02);
  solids.cuts = {{*VectorWithin(-0.2, 0.2), *UnitVector()},
                 {*VectorWithin(-0.2, 0.2), *UnitVector()}};
  // Where exponentials of distances over the rounding stay numbers.
  const Vector3 point_m = *VectorWithin(-0.4, 0.4);
  double sum = std::exp(whole(point_m) / solids.rounding_m);
  for (const HalfSpace& cut : solids.cuts) {
    sum += std::exp(glm::dot(point_m - cut.point_m, cut.outward) / solids.rounding_m);
  }
  // The sum may hold a term far larger than the last cut's.
  RC_ASSERT(std::abs(solids(point_m) - solids.rounding_m * std::log(sum)) < 1e-9);
}

TEST(SmoothUnion, LastsFarFromACut) {
  SmoothUnion solids = Torso();
  solids.cuts = {{{0, -0.1, 0}, {0, -1, 0}}};
  // The plain sum of the header's formula would have no number here: exp(5 / 0.003).
  EXPECT_NEAR(solids({0, -5.1, 0}), 5, kRounding_m);
}

// A step of Newton's onto the surface takes the gradient's length for about 1.
TEST(SmoothUnion, GrowsByAboutOneAMeterPerMeterNearItsSurface) {
  const SmoothUnion solids = Torso();
  constexpr double kStep_m = 1e-6;
  // The ellipsoid's own is off by about the distance over its least radius of curvature, 5 of 50
  // mm. In a seam it is a mean of gradients in several directions, and shorter.
  constexpr double kOff = 0.1;
  // By how much the nearest solid must be nearer for the others' part in the mean to have faded.
  const double alone_m = 4 * solids.blend_m;
  int alone = 0;
  int in_seams = 0;
  for (double x = -0.2; x < 0.2; x += 0.013) {
    for (double y = -0.3; y < 0.3; y += 0.013) {
      for (double z = -0.2; z < 0.4; z += 0.013) {
        const Vector3 point_m{x, y, z};
        if (std::abs(solids(point_m)) > 0.005) {
          continue;
        }
        Vector3 gradient{0, 0, 0};
        for (int i = 0; i < 3; ++i) {
          Vector3 step_m{0, 0, 0};
          step_m[i] = kStep_m;
          gradient[i] = (solids(point_m + step_m) - solids(point_m - step_m)) / (2 * kStep_m);
        }
        EXPECT_LT(glm::length(gradient), 1 + kOff) << x << " " << y << " " << z;
        std::vector<double> distances_m = {SignedDistance_m(solids.ellipsoids[0], point_m)};
        for (const RoundCone& cone : solids.cones) {
          distances_m.push_back(SignedDistance_m(cone, point_m));
        }
        std::sort(distances_m.begin(), distances_m.end());
        if (distances_m[1] - distances_m[0] < alone_m) {
          ++in_seams;
          continue;
        }
        EXPECT_GT(glm::length(gradient), 1 - kOff) << x << " " << y << " " << z;
        ++alone;
      }
    }
  }
  EXPECT_GT(alone, 300);
  EXPECT_GT(in_seams, 100);
}

}  // namespace
}  // namespace girdle::smooth_union_test
