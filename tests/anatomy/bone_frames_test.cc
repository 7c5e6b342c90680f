// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "anatomy/bone_frames.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "anatomy/built_in_anatomy.h"
#include "anatomy/posed_bones.h"
#include "kinematics/random_rotations.h"
#include "kinematics/shoulder_pose.h"

namespace girdle::bone_frames_test {
namespace {

constexpr double kRounding = 1e-12;

// Bones hung from each other in a known pose, somewhere in a laboratory.
RC_GTEST_PROP(BoneFramesOf, AreThoseThatPlacedTheLandmarks, ()) {
  const Anatomy anatomy = BuiltInAnatomy();
  const Quaternion q_AT = *UnitQuaternion();
  const Vector3 p_AT_m = *VectorWithin(-2, 2);
  const Quaternion q_TC =
      QuaternionFromEuler(EulerSequence::kYXZ, {*NumberWithin(-1, 1), *NumberWithin(-1, 1), 0});
  const ShoulderPose pose = {q_TC, *UnitQuaternion(), *UnitQuaternion()};
  LandmarkPositions p_A_m;
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    p_A_m[i] = p_AT_m + q_AT * LandmarkInThorax_m(anatomy, pose, static_cast<Landmark>(i));
  }
  const BoneFrames frames = BoneFramesOf(p_A_m);
  RC_ASSERT(AngleBetween(frames.q_AB[0], q_AT) < kRounding);
  RC_ASSERT(AngleBetween(frames.q_AB[1], q_AT * pose.q_TC) < kRounding);
  RC_ASSERT(AngleBetween(frames.q_AB[2], q_AT * pose.q_TS()) < kRounding);
  RC_ASSERT(AngleBetween(frames.q_AB[3], q_AT * pose.q_TH()) < kRounding);
  for (std::size_t i = 0; i < kSegmentCount; ++i) {
    const auto segment = static_cast<Segment>(i);
    RC_ASSERT(AngleBetween(BoneRotation(segment, p_A_m), frames.q_AB[i]) < kRounding);
    const Vector3 origin_m = InThorax_m(anatomy, pose, segment, {0, 0, 0});
    RC_ASSERT(glm::distance(frames.p_AB_m[i], p_AT_m + q_AT * origin_m) < kRounding);
  }
}

}  // namespace
}  // namespace girdle::bone_frames_test
