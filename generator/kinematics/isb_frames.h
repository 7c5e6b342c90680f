// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Bone frames from bony landmarks, by the definitions of the ISB (Wu et al., J Biomech
/// 2005;38:981-992), and what is wrong with landmarks that no right shoulder has.
///
/// Landmarks are given in any one frame A, in any unit of length; the result is the bone's frame in
/// A. x points forward, y up, z to the right of a right shoulder. If landmarks lie on a line the
/// result is not finite.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "kinematics/rotation.h"

namespace girdle {

/// Thorax: y from the middle of PX and T8 to that of IJ and C7, z perpendicular to the plane
/// through IJ, C7 and the middle of PX and T8, to the right (ISB 2.3.1). Its origin is IJ.
[[nodiscard]] Quaternion ThoraxFrame(const Vector3& ij, const Vector3& px, const Vector3& c7,
                                     const Vector3& t8) noexcept;

/// Clavicle: z from SC to PAC, x perpendicular to z and to the thorax's y, forward (ISB 2.3.2). The
/// thorax's y must be known in the same frame, so all must have been measured in one posture.
[[nodiscard]] Quaternion ClavicleFrame(const Vector3& sc, const Vector3& pac,
                                       const Vector3& thorax_y) noexcept;

/// Scapula: z from TS to PAC, x perpendicular to the plane AI-PAC-TS, forward (ISB 2.3.3 with PAC
/// for AA).
[[nodiscard]] Quaternion ScapulaFrame(const Vector3& pac, const Vector3& ts,
                                      const Vector3& ai) noexcept;

/// Humerus: y from the epicondyles' midpoint to GH, x perpendicular to the plane GH-EM-EL, forward
/// (ISB 2.3.4).
[[nodiscard]] Quaternion HumerusFrame(const Vector3& gh, const Vector3& em,
                                      const Vector3& el) noexcept;

/// Clavicle's long axis, unit vector from SC to PAC: its z. Its turn about this axis cannot be told
/// from landmarks.
[[nodiscard]] Vector3 ClavicleAxis(const Vector3& sc, const Vector3& pac) noexcept;

/// Distance of `point` from the straight line through `a` and `b`, from `a` if they are the same.
[[nodiscard]] double DistanceFromLine(const Vector3& point, const Vector3& a,
                                      const Vector3& b) noexcept;

/// Measured landmarks of one bone in any one frame [m].
struct ThoraxPoints {
  Vector3 ij_m{0, 0, 0};
  Vector3 px_m{0, 0, 0};
  Vector3 c7_m{0, 0, 0};
  Vector3 t8_m{0, 0, 0};
  Vector3 sc_m{0, 0, 0};
};
struct ScapulaPoints {
  Vector3 pac_m{0, 0, 0};
  Vector3 ts_m{0, 0, 0};
  Vector3 ai_m{0, 0, 0};
  Vector3 aa_m{0, 0, 0};
  Vector3 pc_m{0, 0, 0};
};
struct HumerusPoints {
  Vector3 gh_m{0, 0, 0};
  Vector3 em_m{0, 0, 0};
  Vector3 el_m{0, 0, 0};
};

/// What is wrong with measured landmarks.
struct LandmarkFlaw {
  std::string_view landmark;  ///< to blame, as the ISB abbreviates it
  std::string message;        ///< for the person who measured: what is wrong, and the fix
  /// Whether nothing is wrong but that it is a left shoulder: mirrored, it would do.
  bool is_left_shoulder = false;
};

/// Three landmarks that span a plane lie nearly on a line if one is less than this share of their
/// largest distance off it: a millimetre of measuring would turn the frame by some degrees.
inline constexpr double kNearlyOnALine = 0.05;

/// Returns what keeps landmarks from being those of a right shoulder, or nothing: three of a bone
/// nearly on a line, two that have each other's names (IJ and C7, PX and T8, IJ and PX, C7 and T8,
/// TS and AI, AA and PC), a left shoulder or a single mirrored bone. EM and EL in each other's
/// place cannot be told from the humerus alone.
[[nodiscard]] std::optional<LandmarkFlaw> FlawOfRightShoulder(const ThoraxPoints& thorax,
                                                              const ScapulaPoints& scapula,
                                                              const HumerusPoints& humerus);

/// Returns whether the humerus is turned by more than 120 deg about its long axis, which is what EM
/// and EL in each other's place look like. The turn is what is left of `q_TH` when the arm is swung
/// back to hanging by the shortest way: -96 to 68 deg wherever the measured rhythm and what
/// continues it take the arm. Straight up the turn has no meaning, and the result is false.
[[nodiscard]] bool IsHumerusTurnedAround(const Quaternion& q_TH) noexcept;

}  // namespace girdle
