// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// One shoulder in a MuJoCo model: its elements, its state, and stepping it.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "kinematics/model_names.h"
#include "kinematics/shoulder_rhythm.h"
#include "simulation/engine.h"
#include "simulation/motion.h"
#include "tables/anatomy.h"

namespace girdle {

/// Sites whose positions are read: all landmarks, then the child side of SC, AC and GH.
inline constexpr std::size_t kSiteCount = kLandmarkCount + kJointCount;

/// Returns the name of a site's column stem and of the site itself without side: `TS`,
/// `PAC_scapula`.
[[nodiscard]] std::string_view SiteStem(std::size_t site);

/// Ids and addresses of one shoulder's elements.
struct ShoulderElements {
  int instance = 0;  ///< of the plugin
  std::array<int, kCommandCount> command_controls{};
  std::array<int, kOffsetCount> offset_controls{};  ///< -1 where the model has none
  std::array<int, kRateCount> rate_controls{};      ///< -1 where the model has none
  std::array<int, kCoordinateCount> trim_controls{};
  std::array<int, kCoordinateCount> qpos{};
  std::array<int, kSegmentCount> bodies{};  ///< in the order of Segment
  std::array<int, kSiteCount> sites{};
  int sensor = 0;  ///< address in sensordata
};

/// Finds the right shoulder by the names of model_names.h. Throws InputError that names what is
/// missing; `name` stands in the message for the model.
[[nodiscard]] ShoulderElements FindShoulder(const mjModel& model, const std::string& name);

/// The shoulder at one instant, from MuJoCo.
struct ShoulderState {
  double time_s = 0;
  ArmCommand command;
  JointAngles target_rad{};  ///< what the plugin aims at
  JointAngles position_rad{};
  /// The plugin used another command: the nearest within the controls' ranges and the rhythm's.
  bool clamped = false;
  double distance_rad = 0;  ///< of the command's direction from measured ones
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

/// A model with its plugin, ready to step. Throws InputError where MuJoCo warns.
class ShoulderSimulation {
 public:
  /// `name` stands in messages for the model. Throws InputError if it lacks an element of the
  /// shoulder or steps too coarsely for the servos.
  ShoulderSimulation(ModelPointer model, std::string name);

  /// Puts the arm at rest where a command asks for it.
  void Start(const ArmCommand& command);

  /// Steps once under a command, and its rate where the model has commands for it. Returns the
  /// state at the step's beginning.
  ShoulderState Step(const ArmCommand& command, const CommandRate& rate = {});

  /// Returns the state as it is, under a command, without moving.
  ShoulderState Observe(const ArmCommand& command);

  /// Puts the joints at the plugin's own targets for a command and returns the state there, at
  /// rest.
  ShoulderState ObserveAtTargets(const ArmCommand& command);

  [[nodiscard]] const mjModel& model() const noexcept { return *model_; }
  [[nodiscard]] const ShoulderElements& elements() const noexcept { return elements_; }
  [[nodiscard]] const JointRanges& ranges() const noexcept { return ranges_; }
  [[nodiscard]] double timestep_s() const noexcept { return model_->opt.timestep; }
  [[nodiscard]] const std::string& name() const noexcept { return name_; }

 private:
  void SetCommand(const ArmCommand& command, const CommandRate& rate);
  [[nodiscard]] JointAngles Positions() const;
  /// Everything that MuJoCo derives, with positions as given.
  [[nodiscard]] ShoulderState Derived(double time_s, const ArmCommand& command,
                                      const JointAngles& position_rad) const;

  std::string name_;
  ModelPointer model_;
  DataPointer data_;
  ShoulderElements elements_;
  JointRanges ranges_;
};

}  // namespace girdle
