// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Published shoulder rhythms: where clavicle and scapula go as the arm is raised.
///
/// A rhythm is a function of humeral elevation and plane of elevation. It knows the girdle alone;
/// where the humerus is comes from elsewhere (WithHumerus). To add one, write its function in
/// published_rhythms.cc and put it into the list there.
#pragma once

#include <array>
#include <functional>
#include <string_view>
#include <vector>

#include "kinematics/shoulder_pose.h"
#include "rhythms/rhythm_coefficients.h"

namespace girdle {

/// Clavicle and scapula, both in the thorax.
struct GirdlePose {
  Quaternion q_TC;
  Quaternion q_TS;
};

/// What a rhythm says. Nothing that rests on anything else may be held against it.
struct SaidAngles {
  std::array<bool, kGirdleAngleCount> angles{};  ///< in the order of kGirdleAngleNames

  [[nodiscard]] bool Clavicle() const noexcept { return angles[0] && angles[1] && angles[2]; }
  [[nodiscard]] bool Scapula() const noexcept { return angles[3] && angles[4] && angles[5]; }
};

struct PublishedRhythm {
  std::string_view name;
  std::string_view source;
  std::string_view says;  ///< what it says and what it does not, for people
  SaidAngles said;
  /// Total for finite angles [rad]; nothing is clamped. Angles that are not said are those of the
  /// relaxed standing posture.
  std::function<GirdlePose(double elevation_rad, double plane_rad)> girdle;
};

/// Returns the rhythms of the coefficients, in this order:
///
/// - Inman, Saunders and Abbott 1944: the scapula turns upward by a third of the elevation. Only
///   upward rotation is said.
/// - Braman et al. 2009: the same with 0.301.
/// - de Groot and Brand 2001: Y-X'-Z'' angles linear in elevation and plane. The clavicle's axial
///   rotation is not said, so neither is the scapula in the clavicle.
/// - MoBL-ARMS, Saul et al. 2015: clavicle and scapula turn about axes of the resting bones,
///   linearly in elevation; nothing depends on the plane. A model of a whole girdle: all is said,
///   also that the clavicle does not turn about its own axis.
/// - A frozen girdle: the relaxed standing posture throughout.
///
/// Throws InputError if the coefficients lack one of these.
[[nodiscard]] std::vector<PublishedRhythm> PublishedRhythms(const RhythmCoefficients& coefficients);

/// Returns the three joints of a girdle under a humerus that is where it is:
/// q_CS = q_TC^-1 q_TS, q_SH = q_TS^-1 q_TH.
[[nodiscard]] ShoulderPose WithHumerus(const GirdlePose& girdle, const Quaternion& q_TH) noexcept;

}  // namespace girdle
