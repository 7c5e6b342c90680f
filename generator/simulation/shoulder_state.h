// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The state of a simulated shoulder at one instant.
#pragma once

#include <array>
#include <cstddef>

#include "anatomy/anatomy.h"
#include "kinematics/shoulder_rhythm.h"
#include "simulation/shoulder_elements.h"

namespace girdle {

/// A shoulder at one instant, as MuJoCo computed it.
struct ShoulderState {
  double time_s = 0;
  ArmCommand command;
  JointAngles
      target_rad{};  ///< targets of the servos, in the order of the assembly's DrivenCoordinates
  JointAngles position_rad{};
  double fastest_rad_per_s = 0;  ///< of all hinges of the model
  double fastest_m_per_s = 0;    ///< of its slides
  /// The command that was followed: ShoulderSolution::used for the command within the controls'
  /// ranges, with the axial turn counted from the rhythm's own. The plugin does not report its
  /// offsets. They are those that the rhythm of the simulation allows there.
  ArmCommand used;
  double used_axial_isb_rad = 0;  ///< the axial turn of `used` as ISB's third angle
  bool clamped = false;           ///< `used` differs from the command
  double distance_rad = 0;        ///< from the command's direction to the nearest measured one
  double connect_force_N = 0;     ///< force that closes the AC joint of a loop
  std::array<double, kLigamentCount> ligament_m{};        ///< lengths
  std::array<double, kLigamentCount> ligament_force_N{};  ///< force with which they pull
  /// Force with which the thorax pushes TS or AI, the larger one; 0 without thorax contact.
  double contact_force_N = 0;
  double contact_depth_m = 0;  ///< depth of the deeper of both in the thorax
  /// Difference between coordinates and their targets that constraints cause: torque over
  /// stiffness. Only for models with thorax contact, otherwise 0.
  JointAngles pushed_rad{};
  std::array<Quaternion, kSegmentCount>
      q_WB{};                                ///< thorax, clavicle, scapula, humerus in the world
  std::array<Vector3, kSiteCount> site_m{};  ///< in the world

  [[nodiscard]] const Quaternion& rotation(Segment segment) const noexcept {
    return q_WB[static_cast<std::size_t>(segment)];
  }
  [[nodiscard]] const Vector3& landmark_m(Landmark landmark) const noexcept {
    return site_m[static_cast<std::size_t>(landmark)];
  }
  /// The site on the child bone of joint SC, AC or GH.
  [[nodiscard]] const Vector3& child_site_m(std::size_t joint) const noexcept {
    return site_m[kLandmarkCount + joint];
  }
};

/// Returns the state of the right shoulder that a left shoulder is the mirror image of. The world
/// is mirrored in its x-z plane: y becomes -y.
[[nodiscard]] ShoulderState MirroredToRight(const ShoulderState& left) noexcept;

}  // namespace girdle
