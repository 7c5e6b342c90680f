// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/posed_body.h"

#include <glm/geometric.hpp>

#include "anatomy/posed_bones.h"

namespace girdle {

std::string SkinBone::name() const {
  const std::string_view stem = Name(segment);
  return segment == Segment::kThorax ? std::string(stem) : SidedName(stem, side);
}

std::vector<SkinBone> SkinBonesOf(const std::vector<Side>& sides) {
  std::vector<SkinBone> bones = {{Segment::kThorax, Side::kRight}};
  for (const Side side : sides) {
    for (const Segment segment : {Segment::kClavicle, Segment::kScapula, Segment::kHumerus}) {
      bones.push_back({segment, side});
    }
  }
  return bones;
}

BoneFrame FrameInThorax(const Anatomy& anatomy, const ShoulderPose& pose,
                        const SkinBone& bone) noexcept {
  BoneFrame frame;
  switch (bone.segment) {
    case Segment::kThorax:
      return frame;
    case Segment::kClavicle:
      frame.q_TB = pose.q_TC;
      break;
    case Segment::kScapula:
      frame.q_TB = pose.q_TS();
      break;
    case Segment::kHumerus:
      frame.q_TB = pose.q_TH();
      break;
  }
  frame.p_TB_m = InThorax_m(anatomy, pose, bone.segment, {0, 0, 0});
  return {OnSide(bone.side, frame.q_TB), OnSide(bone.side, frame.p_TB_m)};
}

Vector3 OnSideInThorax_m(const Anatomy& anatomy, const ShoulderPose& pose, Side side,
                         Segment segment, const Vector3& point_m) noexcept {
  return OnSide(side, InThorax_m(anatomy, pose, segment, point_m));
}

Vector3 OnSideInThorax_m(const Anatomy& anatomy, const ShoulderPose& pose, Side side,
                         Landmark landmark) noexcept {
  return OnSide(side, LandmarkInThorax_m(anatomy, pose, landmark));
}

Vector3 AcromionTip_m(const Anatomy& anatomy) noexcept {
  // Length TS to PAC of the scapula for which the tip is given.
  constexpr double kScapulaLength_m = 0.1291;
  const Vector3 tip_m{0, -0.010, 0.019};
  return tip_m * (glm::length(anatomy.landmark_m(Landmark::kTS)) / kScapulaLength_m);
}

}  // namespace girdle
