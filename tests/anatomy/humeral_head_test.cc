// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "anatomy/humeral_head.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "anatomy/built_in_anatomy.h"
#include "kinematics/random_rotations.h"

namespace girdle::humeral_head_test {
namespace {

constexpr double kRounding_m = 1e-11;

struct Scapula {
  Vector3 pc_m;
  Vector3 ac_m;
  Vector3 aa_m;
  Vector3 ts_m;
  Vector3 ai_m;
};

Scapula BuiltInScapula() {
  const Anatomy anatomy = BuiltInAnatomy();
  return {anatomy.landmark_m(Landmark::kPC),
          {0, 0, 0},
          anatomy.landmark_m(Landmark::kAA),
          anatomy.landmark_m(Landmark::kTS),
          anatomy.landmark_m(Landmark::kAI)};
}

Vector3 Estimate_m(const Scapula& scapula) {
  return EstimatedGh_m(scapula.pc_m, scapula.ac_m, scapula.aa_m, scapula.ts_m, scapula.ai_m);
}

template <typename Place>
Scapula Moved(const Scapula& scapula, const Place& place) {
  return {place(scapula.pc_m), place(scapula.ac_m), place(scapula.aa_m), place(scapula.ts_m),
          place(scapula.ai_m)};
}

// The regression worked out by hand, in a frame where AC is the origin, TS lies 120 mm to the left
// on its axis and AI 120 mm to the left and 110 mm below.
TEST(EstimatedGh, IsThePublishedRegression) {
  const Scapula scapula = {{0.040, -0.030, -0.010},
                           {0, 0, 0},
                           {-0.036, -0.015, -0.020},
                           {0, 0, -0.120},
                           {0, -0.110, -0.120}};
  // PC is (-10, -30, -40) there, AI (-120, -110, 0), AA (-20, -15, 36), TS (-120, 0, 0).
  const double ai_aa = std::sqrt(100. * 100 + 95 * 95 + 36 * 36);
  const double ac_pc = std::sqrt(10. * 10 + 30 * 30 + 40 * 40);
  const double ac_aa = std::sqrt(20. * 20 + 15 * 15 + 36 * 36);
  const double ts_pc = std::sqrt(110. * 110 + 30 * 30 + 40 * 40);
  const double to_the_right_mm =
      18.9743 + 0.2434 * -10 + 0.2341 * -120 + 0.1590 * ai_aa + 0.0558 * -30;
  const double up_mm = -3.8791 - 0.1002 * ac_pc + 0.1732 * -30 - 0.3940 * ac_aa + 0.1205 * -120;
  const double backward_mm = 9.2629 - 0.2403 * -30 + 1.0255 * -40 + 0.1720 * ts_pc;
  EXPECT_LT(
      glm::distance(Estimate_m(scapula), Vector3(-backward_mm, up_mm, to_the_right_mm) / 1000.),
      kRounding_m);
}

RC_GTEST_PROP(EstimatedGh, GoesWithTheScapula, ()) {
  const Quaternion q = *UnitQuaternion();
  const Vector3 shift_m = *VectorWithin(-3, 3);
  const auto place = [&](const Vector3& p_m) { return shift_m + q * p_m; };
  RC_ASSERT(glm::distance(Estimate_m(Moved(BuiltInScapula(), place)),
                          place(Estimate_m(BuiltInScapula()))) < kRounding_m);
}

RC_GTEST_PROP(EstimatedGh, OfALeftScapulaIsTheMirrorImage, ()) {
  const Vector3 normal = *UnitVector();
  const auto mirror = [&](const Vector3& p_m) { return p_m - 2 * glm::dot(p_m, normal) * normal; };
  RC_ASSERT(glm::distance(Estimate_m(Moved(BuiltInScapula(), mirror)),
                          mirror(Estimate_m(BuiltInScapula()))) < kRounding_m);
}

// The regression agrees with GH of the built-in scapula upward and forward, within twice its error,
// but not to the side: there it lies outside, as documents say.
TEST(EstimatedGh, OfTheBuiltInScapulaIsTooFarToTheSide) {
  const Vector3 off_m = Estimate_m(BuiltInScapula()) - BuiltInAnatomy().landmark_m(Landmark::kGH);
  EXPECT_LT(std::abs(off_m.x), 2 * kGhRegressionError_m[2]);
  EXPECT_LT(std::abs(off_m.y), 2 * kGhRegressionError_m[1]);
  constexpr double kDecimal_m = 0.0005;
  EXPECT_NEAR(off_m.z, 0.0143, kDecimal_m);
  EXPECT_NEAR(glm::length(off_m), 0.0148, kDecimal_m);
}

// Points on a sphere, over the half that looks along `q` x.
std::vector<Vector3> PointsOnHead_m(const Vector3& center_m, double radius_m, std::size_t count,
                                    const Quaternion& q) {
  std::vector<Vector3> points_m;
  for (std::size_t i = 0; i < count; ++i) {
    // Turned by the golden angle, which puts no four of the first dozen in a plane.
    const double x = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    const double turn_rad = 2.399963 * static_cast<double>(i);
    const double off = std::sqrt(1 - x * x);
    points_m.push_back(
        center_m + radius_m * (q * Vector3(x, off * std::cos(turn_rad), off * std::sin(turn_rad))));
  }
  return points_m;
}

RC_GTEST_PROP(SphereThrough, IsTheSphereThatThePointsLieOn, ()) {
  const Vector3 center_m = *VectorWithin(-2, 2);
  const double radius_m = *NumberWithin(0.015, 0.03);
  const FittedSphere sphere = SphereThrough(
      PointsOnHead_m(center_m, radius_m, *rc::gen::inRange<std::size_t>(4, 12), *UnitQuaternion()));
  RC_ASSERT(glm::distance(sphere.center_m, center_m) < kRounding_m);
  RC_ASSERT(std::abs(sphere.radius_m - radius_m) < kRounding_m);
  RC_ASSERT(sphere.residual_m < kRounding_m);
}

// Least squares: from where it is, the sphere's centre cannot be moved to lie better.
TEST(SphereThrough, HasTheLeastSumOfSquares) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise_m(0, 0.001);
  std::vector<Vector3> points_m = PointsOnHead_m({0.1, 0.2, 0.3}, 0.024, 9, {1, 0, 0, 0});
  for (Vector3& point_m : points_m)
    point_m += Vector3(noise_m(random), noise_m(random), noise_m(random));
  const FittedSphere sphere = SphereThrough(points_m);
  const auto residual_m = [&](const Vector3& center_m) {
    double mean_m = 0;
    for (const Vector3& p_m : points_m) mean_m += glm::distance(p_m, center_m) / 9;
    double sum_m2 = 0;
    for (const Vector3& p_m : points_m) {
      sum_m2 += std::pow(glm::distance(p_m, center_m) - mean_m, 2) / 9;
    }
    return std::sqrt(sum_m2);
  };
  constexpr double kStep_m = 1e-5;
  EXPECT_NEAR(residual_m(sphere.center_m), sphere.residual_m, 1e-12);
  for (const Vector3 step_m :
       {Vector3{kStep_m, 0, 0}, Vector3{0, kStep_m, 0}, Vector3{0, 0, kStep_m}}) {
    EXPECT_GT(residual_m(sphere.center_m + step_m), sphere.residual_m);
    EXPECT_GT(residual_m(sphere.center_m - step_m), sphere.residual_m);
  }
}

// What is said of the centre's error is what noise does to it.
TEST(SphereThrough, SaysHowFarErrorsMoveTheCenter) {
  constexpr int kTimes = 4000;
  constexpr double kNoise_m = 1e-4;
  std::mt19937 random(11);
  std::normal_distribution<double> noise_m(0, kNoise_m);
  const Vector3 center_m{0, 0, 0};
  const std::vector<Vector3> right_m = PointsOnHead_m(center_m, 0.024, 7, {1, 0, 0, 0});
  double sum_m2 = 0;
  for (int time = 0; time < kTimes; ++time) {
    std::vector<Vector3> points_m = right_m;
    for (Vector3& point_m : points_m) {
      point_m += Vector3(noise_m(random), noise_m(random), noise_m(random));
    }
    sum_m2 += std::pow(glm::length(SphereThrough(points_m).center_m), 2);
  }
  const double shift_m = std::sqrt(sum_m2 / kTimes);
  constexpr double kOfSamples = 0.05;
  EXPECT_NEAR(shift_m / (kNoise_m * SphereThrough(right_m).magnification), 1, kOfSamples);
}

std::string MessageOn(const std::vector<Vector3>& points_m) {
  try {
    static_cast<void>(SphereThrough(points_m));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "(nothing was thrown)";
}

TEST(SphereThrough, RefusesFourPointsInAPlane) {
  const double r_m = 0.02;
  EXPECT_EQ(MessageOn({{r_m, 0, 0.01}, {-r_m, 0, 0.01}, {0, r_m, 0.01}, {0, -r_m, 0.01}}),
            "lie nearly in a plane, 0 mm off it, and tell no sphere. Add points off that plane, "
            "over as much of the humeral head as can be reached");
}

TEST(SphereThrough, RefusesPointsOnALineAndOneSinglePoint) {
  EXPECT_NE(MessageOn({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}), "(nothing was thrown)");
  EXPECT_NE(MessageOn({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}), "(nothing was thrown)");
}

TEST(SphereThrough, RefusesThreePoints) {
  EXPECT_EQ(MessageOn({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}),
            "3 of them tell no sphere. Give at least four");
}

}  // namespace
}  // namespace girdle::humeral_head_test
