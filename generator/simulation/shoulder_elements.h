// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The elements of the shoulders in a MuJoCo model, found by their names.
#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "anatomy/anatomy.h"
#include "kinematics/assembly.h"
#include "names/model_names.h"

namespace girdle {

/// Number of sites whose positions are read: all landmarks, then the child site of SC, AC and GH.
inline constexpr std::size_t kSiteCount = kLandmarkCount + kJointCount;

/// Returns the stem of a site's name and of its columns, without side: `TS`, `PAC_scapula`.
[[nodiscard]] std::string_view SiteStem(std::size_t site);

/// Ids and addresses of one shoulder's elements.
struct ShoulderElements {
  Side side = Side::kRight;
  Assembly assembly = Assembly::kTree;
  Lead lead = Lead::kClavicle;
  /// The plugin's instance; -1 if position servos move the joints.
  int instance = -1;
  std::array<int, kCommandCount> command_controls{};  ///< of a model with the plugin
  std::array<int, kOffsetCount> offset_controls{};    ///< -1 if the model has none
  std::array<int, kRateCount> rate_controls{};        ///< -1 if the model has none
  /// Trims of the plugin's servos, or targets of the position servos; -1 if there is none.
  std::array<int, kCoordinateCount> joint_controls{};
  std::array<int, 3> place_controls{};  ///< of the scapula's position; -1 if it is not driven
  std::array<int, kCoordinateCount> qpos{};
  std::array<int, 3> place_qpos{};          ///< of the scapula's position in a loop
  int connect = -1;                         ///< equality that closes the AC joint of a loop
  std::array<int, kSegmentCount> bodies{};  ///< in the order of Segment
  std::array<int, kSiteCount> sites{};
  std::array<int, kLigamentCount> tendons{};  ///< in the order of LigamentName
  int gliding = -1;                           ///< geom of models with thorax contact
  int sensor = -1;  ///< address in sensordata, if the model has the plugin

  [[nodiscard]] bool has_plugin() const noexcept { return instance >= 0; }
  [[nodiscard]] bool has_thorax_contact() const noexcept { return gliding >= 0; }
};

/// Finds the shoulders by the names of model_names.h, the right one first. Throws InputError that
/// names what is missing. `name` is the model's name in the message.
[[nodiscard]] std::vector<ShoulderElements> FindShoulders(const mjModel& model,
                                                          const std::string& name);

}  // namespace girdle
