// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Puts bones into a body that has none. Each bone is scaled alone to fit under the skin.
///
/// The body is not deformed to fit the bones: rhythms are angles, and lengths are the person's own.
#pragma once

#include <array>
#include <istream>
#include <string>
#include <string_view>

#include "anatomy/postures.h"
#include "kinematics/shoulder_rhythm.h"
#include "skin/cut_surface.h"
#include "skin/makehuman_body.h"
#include "skin/posed_body.h"

namespace girdle {

/// The positions of bones in a MakeHuman body, and where the body is cut.
struct MakeHumanFit {
  int notch_vertex = 0;            ///< vertex of the skin over IJ
  double notch_skin_m = 0;         ///< depth of IJ behind this vertex
  std::string shoulder_joint;      ///< joint of the body near GH
  double shoulder_medially_m = 0;  ///< distance of GH from this joint, medially
  std::string elbow_joint;         ///< joint of the body near the midpoint of the epicondyles
  double elbow_medially_m = 0;     ///< distance of that midpoint from this joint, medially
  std::string wrist_joint;         ///< joint of the body at the hand's end of the forearm
  double thorax_scale = 1;         ///< size relative to the adult's bone
  double scapula_scale = 1;        ///< size relative to the adult's bone
  double waist_below_notch_m = 0;  ///< place of the cut through the trunk
  double neck_above_notch_m = 0;   ///< place of the cut through the neck, if the head is cut off
};

/// Reads a file like data/makehuman_fit.csv. Throws InputError with file and line if a row is
/// unknown, missing or repeated, or if a value is invalid.
[[nodiscard]] MakeHumanFit ReadMakeHumanFit(std::istream& in, const std::string& name);

/// Returns the fit of data/.
[[nodiscard]] MakeHumanFit BuiltInMakeHumanFit();

enum class Head { kKept, kCut };
/// Words for the enumerators, in their order.
inline constexpr std::array<std::string_view, 2> kHeadNames = {"keep", "cut"};
constexpr const auto& WordsOf(Head /*which*/) noexcept { return kHeadNames; }

/// An upper body with bones, and the shares of the bones in its skin that an artist made.
struct FittedBody {
  PosedBody body;
  SkinWeights artist;  ///< of SkinBonesOf({right, left})
};

/// Returns the upper body with arms and hands, and with bones like those of `adult` in it.
///
/// Thorax and scapula are scaled by the fit. The scapula has the rotation in the thorax that it has
/// in `relaxed`. The other bones follow:
///
///     p_TS = p_GH - q_TS GH_S,     |clavicle| = |p_TS - SC|,     |humerus| = |p_GH - elbow|
///
/// The clavicle is turned from `relaxed` by the smallest rotation that points it at PAC. GH closes
/// the chain. The humerus is turned about its long axis as `rhythm` turns it at this elevation and
/// plane. The body's bent forearms are turned with it, by a twist of the distal upper arm. So the
/// skin of the shoulder is not twisted where the rhythm has the arm, and forearms point to where
/// elbows bend. Landmarks are rounded to kLandmarkDecimals of a metre, so a file of them reads back
/// equal.
///
/// Masses and ellipsoids are scaled with the bones. Ligaments and the gliding ellipsoid are not
/// fitted to them. The height of the notch above the floor is the body's. Throws
/// std::invalid_argument if the body lacks a vertex or a joint of the fit.
[[nodiscard]] FittedBody FitBones(const MakeHumanBody& man, const MakeHumanFit& fit,
                                  const Anatomy& adult, const Posture& relaxed,
                                  const ShoulderRhythm& rhythm, Head head);
inline constexpr int kLandmarkDecimals = 6;

}  // namespace girdle
