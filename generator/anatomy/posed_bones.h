// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Where the points of an anatomy are in a pose: bones hang from each other at SC, PAC and GH.
#pragma once

#include <array>

#include "anatomy/anatomy.h"
#include "kinematics/shoulder_pose.h"
#include "names/model_names.h"

namespace girdle {

/// Returns a point of a segment, given in the segment's frame, in the thorax frame [m].
[[nodiscard]] Vector3 InThorax_m(const Anatomy& anatomy, const ShoulderPose& pose, Segment segment,
                                 const Vector3& point_m) noexcept;

/// Returns the pose of a shoulder whose bones (thorax, clavicle, scapula, humerus) are turned so in
/// any frame A, as that of a right one: a left one is in its mirror image.
[[nodiscard]] ShoulderPose PoseOfBones(Side side,
                                       const std::array<Quaternion, kSegmentCount>& q_AB) noexcept;

/// Returns a landmark in the thorax frame [m].
[[nodiscard]] Vector3 LandmarkInThorax_m(const Anatomy& anatomy, const ShoulderPose& pose,
                                         Landmark landmark) noexcept;

/// Returns the distance [m] of a ligament's attachments: its length as a straight band.
[[nodiscard]] double LigamentLength_m(const Ligament& ligament, const Anatomy& anatomy,
                                      const ShoulderPose& pose) noexcept;

}  // namespace girdle
