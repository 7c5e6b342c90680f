// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Published shoulder rhythms: the movement of clavicle and scapula as the arm is raised.
///
/// A rhythm is a function of humeral elevation and plane of elevation. It defines the girdle alone.
/// The humerus comes from elsewhere (WithHumerus). To add a rhythm, write its function in
/// published_rhythms.cc and add it to the list there.
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

/// The angles that a rhythm defines. Only results that follow from these angles may be compared
/// with it.
struct DefinedAngles {
  std::array<bool, kGirdleAngleCount> angles{};  ///< in the order of kGirdleAngleNames

  [[nodiscard]] bool Clavicle() const noexcept { return angles[0] && angles[1] && angles[2]; }
  [[nodiscard]] bool Scapula() const noexcept { return angles[3] && angles[4] && angles[5]; }
};

struct PublishedRhythm {
  std::string_view name;
  std::string_view source;
  std::string_view says;  ///< what it defines and what it does not, for people
  DefinedAngles defined;
  /// Total for finite angles [rad]. Nothing is clamped. Angles that the rhythm does not define are
  /// those of the relaxed standing posture.
  std::function<GirdlePose(double elevation_rad, double plane_rad)> girdle;
};

/// Returns the rhythms of the coefficients, in this order:
///
/// - Inman, Saunders and Abbott 1944: the scapula turns upward by a third of the elevation. Only
///   upward rotation is defined.
/// - Braman et al. 2009: the scapula turns upward by 0.301 of the elevation. Only upward rotation
///   is defined.
/// - de Groot and Brand 2001: Y-X'-Z'' angles linear in elevation and plane. The clavicle's axial
///   rotation is not defined, so the scapula in the clavicle is not defined either.
/// - MoBL-ARMS, Saul et al. 2015: clavicle and scapula turn about axes of the resting bones,
///   linearly in elevation. Nothing depends on the plane. It is a model of a whole girdle, so all
///   angles are defined, also that the clavicle does not turn about its own axis.
/// - A frozen girdle: the relaxed standing posture everywhere.
///
/// Throws InputError if the coefficients of one of these are missing.
[[nodiscard]] std::vector<PublishedRhythm> PublishedRhythms(const RhythmCoefficients& coefficients);

/// Returns the three joints of a girdle below a given humerus: q_CS = q_TC^-1 q_TS, q_SH = q_TS^-1
/// q_TH.
[[nodiscard]] ShoulderPose WithHumerus(const GirdlePose& girdle, const Quaternion& q_TH) noexcept;

}  // namespace girdle
