// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Reads one person's landmarks as a laboratory digitised them.
#pragma once

#include <istream>
#include <string>
#include <string_view>

#include "anatomy/anatomy.h"
#include "kinematics/shoulder_pose.h"

namespace girdle {

/// The word in column `segment` of every row if all landmarks are in one laboratory frame.
inline constexpr std::string_view kLaboratory = "lab";

/// Reads the right shoulder of one person from a file with the columns of data/landmarks.csv:
/// `landmark`, `segment`, `x_m`, `y_m`, `z_m`. Rows may have any order.
///
/// Frames: there are two kinds of files. In the first, each landmark is in a frame of its own
/// segment; any frame will do. Further rows may give the origins there: SC of the clavicle, PAC of
/// the scapula, GH of the humerus. An origin without such a row is 0 0 0. In the second kind all
/// landmarks are digitised in one posture in one laboratory frame of any position and orientation;
/// `segment` is then `lab` in every row.
///
/// Landmarks: IJ PX C7 T8 SC PAC AA TS AI PC EM EL are required. `AC` is another name of PAC (ISB's
/// AC is the most dorsal point of the joint). GH cannot be palpated. It may be given. It may be the
/// centre of the sphere through at least four points of the humeral head (rows HH1, HH2 and so on,
/// in the laboratory's frame). Otherwise it is estimated (humeral_head.h). Anatomy::gh_origin says
/// how GH was found and how precisely. The ISB does not define ACJ and GC. If they are absent, they
/// are taken from `adult`, scaled with the scapula: ACJ relative to PAC and GC relative to GH.
///
/// Result: frames are rebuilt from the landmarks (isb_frames.h), and every landmark is expressed in
/// the frame of its segment. If it is in that frame already, up to rounding, its bits do not
/// change. Masses, centres of mass and ellipsoids are those of `adult`, scaled with the segments
/// (body_size.h). The gliding ellipsoid is not fitted to these bones. The height above the floor is
/// scaled with the thorax. Joint ranges are those of `adult`.
///
/// Throws InputError with file and line for: an unknown, missing or repeated landmark; a landmark
/// in the frame of another segment; lengths that no person has (zero, millimetres, centimetres);
/// landmarks nearly on a line; exchanged names (landmark_places.h); landmarks of two sides, of a
/// left shoulder or mirrored; points of the humeral head that determine no sphere.
[[nodiscard]] Anatomy ReadPersonAnatomy(std::istream& in, const std::string& name,
                                        const Anatomy& adult);

/// A digitised person: the bones, their posture, and the thorax in the laboratory's frame A.
struct DigitizedPerson {
  Anatomy anatomy;
  ShoulderPose pose;
  Quaternion q_AT{1, 0, 0, 0};
  Vector3 p_AT_m{0, 0, 0};
};

/// Reads a file as ReadPersonAnatomy does, and the posture in which the landmarks were digitised.
/// The landmarks must be in one laboratory frame. Landmarks cannot show the clavicle's turn about
/// its long axis, so it is 0. Throws like ReadPersonAnatomy, and also for landmarks in frames of
/// segments. `mesh_file`, if any, is in the same frame: the message about a left shoulder says to
/// mirror both files.
[[nodiscard]] DigitizedPerson ReadDigitizedPerson(std::istream& in, const std::string& name,
                                                  const Anatomy& adult,
                                                  const std::string& mesh_file = "");

}  // namespace girdle
