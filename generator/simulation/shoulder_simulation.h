// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Stepping the shoulders of a MuJoCo model.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "kinematics/assembled_rhythm.h"
#include "motions/motion.h"
#include "simulation/engine.h"
#include "simulation/loaded_shoulders.h"
#include "simulation/shoulder_elements.h"
#include "simulation/shoulder_state.h"

namespace girdle {

/// A model with its plugin, or with position servos, ready to step. All its shoulders get the same
/// command; the states are those of one of them. Throws InputError where MuJoCo warns.
class ShoulderSimulation {
 public:
  /// `rhythm` is what position servos, which know none, are told to follow. A plugin has its own,
  /// and does not look at it.
  ShoulderSimulation(LoadedShoulders shoulders, AssembledRhythm rhythm);
  /// With OwnRhythm.
  explicit ShoulderSimulation(LoadedShoulders shoulders);
  ShoulderSimulation(ModelPointer model, std::string name)
      : ShoulderSimulation(LoadedShoulders(std::move(model), std::move(name))) {}

  /// Chooses the shoulder whose states are returned. Throws InputError if the model has no such
  /// side.
  void Watch(Side side) { loaded_.Watch(side); }

  /// Returns a command with its axial turn counted from what the model's own command is counted
  /// from. Position servos have no such command: it stays as it is.
  [[nodiscard]] ArmCommand AsModelCounts(const ArmCommand& command) const;

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

  [[nodiscard]] const LoadedShoulders& loaded() const noexcept { return loaded_; }
  [[nodiscard]] const AssembledRhythm& rhythm() const noexcept { return rhythm_; }
  [[nodiscard]] const mjModel& model() const noexcept { return loaded_.model(); }
  /// For MuJoCo's functions that draw, which do not take it as constant.
  [[nodiscard]] mjData& data() noexcept { return loaded_.data(); }
  [[nodiscard]] const mjData& data() const noexcept { return loaded_.data(); }
  [[nodiscard]] const std::vector<ShoulderElements>& shoulders() const noexcept {
    return loaded_.shoulders();
  }
  /// Of the shoulder that is watched.
  [[nodiscard]] const ShoulderElements& elements() const noexcept { return loaded_.elements(); }
  [[nodiscard]] bool has_plugin() const noexcept { return loaded_.has_plugin(); }
  /// What position servos are to be given for the last command [rad; of a place m], and the names
  /// of their actuators: the control signal of the same model with position servos.
  [[nodiscard]] std::vector<double> Targets() const;
  [[nodiscard]] std::vector<std::string> TargetNames() const;
  /// How far the AC joint of each shoulder of a loop is open in the last state [m], and the names
  /// of the equalities that close them; none of trees.
  [[nodiscard]] std::vector<double> LoopGaps_m() const;
  [[nodiscard]] std::vector<std::string> LoopNames() const;
  [[nodiscard]] const JointRanges& ranges() const noexcept { return loaded_.ranges(); }
  [[nodiscard]] double timestep_s() const noexcept { return loaded_.timestep_s(); }
  [[nodiscard]] const std::string& name() const noexcept { return loaded_.name(); }

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
  /// What is left of a value within the range of a control; `control` is -1 for none.
  [[nodiscard]] double WithinControl(double value, int control) const;
  /// Replaces the offsets commanded by those that are left of them where the arm is.
  void TakeOffsetsUsed(ArmCommand& used) const;

  LoadedShoulders loaded_;
  AssembledRhythm rhythm_;
  AxialFrom axial_from_;  ///< of the model's command
  /// What position servos were told last, and what of it they follow.
  ArmCommand used_;
  ShoulderPose target_;
};

}  // namespace girdle
