// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// A simulated shoulder at one instant.
#pragma once

#include <array>
#include <cstddef>

#include "anatomy/anatomy.h"
#include "kinematics/shoulder_rhythm.h"
#include "simulation/shoulder_elements.h"

namespace girdle {

/// The shoulder at one instant, from MuJoCo.
struct ShoulderState {
  double time_s = 0;
  ArmCommand command;
  JointAngles target_rad{};  ///< what the servos aim at, as DrivenCoordinates of the assembly
  JointAngles position_rad{};
  double fastest_rad_per_s = 0;  ///< of all hinges of the model
  double fastest_m_per_s = 0;    ///< of its slides
  /// The command that was followed: that of ShoulderSolution::used for the command within the
  /// controls' ranges, its axial turn counted from the rhythm's own. The plugin does not say how
  /// much of an offset that is: it is what the rhythm of the simulation leaves of it there.
  ArmCommand used;
  double used_axial_isb_rad = 0;  ///< its axial turn as ISB's third angle
  bool clamped = false;           ///< another one than the command
  double distance_rad = 0;        ///< of the command's direction from measured ones
  double connect_force_N = 0;     ///< with which the AC joint of a loop is held together
  std::array<double, kLigamentCount> ligament_m{};        ///< lengths
  std::array<double, kLigamentCount> ligament_force_N{};  ///< with which they pull
  /// With which the thorax pushes TS and AI, the larger one; 0 without thorax contact.
  double contact_force_N = 0;
  double contact_depth_m = 0;  ///< of the deeper one in the thorax
  /// How far constraints hold the coordinates off what the servos aim at: torque over stiffness.
  /// Of models with thorax contact, else 0.
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
  /// Site on the child bone of joint SC, AC or GH.
  [[nodiscard]] const Vector3& child_site_m(std::size_t joint) const noexcept {
    return site_m[kLandmarkCount + joint];
  }
};

/// Returns a left shoulder's state as that of the right one that it is the mirror image of, in the
/// world mirrored in x and z.
[[nodiscard]] ShoulderState MirroredToRight(const ShoulderState& left) noexcept;

}  // namespace girdle
