// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The shoulders in a MuJoCo model: their elements, their state, and stepping them.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "anatomy/anatomy.h"
#include "kinematics/assembled_rhythm.h"
#include "names/model_names.h"
#include "simulation/engine.h"
#include "simulation/motion.h"

namespace girdle {

/// Sites whose positions are read: all landmarks, then the child side of SC, AC and GH.
inline constexpr std::size_t kSiteCount = kLandmarkCount + kJointCount;

/// Returns the name of a site's column stem and of the site itself without side: `TS`,
/// `PAC_scapula`.
[[nodiscard]] std::string_view SiteStem(std::size_t site);

/// Ids and addresses of one shoulder's elements.
struct ShoulderElements {
  Side side = Side::kRight;
  Assembly assembly = Assembly::kTree;
  Lead lead = Lead::kClavicle;
  /// Of the plugin; -1 where position servos move the joints.
  int instance = -1;
  std::array<int, kCommandCount> command_controls{};  ///< of a model with the plugin
  std::array<int, kOffsetCount> offset_controls{};    ///< -1 where the model has none
  std::array<int, kRateCount> rate_controls{};        ///< -1 where the model has none
  /// Trims of the plugin's servos, or what the position servos are given; -1 where there is none.
  std::array<int, kCoordinateCount> joint_controls{};
  std::array<int, 3> place_controls{};  ///< of the scapula's place, -1 where it is not driven
  std::array<int, kCoordinateCount> qpos{};
  std::array<int, 3> place_qpos{};          ///< of the scapula's place in a loop
  int connect = -1;                         ///< equality that closes the AC joint of a loop
  std::array<int, kSegmentCount> bodies{};  ///< in the order of Segment
  std::array<int, kSiteCount> sites{};
  std::array<int, kLigamentCount> tendons{};  ///< in the order of LigamentName
  int gliding = -1;                           ///< geom of models with thorax contact
  int sensor = -1;                            ///< address in sensordata, where there is the plugin

  [[nodiscard]] bool has_plugin() const noexcept { return instance >= 0; }
  [[nodiscard]] bool has_thorax_contact() const noexcept { return gliding >= 0; }
};

/// Finds the shoulders by the names of model_names.h, the right one first. Throws InputError that
/// names what is missing; `name` stands in the message for the model.
[[nodiscard]] std::vector<ShoulderElements> FindShoulders(const mjModel& model,
                                                          const std::string& name);

/// The shoulder at one instant, from MuJoCo.
struct ShoulderState {
  double time_s = 0;
  ArmCommand command;
  JointAngles target_rad{};  ///< what the servos aim at, as DrivenCoordinates of the assembly
  JointAngles position_rad{};
  double fastest_rad_per_s = 0;  ///< of all hinges of the model
  double fastest_m_per_s = 0;    ///< of its slides
  /// The plugin used another command: the nearest within the controls' ranges and the rhythm's.
  bool clamped = false;
  double distance_rad = 0;     ///< of the command's direction from measured ones
  double connect_force_N = 0;  ///< with which the AC joint of a loop is held together
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

/// A model with its plugin, or with position servos, ready to step. All its shoulders get the same
/// command; the states are those of one of them. Throws InputError where MuJoCo warns.
class ShoulderSimulation {
 public:
  /// `name` stands in messages for the model. Throws InputError if it lacks an element of a
  /// shoulder or steps too coarsely for the servos.
  ShoulderSimulation(ModelPointer model, std::string name);

  /// Gives position servos, which know no rhythm, the one that they are to follow. Needed before
  /// anything below unless has_plugin(). The rhythm must outlive the simulation.
  void Follow(const AssembledRhythm& rhythm) noexcept { rhythm_ = &rhythm; }

  /// Chooses the shoulder whose states are returned. Throws InputError if the model has no such
  /// side.
  void Watch(Side side);

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

  /// Puts all joints where a keyframe of the model has them, at rest, and derives positions.
  void PutAtKeyframe(int key);

  /// Puts one shoulder's joints into a pose, at rest, and derives positions. In a loop the scapula
  /// is where the clavicle takes it.
  void PutAt(const ShoulderElements& elements, const ShoulderPose& pose);

  /// Returns the pose of one shoulder, as that of a right one, where its bones are.
  [[nodiscard]] ShoulderPose PoseOf(const ShoulderElements& elements) const;

  [[nodiscard]] const mjModel& model() const noexcept { return *model_; }
  /// For MuJoCo's functions that draw, which do not take it as constant.
  [[nodiscard]] mjData& data() noexcept { return *data_; }
  [[nodiscard]] const std::vector<ShoulderElements>& shoulders() const noexcept {
    return shoulders_;
  }
  /// Of the shoulder that is watched.
  [[nodiscard]] const ShoulderElements& elements() const noexcept { return shoulders_[watched_]; }
  [[nodiscard]] bool has_plugin() const noexcept { return shoulders_.front().has_plugin(); }
  /// What position servos are to be given for the last command [rad; of a place m], and the names
  /// of their actuators: the control signal of the same model with position servos.
  [[nodiscard]] std::vector<double> Targets() const;
  [[nodiscard]] std::vector<std::string> TargetNames() const;
  [[nodiscard]] const JointRanges& ranges() const noexcept { return ranges_; }
  [[nodiscard]] double timestep_s() const noexcept { return model_->opt.timestep; }
  [[nodiscard]] const std::string& name() const noexcept { return name_; }

 private:
  void SetCommand(const ArmCommand& command, const CommandRate& rate);
  void SetPluginCommand(const ShoulderElements& elements, const ArmCommand& command,
                        const CommandRate& rate);
  void SetServos(const ShoulderElements& elements);
  void PutAtAngles(const ShoulderElements& elements, const JointAngles& angles_rad);
  void DerivePositions();
  [[nodiscard]] JointAngles TargetsOf(const ShoulderElements& elements) const;
  [[nodiscard]] Vector3 PlaceFor(const ShoulderElements& elements,
                                 const JointAngles& target_rad) const;
  [[nodiscard]] double ConnectForce() const;
  void AddLigaments(ShoulderState& state) const;
  void AddThoraxContact(ShoulderState& state) const;
  [[nodiscard]] bool IsOnThorax(const mjContact& contact) const;
  [[nodiscard]] std::vector<double> PushingTorques() const;
  [[nodiscard]] JointAngles Positions() const;
  /// Everything that MuJoCo derives, with positions as given.
  [[nodiscard]] ShoulderState Derived(double time_s, const ArmCommand& command,
                                      const JointAngles& position_rad) const;
  [[nodiscard]] double FastestJoint(mjtJoint type) const;

  std::string name_;
  ModelPointer model_;
  DataPointer data_;
  std::vector<ShoulderElements> shoulders_;
  std::size_t watched_ = 0;
  JointRanges ranges_;
  JointAngles stiffness_N_m_per_rad_;  ///< of the servos
  const AssembledRhythm* rhythm_ = nullptr;
  /// What position servos were told last, and what of it they follow.
  ArmCommand used_;
  ShoulderPose target_;
};

}  // namespace girdle
