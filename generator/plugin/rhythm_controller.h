// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The plugin's logic: joint servos whose targets follow three commands through the shoulder
/// rhythm.
///
/// One instance of `girdle.rhythm` is shared by twelve actuators. Three are commands: their gear is
/// 0 and their controls are elevation, plane and axial [rad]. Nine are servos, one a hinge:
///
///     force = kp (target + trim - q)
///
/// with the target from the inverse kinematics of the commands, q the hinge's coordinate and the
/// trim the actuator's own control [rad], 0 by default. Damping belongs on the hinge, where MuJoCo
/// integrates it implicitly.
///
/// An actuator's role is the name of kCommandNames or kCoordinateNames that stands last in its own
/// name, so that `him_elevation_r` and `elevation_r` are the same. No step depends on an
/// earlier one.
#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <cstddef>
#include <memory>

#include "kinematics/model_names.h"
#include "kinematics/shoulder_rhythm.h"
#include "tables/rhythm_config.h"

namespace girdle {

class RhythmController {
 public:
  /// Finds the instance's actuators and checks the model around them. Throws std::runtime_error
  /// that names the element and the fix.
  RhythmController(const mjModel& model, int instance, const RhythmConfig& config);

  /// Writes the forces of the nine servos; the commands' stay 0.
  void Actuate(const mjModel& model, mjData& data) noexcept;

  /// Writes the instance's sensors, see sensor_layout. Positions are those of `data`, forward
  /// kinematics done.
  void Sense(const mjModel& model, mjData& data, int instance) noexcept;

 private:
  /// Control of an actuator [rad].
  struct Control {
    int address = 0;

    /// As the user set it; a control that is not finite counts as 0.
    [[nodiscard]] double Raw(const mjData& data) const noexcept;
    /// Within its range, where the model gives one and MuJoCo is to heed it.
    [[nodiscard]] double Read(const mjModel& model, const mjData& data) const noexcept;
  };
  struct Servo {
    int qpos_address = 0;
    int force_address = 0;
    Control trim;
    double stiffness_N_m_per_rad = 0;
  };

  void AddCommand(const mjModel& model, int actuator, std::size_t role);
  void AddServo(const mjModel& model, int actuator, std::size_t role, const RhythmConfig& config);
  [[nodiscard]] ArmCommand ReadCommand(const mjModel& model, const mjData& data) const noexcept;
  /// Targets of the nine servos for a command.
  const JointAngles& TargetsFor(const ArmCommand& command) noexcept;

  ShoulderRhythm rhythm_;
  std::array<Control, kCommandCount> commands_{};
  std::array<Servo, kCoordinateCount> servos_{};
  int thorax_body_ = 0;
  int humerus_body_ = 0;

  /// The last command solved and its targets. Not state: the same command always has the same
  /// targets. It spares the sensor what the servos have computed in the same step.
  ArmCommand solved_command_;
  JointAngles solved_target_rad_{};
};

}  // namespace girdle
