// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "anatomy/posed_bones.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace girdle {

// p_TC = SC, p_TS = p_TC + q_TC PAC, p_TH = p_TS + q_TS GH.
Vector3 InThorax_m(const Anatomy& anatomy, const ShoulderPose& pose, Segment segment,
                   const Vector3& point_m) noexcept {
  if (segment == Segment::kThorax) {
    return point_m;
  }
  const Vector3& p_TC = anatomy.landmark_m(Landmark::kSC);
  if (segment == Segment::kClavicle) {
    return p_TC + pose.q_TC * point_m;
  }
  const Vector3 p_TS = p_TC + pose.q_TC * anatomy.landmark_m(Landmark::kPAC);
  if (segment == Segment::kScapula) {
    return p_TS + pose.q_TS() * point_m;
  }
  return p_TS + pose.q_TS() * anatomy.landmark_m(Landmark::kGH) + pose.q_TH() * point_m;
}

ShoulderPose PoseOfBones(Side side, const std::array<Quaternion, kSegmentCount>& q_AB) noexcept {
  const auto joint = [&](std::size_t child) {
    return OnSide(side, glm::conjugate(q_AB[child - 1]) * q_AB[child]);
  };
  return {joint(1), joint(2), joint(3)};
}

Vector3 LandmarkInThorax_m(const Anatomy& anatomy, const ShoulderPose& pose,
                           Landmark landmark) noexcept {
  return InThorax_m(anatomy, pose, DefinitionOf(landmark).segment, anatomy.landmark_m(landmark));
}

double LigamentLength_m(const Ligament& ligament, const Anatomy& anatomy,
                        const ShoulderPose& pose) noexcept {
  return glm::distance(InThorax_m(anatomy, pose, Segment::kClavicle, ligament.clavicle_m),
                       InThorax_m(anatomy, pose, Segment::kScapula, ligament.scapula_m));
}

}  // namespace girdle
