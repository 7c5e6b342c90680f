// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Moves the arm of a foreign model, together with everything that follows the arm by the model's
/// own rules.
#pragma once

#include <string>
#include <vector>

#include "kinematics/shoulder_pose.h"
#include "simulation/engine.h"
#include "simulation/model_mapping.h"

namespace girdle {

/// A model is at rest if its speed is below this. With a servo lag of 20 ms it is then 1e-6 deg
/// from its target.
inline constexpr double kRestSpeed_rad_per_s = 1e-6;

/// Result of a move. "Not reached" is a result, not an error.
struct ArmMove {
  bool reached = false;
  std::string reason;  ///< why it was not reached
  /// Largest residual of the model's equality constraints, in their own units [m, rad].
  double coupling = 0;
  double speed_rad_per_s = 0;  ///< largest of the model's generalized velocities
};

/// The arm of a model as a mapping moves it.
///
/// With joints: the mapping's joints are set to their values and held. All other joints move as
/// little as possible to satisfy the model's equality constraints (couplings of joints, connect,
/// weld, tendons), by Newton's method. There are no forces, no limits and no contacts.
///
/// With actuators: the mapping's controls are set, and the model runs until it is at rest.
class MappedArm {
 public:
  /// `model` and `mapping` must outlive this object. With joints, it switches off contacts and
  /// limits of the model. Throws InputError, with the mapping's file and line, if the model lacks a
  /// joint or actuator, if a joint is not a hinge, or if a joint follows another one by an equality
  /// constraint.
  MappedArm(mjModel& model, const ModelMapping& mapping);

  /// Moves the arm until it points in a direction. Angles are those of ModelMapping. Throws
  /// InputError if MuJoCo warns.
  [[nodiscard]] ArmMove Move(const ArmAngles& wanted);

  /// The data after the last move, with everything that MuJoCo derives from positions.
  [[nodiscard]] const mjData& data() const noexcept { return *data_; }
  [[nodiscard]] bool moves_by_actuators() const noexcept { return mapping_.drives_are_actuators; }

 private:
  void FindJoints();
  void FindActuators();
  void ExpectNoFollowers() const;
  /// Returns why values are beyond the ranges of joints or controls; empty if they are not.
  [[nodiscard]] std::string BeyondRange(const std::vector<double>& values) const;
  [[nodiscard]] ArmMove MoveJoints(const std::vector<double>& values);
  [[nodiscard]] ArmMove MoveActuators(const std::vector<double>& values);
  /// Satisfies the equality constraints while the joints are held. Returns the remaining residual.
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
