// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/posed_body.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <string>
#include <tuple>
#include <vector>

#include "anatomy/body_size.h"
#include "anatomy/built_in_anatomy.h"
#include "anatomy/posed_bones.h"
#include "kinematics/random_rotations.h"
#include "rhythm_tables/built_in_tables.h"

namespace girdle::posed_body_test {
namespace {

constexpr double kRounding_m = 1e-12;

std::vector<std::string> NamesOf(const std::vector<SkinBone>& bones) {
  std::vector<std::string> names;
  names.reserve(bones.size());
  for (const SkinBone& bone : bones) {
    names.push_back(bone.name());
  }
  return names;
}

TEST(SkinBones, OfOneSideAreTheThoraxAndItsShoulder) {
  EXPECT_EQ(NamesOf(SkinBonesOf({Side::kLeft})),
            (std::vector<std::string>{"thorax", "clavicle_l", "scapula_l", "humerus_l"}));
}

TEST(SkinBones, OfBothSidesShareTheThorax) {
  EXPECT_EQ(NamesOf(SkinBonesOf({Side::kRight, Side::kLeft})),
            (std::vector<std::string>{"thorax", "clavicle_r", "scapula_r", "humerus_r",
                                      "clavicle_l", "scapula_l", "humerus_l"}));
}

rc::Gen<ShoulderPose> Poses() {
  return rc::gen::map(
      rc::gen::tuple(UnitQuaternion(), UnitQuaternion(), UnitQuaternion()),
      [](const std::tuple<Quaternion, Quaternion, Quaternion>& joints) {
        return ShoulderPose{std::get<0>(joints), std::get<1>(joints), std::get<2>(joints)};
      });
}

Vector3 InThoraxBy(const BoneFrame& frame, const Vector3& point_m) {
  return frame.p_TB_m + frame.q_TB * point_m;
}

RC_GTEST_PROP(BoneFrame, PutsEveryLandmarkWhereThePoseDoes, ()) {
  const Anatomy anatomy = BuiltInAnatomy();
  const ShoulderPose pose = *Poses();
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    const BoneFrame frame = FrameInThorax(anatomy, pose, {kLandmarks[i].segment, Side::kRight});
    RC_ASSERT(glm::distance(InThoraxBy(frame, anatomy.landmarks_m[i]),
                            LandmarkInThorax_m(anatomy, pose, static_cast<Landmark>(i))) <
              kRounding_m);
  }
}

RC_GTEST_PROP(BoneFrame, OfTheLeftPutsMirroredPointsAtMirroredPlaces, ()) {
  const Anatomy anatomy = BuiltInAnatomy();
  const ShoulderPose pose = *Poses();
  const Vector3 point_m = *VectorWithin(-0.3, 0.3);
  for (const Segment segment : {Segment::kClavicle, Segment::kScapula, Segment::kHumerus}) {
    const BoneFrame right = FrameInThorax(anatomy, pose, {segment, Side::kRight});
    const BoneFrame left = FrameInThorax(anatomy, pose, {segment, Side::kLeft});
    const Vector3 expected_m = Mirrored(InThoraxBy(right, point_m));
    RC_ASSERT(glm::distance(InThoraxBy(left, Mirrored(point_m)), expected_m) < kRounding_m);
    RC_ASSERT(glm::distance(OnSideInThorax_m(anatomy, pose, Side::kLeft, segment, point_m),
                            expected_m) < kRounding_m);
    RC_ASSERT(glm::distance(OnSideInThorax_m(anatomy, pose, Side::kRight, segment, point_m),
                            InThoraxBy(right, point_m)) < kRounding_m);
  }
}

TEST(BoneFrame, OfTheThoraxIsTheThoraxOnEitherSide) {
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const BoneFrame frame = FrameInThorax(BuiltInAnatomy(), BuiltInRhythm().Solve({1, 1}).pose,
                                          {Segment::kThorax, side});
    EXPECT_EQ(frame.p_TB_m, Vector3(0));
    EXPECT_EQ(frame.q_TB, Quaternion(1, 0, 0, 0));
  }
}

TEST(AcromionTip, RoofsTheHeadOfTheHumerus) {
  const Anatomy anatomy = BuiltInAnatomy();
  const ShoulderPose pose = HangingIn(RelaxedStanding(), BuiltInRhythm());
  const Vector3 tip_m = InThorax_m(anatomy, pose, Segment::kScapula, AcromionTip_m(anatomy));
  const Vector3 head_m = LandmarkInThorax_m(anatomy, pose, Landmark::kGH);
  const Vector3 angle_m = LandmarkInThorax_m(anatomy, pose, Landmark::kAA);
  // A head of 22 mm, and the space for the supraspinatus above it.
  EXPECT_GT(tip_m.y, head_m.y + 0.022);
  EXPECT_LT(tip_m.y, head_m.y + 0.045);
  EXPECT_GT(tip_m.x, angle_m.x) << "before the acromion's back corner";
  EXPECT_GT(tip_m.z, LandmarkInThorax_m(anatomy, pose, Landmark::kACJ).z) << "beside the AC joint";
}

// In the scapula's own directions: x forward off its plane, y up, z outward along its spine.
TEST(AcromionTip, IsBesideAndBeforeTheAcJointAndAboveTheHead) {
  const Anatomy anatomy = BuiltInAnatomy();
  const Vector3 tip_m = AcromionTip_m(anatomy);
  const Vector3 joint_m = anatomy.landmark_m(Landmark::kACJ);
  EXPECT_GT(tip_m.z, joint_m.z) << "beside";
  EXPECT_GT(tip_m.x, joint_m.x) << "before";
  EXPECT_GT(tip_m.y, anatomy.landmark_m(Landmark::kGH).y) << "above";
}

// From its back corner to its tip an adult's acromion is some 5 cm long.
TEST(AcromionTip, IsAnAcromionsLengthFromItsAngle) {
  const double length_m =
      glm::distance(AcromionTip_m(BuiltInAnatomy()), BuiltInAnatomy().landmark_m(Landmark::kAA));
  EXPECT_GT(length_m, 0.045);
  EXPECT_LT(length_m, 0.055);
}

TEST(AcromionTip, GrowsWithTheScapula) {
  const Vector3 adult_m = AcromionTip_m(BuiltInAnatomy());
  const double length_m = glm::length(BuiltInAnatomy().landmark_m(Landmark::kTS));
  const Anatomy larger =
      ScaledAnatomy(BuiltInAnatomy(), {.scapula_length_m = 1.2 * length_m, .stature_m = 1.5});
  EXPECT_LT(glm::distance(AcromionTip_m(larger), 1.2 * adult_m), kRounding_m);
}

}  // namespace
}  // namespace girdle::posed_body_test
