// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The two ways to assemble the bones in a model, and the coordinates of each.
///
/// Tree: thorax > clavicle > scapula > humerus. Its nine coordinates are those of SC, AC and GH.
///
/// Loop: clavicle and scapula both hang from the thorax, and a constraint closes the AC joint. Its
/// nine driven coordinates are those of SC, of the scapula in the thorax (ST, Y-X'-Z'') and of GH.
/// With the position of PAC in the thorax it has twelve. AC follows from the others.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "kinematics/shoulder_pose.h"

namespace girdle {

enum class Assembly { kTree, kLoop };
inline constexpr std::array<std::string_view, 2> kAssemblyNames = {"tree", "loop"};
constexpr const auto& WordsOf(Assembly /*which*/) noexcept { return kAssemblyNames; }

/// The bone that decides, in a loop, where the AC joint is.
enum class Lead {
  kClavicle,  ///< its angles are driven; the position of the scapula follows
  kScapula,   ///< its position is driven; protraction and elevation of the clavicle follow
};
inline constexpr std::array<std::string_view, 2> kLeadNames = {"clavicle", "scapula"};
constexpr const auto& WordsOf(Lead /*which*/) noexcept { return kLeadNames; }

/// Stems of the names of the scapula's coordinates in the thorax [rad]: internal rotation +, upward
/// rotation -, posterior tilt +.
inline constexpr std::array<std::string_view, 3> kScapulothoracicNames = {
    "st_internal_rotation", "st_upward_rotation", "st_tilt"};
/// Stems of the names of PAC's position in the thorax frame [m]: x, y, and z towards the shoulder's
/// own side.
inline constexpr std::array<std::string_view, 3> kTranslationNames = {"st_anterior", "st_superior",
                                                                      "st_lateral"};

/// Names of the joints that an assembly drives, in the order of its coordinates.
[[nodiscard]] constexpr std::array<std::string_view, kJointCount> DrivenJoints(
    Assembly assembly) noexcept {
  return {kJointNames[0], assembly == Assembly::kTree ? kJointNames[1] : "ST", kJointNames[2]};
}

/// Stems of the names of the nine coordinates that an assembly drives.
[[nodiscard]] constexpr std::array<std::string_view, kCoordinateCount> DrivenCoordinates(
    Assembly assembly) noexcept {
  std::array<std::string_view, kCoordinateCount> names = kCoordinateNames;
  for (std::size_t i = 0; assembly == Assembly::kLoop && i < kScapulothoracicNames.size(); ++i) {
    names[kJointCount + i] = kScapulothoracicNames[i];
  }
  return names;
}

/// Returns the nine angles [rad] of a pose that an assembly drives. Ranges are those of
/// AnglesFromPose.
[[nodiscard]] JointAngles DrivenAngles(Assembly assembly, const ShoulderPose& pose) noexcept;

}  // namespace girdle
