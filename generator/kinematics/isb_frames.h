// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Bone frames from bony landmarks by the definitions of the ISB (Wu et al., J Biomech
/// 2005;38:981-992), and a check for landmarks that no right shoulder has.
///
/// Landmarks are given in any one frame A and in any unit of length. The result is the bone's frame
/// in A. x points forward, y up, z to the right of a right shoulder. If the landmarks lie on a
/// line, the result is not finite.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "kinematics/rotation.h"

namespace girdle {

/// Thorax (ISB 2.3.1). The origin is IJ. y points from the midpoint of PX and T8 to the midpoint of
/// IJ and C7. z is perpendicular to the plane through IJ, C7 and the midpoint of PX and T8, and
/// points to the right.
[[nodiscard]] Quaternion ThoraxFrame(const Vector3& ij, const Vector3& px, const Vector3& c7,
                                     const Vector3& t8) noexcept;

/// Clavicle (ISB 2.3.2). z points from SC to PAC. x is perpendicular to z and to the thorax's y,
/// and points forward. `thorax_y` is in the frame of the landmarks, so all landmarks must be
/// measured in one posture.
[[nodiscard]] Quaternion ClavicleFrame(const Vector3& sc, const Vector3& pac,
                                       const Vector3& thorax_y) noexcept;

/// Scapula (ISB 2.3.3 with PAC instead of AA). z points from TS to PAC. x is perpendicular to the
/// plane AI-PAC-TS and points forward.
[[nodiscard]] Quaternion ScapulaFrame(const Vector3& pac, const Vector3& ts,
                                      const Vector3& ai) noexcept;

/// Humerus (ISB 2.3.4). y points from the midpoint of the epicondyles to GH. x is perpendicular to
/// the plane GH-EM-EL and points forward.
[[nodiscard]] Quaternion HumerusFrame(const Vector3& gh, const Vector3& em,
                                      const Vector3& el) noexcept;

/// Returns the clavicle's long axis, its z: the unit vector from SC to PAC. Landmarks cannot show
/// how the clavicle turns about this axis.
[[nodiscard]] Vector3 ClavicleAxis(const Vector3& sc, const Vector3& pac) noexcept;

/// Returns the distance of `point` from the straight line through `a` and `b`. If these two are
/// equal, it is the distance from `a`.
[[nodiscard]] double DistanceFromLine(const Vector3& point, const Vector3& a,
                                      const Vector3& b) noexcept;

/// Measured landmarks of one bone [m], in any one frame.
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

/// A fault of measured landmarks, and how to correct it.
struct LandmarkFlaw {
  std::string_view
      landmark;         ///< the landmark that is probably wrong, with the abbreviation of the ISB
  std::string message;  ///< for the person who measured: the fault and the fix
  /// True if the landmarks are those of a left shoulder and have no other fault. Their mirror image
  /// is valid.
  bool is_left_shoulder = false;
};

/// Three landmarks that span a plane lie nearly on a line if one of them is off the line through
/// the other two by less than this share of their largest distance. An error of a millimetre then
/// turns the frame by some degrees.
inline constexpr double kNearlyOnALine = 0.05;

/// Returns the reason why landmarks cannot be those of a right shoulder, or nothing if they can.
/// Faults are: three landmarks of a bone nearly on a line; two landmarks with exchanged names (IJ
/// and C7, PX and T8, IJ and PX, C7 and T8, TS and AI, AA and PC); a left shoulder; a single
/// mirrored bone. The humerus alone cannot show that EM and EL are exchanged.
[[nodiscard]] std::optional<LandmarkFlaw> FlawOfRightShoulder(const ThoraxPoints& thorax,
                                                              const ScapulaPoints& scapula,
                                                              const HumerusPoints& humerus);

/// Returns whether the humerus is turned by more than 120 deg about its long axis. It looks so if
/// EM and EL are exchanged. The turn is what remains of `q_TH` after the arm is swung back to
/// hanging by the shortest way. The measured rhythm and its continuation have turns from -96 to 68
/// deg. Straight up the turn has no meaning, and the result is false.
[[nodiscard]] bool IsHumerusTurnedAround(const Quaternion& q_TH) noexcept;

}  // namespace girdle
