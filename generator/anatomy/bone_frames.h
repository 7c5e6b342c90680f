// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Bone frames from one shoulder's landmarks, for landmarks of a person, of markers or of a model.
#pragma once

#include <array>

#include "anatomy/anatomy.h"
#include "kinematics/rotation.h"

namespace girdle {

/// Positions of landmarks [m] in one frame A, in the order of Landmark. A function ignores the
/// landmarks that its comment does not name.
using LandmarkPositions = std::array<Vector3, kLandmarkCount>;

/// Returns the rotation q_AB of the ISB frame of one bone of a right shoulder (Wu et al., J Biomech
/// 2005;38:981-992, sections 2.3.1 to 2.3.4). x points forward, y up, z to the right. Each bone
/// needs these landmarks:
///
///     thorax    IJ PX C7 T8
///     clavicle  SC PAC, and for the thorax's y IJ PX C7 T8. Landmarks cannot show its turn about
///               its long axis, so x is perpendicular to the thorax's y.
///     scapula   PAC TS AI (PAC instead of AA, which the ISB uses now)
///     humerus   GH EM EL
///
/// A may be any frame, and positions may have any unit of length. Landmarks of a left shoulder must
/// be mirrored first (side.h). If landmarks of the bone lie on a line, the result is not finite.
[[nodiscard]] Quaternion BoneRotation(Segment segment, const LandmarkPositions& p_A_m) noexcept;

/// Frames of all bones in A, each in the order of Segment.
struct BoneFrames {
  std::array<Quaternion, kSegmentCount> q_AB;  ///< rotations
  std::array<Vector3, kSegmentCount> p_AB_m;   ///< origins: IJ, SC, PAC, GH
};

/// Returns the frames of the four bones, as BoneRotation does. Needs IJ PX C7 T8 SC PAC TS AI GH EM
/// EL.
[[nodiscard]] BoneFrames BoneFramesOf(const LandmarkPositions& p_A_m) noexcept;

}  // namespace girdle
