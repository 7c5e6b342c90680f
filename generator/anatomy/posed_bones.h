// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Positions of an anatomy's points in a pose. The bones hang from each other at SC, PAC and GH.
#pragma once

#include <array>

#include "anatomy/anatomy.h"
#include "kinematics/shoulder_pose.h"
#include "names/model_names.h"

namespace girdle {

/// Returns a point [m] in the thorax frame. `point_m` is in the frame of `segment`.
[[nodiscard]] Vector3 InThorax_m(const Anatomy& anatomy, const ShoulderPose& pose, Segment segment,
                                 const Vector3& point_m) noexcept;

/// Returns the pose of a shoulder from the rotations of its bones (thorax, clavicle, scapula,
/// humerus) in any frame A. The pose of a left shoulder is that of its mirror image, a right
/// shoulder.
[[nodiscard]] ShoulderPose PoseOfBones(Side side,
                                       const std::array<Quaternion, kSegmentCount>& q_AB) noexcept;

/// Returns a landmark in the thorax frame [m].
[[nodiscard]] Vector3 LandmarkInThorax_m(const Anatomy& anatomy, const ShoulderPose& pose,
                                         Landmark landmark) noexcept;

/// Returns the length [m] of a ligament as a straight band: the distance of its attachments.
[[nodiscard]] double LigamentLength_m(const Ligament& ligament, const Anatomy& anatomy,
                                      const ShoulderPose& pose) noexcept;

}  // namespace girdle
