// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The plugin's logic: joint servos whose targets follow commands through the shoulder rhythm.
///
/// One instance of `girdle.rhythm` is shared by the actuators of a shoulder. Commands have gear 0:
/// elevation, plane and axial [rad], the last counted from what the configuration says; a model may
/// add shrug and protraction [rad], and how fast the first three change, elevation_rate, plane_rate
/// and axial_rate [rad/s]. Nine are servos, one a hinge:
///
///     force = kp (target + trim - q) + damping (d target / dt)
///
/// with the target from the inverse kinematics of the commands, q the hinge's coordinate, the trim
/// the actuator's own control [rad], 0 by default, and the hinge's own linear damping, which the
/// last term makes up for where the rates are commanded. Damping belongs on the hinge, where MuJoCo
/// integrates it implicitly.
///
/// A command that is not a number is none: the targets are then where the joints are, and trims and
/// rates count for nothing.
///
/// rhythm_binding.h says which elements of a model these are. No step depends on an earlier one.
#pragma once

#include "kinematics/assembled_rhythm.h"
#include "plugin/engine_views.h"
#include "plugin/rhythm_binding.h"
#include "rhythm_tables/rhythm_config.h"

namespace girdle {

class RhythmController {
 public:
  /// Finds the instance's actuators and checks the model around them. Throws std::runtime_error
  /// that names the element and the fix.
  RhythmController(const ModelView& model, int instance, const RhythmConfig& config);

  /// Writes the forces of the nine servos, always finite; the commands' stay 0. Where the sensors
  /// were written for another command they are written anew, so that a change of a control alone
  /// reaches them.
  void Actuate(const ModelView& model, const DataView& data) noexcept;

  /// Writes the instance's sensors, see sensor_layout. Positions are those of `data`, forward
  /// kinematics done.
  void Sense(const ModelView& model, const DataView& data) noexcept;

  /// Returns, once, whether MuJoCo has not worked out where the thorax is although positions are
  /// done. A thorax that stands still is left out where sleeping was switched on after mj_makeData.
  [[nodiscard]] bool FirstMisses(const DataView& data) noexcept;

  [[nodiscard]] const RhythmBinding& binding() const noexcept { return binding_; }
  [[nodiscard]] const AssembledRhythm& rhythm() const noexcept { return rhythm_; }

 private:
  /// What the servos aim at.
  struct Aim {
    ArmCommand used;
    JointAngles target_rad;
    Vector3 target_p_TS_m;     ///< place of PAC, where that is driven
    double axial_isb_rad = 0;  ///< ISB's third angle of the humerus aimed at
    bool holds = false;        ///< there is no command: the joints stay where they are
  };

  void SolveAim(const ArmCommand& command) noexcept;
  [[nodiscard]] ArmCommand ReadCommand(const ModelView& model, const DataView& data) const noexcept;
  /// Valid until the next call.
  [[nodiscard]] const Aim& AimFor(const ModelView& model, const DataView& data) noexcept;
  [[nodiscard]] ArmAngles Reached(const DataView& data) const noexcept;
  [[nodiscard]] JointAngles TargetRates(const ModelView& model, const DataView& data,
                                        const Aim& aim) const noexcept;
  [[nodiscard]] bool FeedsForward(const ModelView& model) const noexcept;
  void WriteSensors(const DataView& data, const Aim& aim) const noexcept;
  [[nodiscard]] double DistanceOf(const DataView& data, const Aim& aim) const noexcept;
  [[nodiscard]] bool SensorsShow(const DataView& data, const Aim& aim) const noexcept;

  RhythmBinding binding_;
  AssembledRhythm rhythm_;
  AxialFrom axial_from_;

  /// The last command solved and its aim. Not state: the same command always has the same aim. It
  /// spares the servos what the sensor has computed in the same step.
  ArmCommand solved_command_;
  Aim solved_{};
  bool misses_pose_ = false;
  Aim holding_{};  ///< where the joints are, while a command is not a number
};

}  // namespace girdle
