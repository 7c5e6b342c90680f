// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The three joint rotations of a right shoulder, the nine angles that describe them, and the
/// direction of the arm that follows.
///
/// Frames (ISB; x anterior, y up, z to the right): T thorax, C clavicle, S scapula, H humerus. The
/// y axis of the humerus runs from the elbow up, so a hanging arm points along -y. A left shoulder
/// is the mirror image in the sagittal plane and has the same angles.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "kinematics/rotation.h"

namespace girdle {

inline constexpr std::size_t kJointCount = 3;
inline constexpr std::size_t kCoordinateCount = 9;

/// Names of the nine joint coordinates in turning order: SC (Y-X'-Z''), AC (Y-X'-Z''), GH
/// (X-Z'-Y''). Names of joints and actuators in models (`sc_protraction_r`) and of columns
/// (`sc_protraction_deg`) begin with them.
inline constexpr std::array<std::string_view, kCoordinateCount> kCoordinateNames = {
    "sc_protraction",        // protraction +
    "sc_elevation",          // elevation -, depression +
    "sc_rotation",           // posterior rotation +
    "ac_internal_rotation",  // internal rotation +
    "ac_upward_rotation",    // upward rotation -
    "ac_tilt",               // posterior tilt +
    "gh_elevation",          // elevation -
    "gh_flexion",            // flexion +
    "gh_axial",              // internal rotation +
};

/// Index of the humerus's axial angle among the nine coordinates.
inline constexpr std::size_t kGhAxialIndex = 8;

/// Short names of the joints, in the order of their coordinates.
inline constexpr std::array<std::string_view, kJointCount> kJointNames = {"SC", "AC", "GH"};

/// Euler sequences of SC, AC and GH, in this order.
inline constexpr std::array<EulerSequence, kJointCount> kJointSequences = {
    EulerSequence::kYXZ, EulerSequence::kYXZ, EulerSequence::kXZY};

/// Nine joint angles [rad] in the order of kCoordinateNames.
using JointAngles = std::array<double, kCoordinateCount>;

/// Range of a joint coordinate [rad].
struct CoordinateRange {
  double lower_rad = 0;
  double upper_rad = 0;
};

/// Ranges in the order of kCoordinateNames.
using JointRanges = std::array<CoordinateRange, kCoordinateCount>;

/// Rotations of the sternoclavicular, acromioclavicular and glenohumeral joints.
struct ShoulderPose {
  Quaternion q_TC;  ///< clavicle in thorax
  Quaternion q_CS;  ///< scapula in clavicle
  Quaternion q_SH;  ///< humerus in scapula

  /// Scapula in thorax.
  [[nodiscard]] Quaternion q_TS() const noexcept { return q_TC * q_CS; }
  /// Humerus in thorax.
  [[nodiscard]] Quaternion q_TH() const noexcept { return q_TC * q_CS * q_SH; }
};

/// The direction and turn of the humerus in the thorax: the angles Y-X'-Y'' of q_TH, the second one
/// with its sign reversed.
struct ArmAngles {
  double elevation_rad;  ///< angle between the humerus and hanging down, [0, pi]
  double plane_rad;  ///< 0 frontal, pi/2 sagittal (forward), (-pi, pi]; no meaning at elevation 0
                     ///< and pi
  double axial_rad;  ///< turn about the long axis after plane and elevation, internal +, (-pi, pi]
};

/// Returns the pose of a right shoulder with these nine angles [rad].
[[nodiscard]] ShoulderPose PoseFromAngles(const JointAngles& angles_rad) noexcept;

/// GH's axial angle is given within half a turn of this one [rad]. It is about the middle of what a
/// shoulder does. Behind the body the angle passes -180 deg, and a joint coordinate must not jump
/// there.
inline constexpr double kGhAxialMiddle_rad = -kPi / 4;

/// Returns the nine angles [rad] of a pose. Ranges are those of EulerFromQuaternion, except for
/// GH's axial angle, which is in (-5 pi/4, 3 pi/4].
[[nodiscard]] JointAngles AnglesFromPose(const ShoulderPose& pose) noexcept;

/// Returns the pose of an arm that turns in GH alone: `at` gives the girdle, `pose` gives the
/// humerus in the thorax. q_SH = (q_TC q_CS)^-1 q_TH with q_TC, q_CS of `at` and q_TH of `pose`.
[[nodiscard]] ShoulderPose FrozenGirdle(const ShoulderPose& pose, const ShoulderPose& at) noexcept;

/// Returns the arm angles of the humerus in the thorax. At elevation 0 only the sum of plane and
/// axial is determined, and at pi only their difference. The result is then one pair of angles that
/// gives the rotation.
[[nodiscard]] ArmAngles ArmAnglesFromRotation(const Quaternion& q_TH) noexcept;

}  // namespace girdle
