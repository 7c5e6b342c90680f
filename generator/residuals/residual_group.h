// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// One group of lines of the residual report: what it is shown, and what it makes of that.
///
/// `visits.h` takes a shoulder through motions and poses and shows every step and every pose to all
/// groups. A group takes what concerns it, keeps the worst, and adds its lines in the end. States
/// are those of a right shoulder: a left one is shown as its mirror image.
#pragma once

#include <string_view>
#include <vector>

#include "anatomy/anatomy.h"
#include "kinematics/assembled_rhythm.h"
#include "residuals/residual.h"
#include "simulation/shoulder_simulation.h"

namespace girdle {

/// What is measured, and what it is held against. All of it outlives the groups.
struct MeasuredShoulder {
  const ShoulderSimulation& simulation;  ///< watches the shoulder
  const AssembledRhythm& rhythm;         ///< what the bones should do
  const Anatomy& anatomy;                ///< what the bones should be

  [[nodiscard]] bool is_loop() const noexcept { return rhythm.assembly() == Assembly::kLoop; }
  [[nodiscard]] bool has_thorax_contact() const noexcept {
    return simulation.elements().has_thorax_contact();
  }
};

/// Where a step is in its motion.
enum class StepPhase {
  kMoving,    ///< under way, with a rest at both ends
  kSettling,  ///< the command rests, the joints still come to rest
  kSettled,   ///< the command has rested for long
  kCycling,   ///< up and down or to and fro once a second, without a rest
};

/// One step of the simulation.
struct SteppedState {
  std::string_view motion;  ///< for the report
  StepPhase phase;
  int number;  ///< of the step, from 0 in each motion
  const ShoulderState& state;
};

/// How a shoulder comes to be where it is shown.
enum class PoseKind {
  /// Exactly at the servos' targets, without a step: along the motions and at the table's
  /// positions.
  kAtTargets,
  /// At a position of a loop's table, where servos and constraints hold it; on thorax contact,
  /// which pushes the joints off, at the targets.
  kTableHeld,
  /// At a position of the table, at rest on the thorax. Only of models with thorax contact.
  kTableOnThorax,
  /// At a pose of the grid over all that the arm reaches, where servos and constraints hold it.
  kGridHeld,
  /// There too, where the joints are asked to be: held, or on thorax contact at the targets.
  kGridAsked,
  /// At a keyframe of the model.
  kKeyframe,
};

/// One pose.
struct ShownPose {
  std::string_view name;  ///< for the report: the motion, "table", "grid", the keyframe
  PoseKind kind;
  const ArmCommand& command;
  const ShoulderState& state;
  const ShoulderPose& wanted;      ///< what the rhythm says for the command
  const RhythmPosition* position;  ///< the table's, at its positions; otherwise null
  int key = -1;                    ///< number of the keyframe
};

class ResidualGroup {
 public:
  ResidualGroup() = default;
  ResidualGroup(const ResidualGroup&) = delete;
  ResidualGroup& operator=(const ResidualGroup&) = delete;
  virtual ~ResidualGroup() = default;

  /// Takes a step of the simulation.
  virtual void TakeStep(const SteppedState& step) { static_cast<void>(step); }
  /// Takes a pose.
  virtual void TakePose(const ShownPose& pose) { static_cast<void>(pose); }
  /// Adds the lines, after all visits.
  virtual void AddLines(std::vector<Residual>& lines) = 0;
};

}  // namespace girdle
