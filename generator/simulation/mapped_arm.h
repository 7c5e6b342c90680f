// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Moving the arm of a model that is not ours, and all that hangs on it by the model's own rules.
#pragma once

#include <string>
#include <vector>

#include "kinematics/shoulder_pose.h"
#include "simulation/engine.h"
#include "simulation/model_mapping.h"

namespace girdle {

/// A model is at rest below it: at 20 ms of lag of a servo that is 1e-6 deg from where it goes to.
inline constexpr double kRestSpeed_rad_per_s = 1e-6;

/// What became of a move. "Not reached" is a result, not an error.
struct ArmMove {
  bool reached = false;
  std::string reason;  ///< why it was not reached
  /// Largest residual of the model's equality constraints, in their own units [m, rad].
  double coupling = 0;
  double speed_rad_per_s = 0;  ///< largest of the model's generalized velocities
};

/// The arm as a mapping sets it.
///
/// By joints: the mapping's joints are put where they have to be and held, and all other joints
/// move by as little as satisfies the model's equality constraints (couplings of joints, connect,
/// weld, tendons), by Newton's method. No forces, no limits, no contacts.
///
/// By actuators: the mapping's controls are set and the model runs until it rests.
class MappedArm {
 public:
  /// `model` and `mapping` must outlive this. With joints, contacts and limits of the model are
  /// switched off. Throws InputError, with the mapping's file and line, if the model lacks a joint
  /// or actuator, a joint is no hinge, or follows another one by an equality constraint.
  MappedArm(mjModel& model, const ModelMapping& mapping);

  /// Moves the arm to where it points in a direction. Angles as in ModelMapping. Throws InputError
  /// where MuJoCo warns.
  [[nodiscard]] ArmMove Move(const ArmAngles& wanted);

  /// Everything that MuJoCo derives of positions, after the last move.
  [[nodiscard]] const mjData& data() const noexcept { return *data_; }
  [[nodiscard]] bool moves_by_actuators() const noexcept { return mapping_.drives_are_actuators; }

 private:
  void FindJoints();
  void FindActuators();
  void ExpectNoFollowers() const;
  /// Why the values are beyond the ranges of joints or controls; empty if they are not.
  [[nodiscard]] std::string BeyondRange(const std::vector<double>& values) const;
  [[nodiscard]] ArmMove MoveJoints(const std::vector<double>& values);
  [[nodiscard]] ArmMove MoveActuators(const std::vector<double>& values);
  /// Satisfies the equality constraints with the joints held where they are; returns what is left.
  [[nodiscard]] double SolveCouplings();
  [[nodiscard]] double Coupling() const;

  mjModel& model_;
  const ModelMapping& mapping_;
  DataPointer data_;
  std::vector<int> ids_;        ///< of the drives
  std::vector<int> addresses_;  ///< of the drives, in qpos or ctrl
  std::vector<int> free_dofs_;  ///< degrees of freedom that are not held
  bool is_lost_ = false;        ///< the last move was not reached
};

}  // namespace girdle
