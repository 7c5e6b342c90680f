// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// From one shoulder's landmarks to the frames of its bones: for every reader of landmarks, whether
/// they come from a person, from markers or from a model.
#pragma once

#include <array>

#include "anatomy/anatomy.h"
#include "kinematics/rotation.h"

namespace girdle {

/// Positions of landmarks [m] in one frame A, in the order of Landmark. Those that a function does
/// not name may be anything.
using LandmarkPositions = std::array<Vector3, kLandmarkCount>;

/// Returns the rotation q_AB of the ISB frame of one bone of a right shoulder (Wu et al., J Biomech
/// 2005;38:981-992, sections 2.3.1 to 2.3.4). x points forward, y up, z to the right. What each
/// bone needs:
///
///     thorax    IJ PX C7 T8
///     clavicle  SC PAC, and for the thorax's y IJ PX C7 T8. Its turn about its long axis cannot be
///               told from landmarks: x is perpendicular to the thorax's y.
///     scapula   PAC TS AI (PAC where the ISB now has AA)
///     humerus   GH EM EL
///
/// A may lie anywhere; positions may be in any unit of length. A left shoulder's landmarks are to
/// be mirrored before (side.h). The result is not finite if landmarks of the bone lie on a line.
[[nodiscard]] Quaternion BoneRotation(Segment segment, const LandmarkPositions& p_A_m) noexcept;

/// Frames of all bones in A, each in the order of Segment.
struct BoneFrames {
  std::array<Quaternion, kSegmentCount> q_AB;  ///< rotations
  std::array<Vector3, kSegmentCount> p_AB_m;   ///< origins: IJ, SC, PAC, GH
};

/// Returns the frames of the four bones, as BoneRotation, from IJ PX C7 T8 SC PAC TS AI GH EM EL.
[[nodiscard]] BoneFrames BoneFramesOf(const LandmarkPositions& p_A_m) noexcept;

}  // namespace girdle
