// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// One group of lines of the residual report: the states it is shown, and the lines it adds.
///
/// `visits.h` takes a shoulder through motions and poses, and shows every step and every pose to
/// all groups. A group measures its residuals, keeps the worst of each, and adds its lines at the
/// end. States are those of a right shoulder: a left one is shown as its mirror image.
#pragma once

#include <string_view>
#include <vector>

#include "anatomy/anatomy.h"
#include "kinematics/assembled_rhythm.h"
#include "residuals/residual.h"
#include "simulation/shoulder_simulation.h"

namespace girdle {

/// The shoulder that is measured and its references. All members outlive the groups.
struct MeasuredShoulder {
  const ShoulderSimulation& simulation;  ///< watches the shoulder
  const AssembledRhythm& rhythm;         ///< the rotations that the bones should have
  const Anatomy& anatomy;                ///< the sizes that the bones should have

  [[nodiscard]] bool is_loop() const noexcept { return rhythm.assembly() == Assembly::kLoop; }
  [[nodiscard]] bool has_thorax_contact() const noexcept {
    return simulation.elements().has_thorax_contact();
  }
};

/// Phase of a motion that a step belongs to.
enum class StepPhase {
  kMoving,    ///< under way, between two rests
  kSettling,  ///< the command rests, the joints still approach rest
  kSettled,   ///< the command has rested for long
  kCycling,   ///< up and down, or to and fro, once a second without a rest
};

/// One step of the simulation.
struct SteppedState {
  std::string_view motion;  ///< for the report
  StepPhase phase;
  int number;  ///< number of the step, from 0 in each motion
  const ShoulderState& state;
};

/// The means by which a shoulder was brought to the pose that is shown.
enum class PoseKind {
  /// Exactly at the servos' targets, without a step: along the motions and at the table's
  /// positions.
  kAtTargets,
  /// At a position of a loop's table, held by servos and constraints. In models with thorax
  /// contact, which pushes the joints off their targets, the pose at the targets.
  kTableHeld,
  /// At a position of the table, at rest on the thorax. Only for models with thorax contact.
  kTableOnThorax,
  /// At a pose of the grid over all that the arm reaches, held by servos and constraints.
  kGridHeld,
  /// At a pose of the same grid: held, or for models with thorax contact at the targets.
  kGridCommand,
  /// At a keyframe of the model.
  kKeyframe,
};

/// One pose of the shoulder.
struct ShownPose {
  std::string_view name;  ///< for the report: the motion, "table", "grid", the keyframe
  PoseKind kind;
  const ArmCommand& command;
  const ShoulderState& state;
  const ShoulderPose& wanted;      ///< pose of the rhythm for the command
  const RhythmPosition* position;  ///< position of the table, if the pose is at one; otherwise null
  int key = -1;                    ///< number of the keyframe; -1 if the pose is at none
};

class ResidualGroup {
 public:
  ResidualGroup() = default;
  ResidualGroup(const ResidualGroup&) = delete;
  ResidualGroup& operator=(const ResidualGroup&) = delete;
  virtual ~ResidualGroup() = default;

  /// Measures a step of the simulation.
  virtual void TakeStep(const SteppedState& step) { static_cast<void>(step); }
  /// Measures a pose.
  virtual void TakePose(const ShownPose& pose) { static_cast<void>(pose); }
  /// Adds the group's lines to the report. Called once, after all visits.
  virtual void AddLines(std::vector<Residual>& lines) = 0;
};

}  // namespace girdle
