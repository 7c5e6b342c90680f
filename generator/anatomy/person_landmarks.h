// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// One person's landmarks as another laboratory digitised them.
#pragma once

#include <istream>
#include <string>
#include <string_view>

#include "anatomy/anatomy.h"
#include "kinematics/shoulder_pose.h"

namespace girdle {

/// Segment of every row of a file whose landmarks stand in one laboratory frame.
inline constexpr std::string_view kLaboratory = "lab";

/// Reads the right shoulder of one person, in the columns of data/landmarks.csv: `landmark`,
/// `segment`, `x_m`, `y_m`, `z_m`. Rows in any order.
///
/// Landmarks stand either each in any one frame of its own segment, or all, digitised in one
/// posture, in one laboratory frame of any position and orientation: then `segment` is `lab` in
/// every row. In segments' frames the origins may be given as further rows: SC of the clavicle, PAC
/// of the scapula, GH of the humerus; without such a row it is 0 0 0 of that frame. `AC` is another
/// name of PAC (ISB's AC is the most dorsal point of the joint).
///
/// Required are IJ PX C7 T8 SC PAC AA TS AI PC EM EL. GH, which cannot be palpated, may be given,
/// be the centre of the sphere through points of the humeral head (rows HH1, HH2 and so on, at
/// least four, in the laboratory's frame), or is estimated (humeral_head.h); Anatomy::gh_origin
/// says how, and how well. ACJ and GC, which the ISB does not know, are taken from `adult` if they
/// are not there: ACJ from PAC and GC from GH, as far as the scapula is large.
///
/// Frames are rebuilt from the landmarks (isb_frames.h) and every landmark is put into that of its
/// segment; one that stands there already, up to rounding, stays bit by bit. Masses, centres of
/// mass and ellipsoids are those of `adult`, grown with the segments (body_size.h); the gliding
/// ellipsoid is not fitted to these bones. The height above the floor grows with the thorax. Joint
/// ranges are those of `adult`.
///
/// Throws InputError with file and line for an unknown, missing or repeated landmark, one in a
/// frame that is not its own, lengths that no person has (zero, millimetres, centimetres),
/// landmarks nearly on a line, under each other's names (landmark_places.h), of two sides, of a
/// left shoulder or mirrored, and points of the humeral head that tell no sphere.
[[nodiscard]] Anatomy ReadPersonAnatomy(std::istream& in, const std::string& name,
                                        const Anatomy& adult);

/// A person as digitised: bones, how they stood, and where the thorax was in the laboratory's frame
/// A.
struct DigitizedPerson {
  Anatomy anatomy;
  ShoulderPose pose;
  Quaternion q_AT{1, 0, 0, 0};
  Vector3 p_AT_m{0, 0, 0};
};

/// Reads a file as ReadPersonAnatomy does, whose landmarks must stand in one laboratory frame, with
/// the posture in which they were digitised. The clavicle's turn about its long axis, which cannot
/// be told from landmarks, is 0. Throws as ReadPersonAnatomy, and for landmarks in segments'
/// frames. `mesh_file`, if any, stands in the same frame: who gave a left person is told to mirror
/// both.
[[nodiscard]] DigitizedPerson ReadDigitizedPerson(std::istream& in, const std::string& name,
                                                  const Anatomy& adult,
                                                  const std::string& mesh_file = "");

}  // namespace girdle
