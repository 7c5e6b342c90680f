// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The two ways in which a model puts the bones together, and the coordinates that each has.
///
/// Tree: thorax > clavicle > scapula > humerus; the nine coordinates are those of SC, AC and GH.
/// Loop: clavicle and scapula both hang from the thorax and a constraint closes the AC joint; the
/// nine coordinates are those of SC, of the scapula in the thorax (ST, Y-X'-Z'') and of GH, and the
/// place of PAC in the thorax makes twelve. AC follows.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "kinematics/shoulder_pose.h"

namespace girdle {

enum class Assembly { kTree, kLoop };
inline constexpr std::array<std::string_view, 2> kAssemblyNames = {"tree", "loop"};
constexpr const auto& WordsOf(Assembly /*which*/) noexcept { return kAssemblyNames; }

/// Which bone decides, in a loop, where the AC joint is.
enum class Lead {
  kClavicle,  ///< its angles are driven; the scapula's place follows
  kScapula,   ///< its place is driven; the clavicle's protraction and elevation follow
};
inline constexpr std::array<std::string_view, 2> kLeadNames = {"clavicle", "scapula"};
constexpr const auto& WordsOf(Lead /*which*/) noexcept { return kLeadNames; }

/// Stems of the scapula's coordinates on the thorax [rad]: internal rotation +, upward rotation -,
/// posterior tilt +.
inline constexpr std::array<std::string_view, 3> kScapulothoracicNames = {
    "st_internal_rotation", "st_upward_rotation", "st_tilt"};
/// Stems of the place of PAC in the thorax frame [m]: x, y, and z to the shoulder's own side.
inline constexpr std::array<std::string_view, 3> kTranslationNames = {"st_anterior", "st_superior",
                                                                      "st_lateral"};

/// Names of the joints that an assembly drives, in the order of its coordinates.
[[nodiscard]] constexpr std::array<std::string_view, kJointCount> DrivenJoints(
    Assembly assembly) noexcept {
  return {kJointNames[0], assembly == Assembly::kTree ? kJointNames[1] : "ST", kJointNames[2]};
}

/// Stems of the nine coordinates that an assembly drives.
[[nodiscard]] constexpr std::array<std::string_view, kCoordinateCount> DrivenCoordinates(
    Assembly assembly) noexcept {
  std::array<std::string_view, kCoordinateCount> names = kCoordinateNames;
  for (std::size_t i = 0; assembly == Assembly::kLoop && i < kScapulothoracicNames.size(); ++i) {
    names[kJointCount + i] = kScapulothoracicNames[i];
  }
  return names;
}

/// Returns the nine angles [rad] of a pose that an assembly drives; ranges as in AnglesFromPose.
[[nodiscard]] JointAngles DrivenAngles(Assembly assembly, const ShoulderPose& pose) noexcept;

}  // namespace girdle
