// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Steps the shoulders of a MuJoCo model.
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

/// A model with its plugin or with position servos, ready to step. All its shoulders follow the
/// same command. States are those of the watched shoulder. Throws InputError if MuJoCo warns.
class ShoulderSimulation {
 public:
  /// `rhythm` gives the targets of position servos, which have no rhythm of their own. The plugin
  /// uses its own rhythm instead.
  ShoulderSimulation(LoadedShoulders shoulders, AssembledRhythm rhythm);
  /// Uses OwnRhythm.
  explicit ShoulderSimulation(LoadedShoulders shoulders);
  ShoulderSimulation(ModelPointer model, std::string name)
      : ShoulderSimulation(LoadedShoulders(std::move(model), std::move(name))) {}

  /// Selects the watched shoulder, whose states are returned. Throws InputError if the model does
  /// not have that side.
  void Watch(Side side) { loaded_.Watch(side); }

  /// Returns a command with its axial turn counted from the zero of the model's own command. A
  /// model with position servos has no such command, so the result is unchanged.
  [[nodiscard]] ArmCommand AsModelCounts(const ArmCommand& command) const;

  /// Puts the arm at rest at its targets for a command.
  void Start(const ArmCommand& command);

  /// Steps once under a command. The rate is used if the model has rate commands. Returns the state
  /// at the beginning of the step.
  ShoulderState Step(const ArmCommand& command, const CommandRate& rate = {});

  /// Returns the present state under a command, without a step.
  ShoulderState Observe(const ArmCommand& command);

  /// Puts the joints at the plugin's own targets for a command, at rest, and returns that state.
  ShoulderState ObserveAtTargets(const ArmCommand& command);

  /// Puts all joints at a keyframe of the model, at rest, and derives positions.
  void PutAtKeyframe(int key);

  /// Puts one shoulder's joints into a pose, at rest, and derives positions. In a loop the clavicle
  /// determines the position of the scapula.
  void PutAt(const ShoulderElements& elements, const ShoulderPose& pose);

  /// Returns the pose of one shoulder from its bones, as that of a right shoulder.
  [[nodiscard]] ShoulderPose PoseOf(const ShoulderElements& elements) const;

  [[nodiscard]] const LoadedShoulders& loaded() const noexcept { return loaded_; }
  [[nodiscard]] const AssembledRhythm& rhythm() const noexcept { return rhythm_; }
  [[nodiscard]] const mjModel& model() const noexcept { return loaded_.model(); }
  /// Not constant, for MuJoCo's functions that draw.
  [[nodiscard]] mjData& data() noexcept { return loaded_.data(); }
  [[nodiscard]] const mjData& data() const noexcept { return loaded_.data(); }
  [[nodiscard]] const std::vector<ShoulderElements>& shoulders() const noexcept {
    return loaded_.shoulders();
  }
  /// Elements of the watched shoulder.
  [[nodiscard]] const ShoulderElements& elements() const noexcept { return loaded_.elements(); }
  [[nodiscard]] bool has_plugin() const noexcept { return loaded_.has_plugin(); }
  /// The targets of position servos for the last command [rad; m for a position], and the names of
  /// their actuators. They are the control signal for the same model with position servos.
  [[nodiscard]] std::vector<double> Targets() const;
  [[nodiscard]] std::vector<std::string> TargetNames() const;
  /// The opening of the AC joint of each shoulder of a loop in the last state [m], and the names of
  /// the equalities that close these joints. Empty for a tree.
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
  /// Everything that MuJoCo derives, with the given positions.
  [[nodiscard]] ShoulderState Derived(double time_s, const ArmCommand& command,
                                      const JointAngles& position_rad) const;
  [[nodiscard]] double FastestJoint(mjtJoint type) const;
  /// Returns a value limited to the range of a control. `control` is -1 for no control.
  [[nodiscard]] double WithinControl(double value, int control) const;
  /// Replaces the commanded offsets by the offsets that are possible where the arm is.
  void TakeOffsetsUsed(ArmCommand& used) const;

  LoadedShoulders loaded_;
  AssembledRhythm rhythm_;
  AxialFrom axial_from_;  ///< zero of the model's axial command
  /// The last command of position servos and the pose that they follow.
  ArmCommand used_;
  ShoulderPose target_;
};

}  // namespace girdle
