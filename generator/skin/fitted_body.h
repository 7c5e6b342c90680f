// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Bones in a body that has none: each is scaled by itself to fit under the skin.
///
/// The body is not bent to fit the bones: rhythms are angles, lengths are the person's own.
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

/// Where bones lie in a body by MakeHuman, and where it is cut.
struct MakeHumanFit {
  int notch_vertex = 0;            ///< of the skin over IJ
  double notch_skin_m = 0;         ///< how deep IJ lies behind it
  std::string shoulder_joint;      ///< of the body's joints, beside GH
  double shoulder_medially_m = 0;  ///< how far GH lies medially of it
  std::string elbow_joint;         ///< beside the middle of the epicondyles
  double elbow_medially_m = 0;     ///< how far that lies medially of it
  std::string wrist_joint;         ///< a hand's end of the forearm
  double thorax_scale = 1;         ///< times the adult's bone
  double scapula_scale = 1;        ///< times the adult's bone
  double waist_below_notch_m = 0;  ///< where the trunk is cut
  double neck_above_notch_m = 0;   ///< where a head is cut off
};

/// Reads a file like data/makehuman_fit.csv. Throws InputError with file and line for a row that is
/// unknown, missing or repeated, and for a value that cannot be.
[[nodiscard]] MakeHumanFit ReadMakeHumanFit(std::istream& in, const std::string& name);

/// Returns that of data/.
[[nodiscard]] MakeHumanFit BuiltInMakeHumanFit();

enum class Head { kKept, kCut };
/// Words for it, in the order of the enumerators.
inline constexpr std::array<std::string_view, 2> kHeadNames = {"keep", "cut"};
constexpr const auto& WordsOf(Head /*which*/) noexcept { return kHeadNames; }

/// An upper body with bones, and the shares that an artist gave the bones in its skin.
struct FittedBody {
  PosedBody body;
  SkinWeights artist;  ///< of SkinBonesOf({right, left})
};

/// Returns the upper body, arms and hands whole, with bones like those of `adult` in it.
///
/// Thorax and scapula have the fit's scales. The scapula stands in the thorax as in `relaxed`, and
/// with it
///
///     p_TS = p_GH - q_TS GH_S,     |clavicle| = |p_TS - SC|,     |humerus| = |p_GH - elbow|
///
/// The clavicle is turned from `relaxed` by the smallest rotation that points it at PAC; GH is what
/// is left. About its long axis the humerus is turned as `rhythm` turns it at this elevation and
/// plane, and the body's bent forearms are turned with it, by a twist of the distal upper arm: so
/// the skin of the shoulder is not twisted where the rhythm has the arm, and forearms point to
/// where elbows bend. Landmarks are rounded to kLandmarkDecimals of a metre, so that a
/// file of them reads back the same.
///
/// Masses and ellipsoids grow with the bones; ligaments and the gliding ellipsoid are not fitted to
/// them. The notch's height above the floor is the body's. Throws std::invalid_argument if the body
/// lacks a vertex or a joint of the fit.
[[nodiscard]] FittedBody FitBones(const MakeHumanBody& man, const MakeHumanFit& fit,
                                  const Anatomy& adult, const Posture& relaxed,
                                  const ShoulderRhythm& rhythm, Head head);
inline constexpr int kLandmarkDecimals = 6;

}  // namespace girdle
