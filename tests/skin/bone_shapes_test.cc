// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/bone_shapes.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>
#include <vector>

#include "anatomy/body_size.h"
#include "anatomy/built_in_anatomy.h"
#include "kinematics/random_rotations.h"
#include "rhythm_tables/built_in_tables.h"

namespace girdle::bone_shapes_test {
namespace {

constexpr double kRounding_m = 1e-12;

TEST(DistanceFromAShape, IsThatOfARodsSideAndOfItsRoundEnds) {
  const BoneShape rod{{{{0, 0, 0}, {0.3, 0, 0}, 0.02}}, {}};
  EXPECT_NEAR(DistanceFrom_m(rod, {0.1, 0.03, 0.04}), 0.03, kRounding_m) << "beside";
  EXPECT_NEAR(DistanceFrom_m(rod, {0.36, 0.08, 0}), 0.08, kRounding_m) << "beyond its end";
  EXPECT_NEAR(DistanceFrom_m(rod, {-0.05, 0, 0}), 0.03, kRounding_m) << "before its start";
}

TEST(DistanceFromAShape, IsThatOfABallForARodWithoutLength) {
  const BoneShape ball{{{{0.1, 0, 0}, {0.1, 0, 0}, 0.02}}, {}};
  EXPECT_NEAR(DistanceFrom_m(ball, {0.1, 0.03, 0.04}), 0.03, kRounding_m);
}

TEST(DistanceFromAShape, IsThatOfAnEllipsoid) {
  const BoneShape ellipsoid{{}, {{{0.1, 0, 0}, {0.1, 0.2, 0.3}}}};
  EXPECT_NEAR(DistanceFrom_m(ellipsoid, {0.25, 0, 0}), 0.05, kRounding_m);
  EXPECT_NEAR(DistanceFrom_m(ellipsoid, {0.1, -0.21, 0}), 0.01, kRounding_m);
}

TEST(DistanceFromAShape, IsNothingInside) {
  EXPECT_EQ(DistanceFrom_m({{{{0, 0, 0}, {0.3, 0, 0}, 0.02}}, {}}, {0.1, 0.01, 0}), 0);
  EXPECT_EQ(DistanceFrom_m({{}, {{{0, 0, 0}, {0.1, 0.2, 0.3}}}}, {0, 0.1, 0}), 0);
}

TEST(DistanceFromAShape, IsThatOfTheNearestSolid) {
  const BoneShape shape{{{{0, 0, 0}, {0, 0, 0}, 0.1}, {{1, 0, 0}, {1, 0, 0}, 0.1}},
                        {{{0, 1, 0}, {0.1, 0.1, 0.1}}}};
  EXPECT_NEAR(DistanceFrom_m(shape, {-0.2, 0, 0}), 0.1, kRounding_m);
  EXPECT_NEAR(DistanceFrom_m(shape, {1.3, 0, 0}), 0.2, kRounding_m);
  EXPECT_NEAR(DistanceFrom_m(shape, {0, 1.4, 0}), 0.3, kRounding_m);
}

TEST(DistanceFromAShape, IsEndlessFromNothing) {
  EXPECT_EQ(DistanceFrom_m({}, {0, 0, 0}), std::numeric_limits<double>::infinity());
}

PosedBody StandingBody(const Anatomy& anatomy = BuiltInAnatomy()) {
  return {{}, anatomy, BuiltInRhythm().Solve({RadiansFromDegrees(45), 0}).pose};
}

const std::vector<Side> kBoth = {Side::kRight, Side::kLeft};

// A landmark where it is on one side.
Vector3 Place_m(const PosedBody& body, Landmark landmark, Side side) {
  return OnSideInThorax_m(body.anatomy, body.pose, side,
                          kLandmarks[static_cast<std::size_t>(landmark)].segment,
                          body.anatomy.landmark_m(landmark));
}

// Points around a shoulder, thorax frame.
rc::Gen<Vector3> PointsAround() { return VectorWithin(-0.4, 0.4); }

class BoneShapesOfABody : public testing::Test {
 protected:
  PosedBody body_ = StandingBody();
  std::vector<BoneShape> shapes_ = BoneShapesOf(body_, SkinBonesOf(kBoth));
};

TEST_F(BoneShapesOfABody, AreOneForEachBone) { EXPECT_EQ(shapes_.size(), 7U); }

TEST_F(BoneShapesOfABody, HoldTheirLandmarks) {
  for (const Side side : kBoth) {
    const std::size_t first = side == Side::kRight ? 1 : 4;
    for (const Landmark landmark : {Landmark::kSC, Landmark::kACJ}) {
      EXPECT_LT(DistanceFrom_m(shapes_[first], Place_m(body_, landmark, side)), kRounding_m);
    }
    for (const Landmark landmark : {Landmark::kACJ, Landmark::kAA, Landmark::kTS, Landmark::kAI,
                                    Landmark::kGC, Landmark::kPC}) {
      EXPECT_LT(DistanceFrom_m(shapes_[first + 1], Place_m(body_, landmark, side)), kRounding_m)
          << static_cast<int>(landmark);
    }
    EXPECT_LT(DistanceFrom_m(shapes_[first + 2], Place_m(body_, Landmark::kGH, side)), kRounding_m);
    const Vector3 elbow_m =
        (Place_m(body_, Landmark::kEM, side) + Place_m(body_, Landmark::kEL, side)) / 2.0;
    EXPECT_LT(DistanceFrom_m(shapes_[first + 2], elbow_m), kRounding_m);
  }
  for (const Landmark landmark : {Landmark::kIJ, Landmark::kPX, Landmark::kC7, Landmark::kT8}) {
    EXPECT_LT(DistanceFrom_m(shapes_[0], InMedianPlane(body_.anatomy.landmark_m(landmark))),
              kRounding_m);
  }
}

TEST_F(BoneShapesOfABody, RunBetweenTheirLandmarks) {
  const auto between = [&](Landmark a, Landmark b) {
    return (Place_m(body_, a, Side::kRight) + Place_m(body_, b, Side::kRight)) / 2.0;
  };
  EXPECT_LT(DistanceFrom_m(shapes_[1], between(Landmark::kSC, Landmark::kACJ)), kRounding_m);
  for (const auto& [a, b] :
       {std::pair(Landmark::kTS, Landmark::kAA), std::pair(Landmark::kTS, Landmark::kAI),
        std::pair(Landmark::kGC, Landmark::kPC)}) {
    EXPECT_LT(DistanceFrom_m(shapes_[2], between(a, b)), kRounding_m) << static_cast<int>(b);
  }
  for (const auto& [a, b] :
       {std::pair(Landmark::kIJ, Landmark::kPX), std::pair(Landmark::kC7, Landmark::kT8)}) {
    EXPECT_LT(DistanceFrom_m(shapes_[0], InMedianPlane(between(a, b))), kRounding_m)
        << static_cast<int>(b);
  }
  const Vector3 shaft_m = OnSideInThorax_m(body_.anatomy, body_.pose, Side::kRight,
                                           Segment::kHumerus, body_.anatomy.elbow_m() / 2.0);
  EXPECT_LT(DistanceFrom_m(shapes_[3], shaft_m), kRounding_m);
}

TEST_F(BoneShapesOfABody, ReachNoFartherThanTheirBones) {
  // A bone's landmark is no part of another bone's shape unless they meet there.
  const Vector3 inferior_m = Place_m(body_, Landmark::kAI, Side::kRight);
  EXPECT_GT(DistanceFrom_m(shapes_[1], inferior_m), 0.05) << "clavicle";
  EXPECT_GT(DistanceFrom_m(shapes_[3], inferior_m), 0.05) << "humerus";
  const Vector3 elbow_m = Place_m(body_, Landmark::kEL, Side::kRight);
  EXPECT_GT(DistanceFrom_m(shapes_[0], elbow_m), 0.05) << "thorax";
  EXPECT_GT(DistanceFrom_m(shapes_[2], elbow_m), 0.05) << "scapula";
}

RC_GTEST_FIXTURE_PROP(BoneShapesOfABody, OfTheLeftAreTheMirrorImage, ()) {
  const Vector3 point_m = *PointsAround();
  for (std::size_t bone = 1; bone <= 3; ++bone) {
    RC_ASSERT(std::abs(DistanceFrom_m(shapes_[bone + 3], Mirrored(point_m)) -
                       DistanceFrom_m(shapes_[bone], point_m)) < kRounding_m);
  }
  RC_ASSERT(std::abs(DistanceFrom_m(shapes_[0], Mirrored(point_m)) -
                     DistanceFrom_m(shapes_[0], point_m)) < kRounding_m);
}

RC_GTEST_FIXTURE_PROP(BoneShapesOfABody, OfASideWithoutShoulderBelongToTheThorax, ()) {
  const Side side = *rc::gen::elementOf(kBoth);
  const std::vector<BoneShape> one_side = BoneShapesOf(body_, SkinBonesOf({side}));
  RC_ASSERT(one_side.size() == 4U);
  const std::size_t own = side == Side::kRight ? 1 : 4;
  const std::size_t other = side == Side::kRight ? 4 : 1;
  const Vector3 point_m = *PointsAround();
  double thorax_m = DistanceFrom_m(shapes_[0], point_m);
  for (std::size_t bone = 0; bone < 3; ++bone) {
    RC_ASSERT(std::abs(DistanceFrom_m(one_side[bone + 1], point_m) -
                       DistanceFrom_m(shapes_[own + bone], point_m)) < kRounding_m);
    thorax_m = std::min(thorax_m, DistanceFrom_m(shapes_[other + bone], point_m));
  }
  RC_ASSERT(std::abs(DistanceFrom_m(one_side[0], point_m) - thorax_m) < kRounding_m);
}

RC_GTEST_FIXTURE_PROP(BoneShapesOfABody, GrowWithThePerson, ()) {
  const double size = *NumberWithin(0.5, 1.5);
  const PosedBody larger =
      StandingBody(ScaledAnatomy(BuiltInAnatomy(), {.stature_m = size * kAdultStature_m}));
  const std::vector<BoneShape> grown = BoneShapesOf(larger, SkinBonesOf(kBoth));
  const Vector3 point_m = *PointsAround();
  for (std::size_t bone = 0; bone < grown.size(); ++bone) {
    // Scales are quotients of lengths.
    RC_ASSERT(std::abs(DistanceFrom_m(grown[bone], size * point_m) -
                       size * DistanceFrom_m(shapes_[bone], point_m)) < 1e-9);
  }
}

}  // namespace
}  // namespace girdle::bone_shapes_test
