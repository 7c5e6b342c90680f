// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The plugin's logic: joint servos whose targets follow commands through the shoulder rhythm.
///
/// The actuators of a shoulder share one instance of `girdle.rhythm`. Commands have gear 0. Each
/// model has elevation, plane and axial [rad]; the configuration gives the zero of axial. A model
/// may add shrug and protraction [rad], and the rates of the first three, elevation_rate,
/// plane_rate and axial_rate [rad/s]. Nine actuators are servos, one for each hinge:
///
///     force = kp (target + trim - q) + damping (d target / dt)
///
/// The target comes from the inverse kinematics of the commands. q is the hinge's coordinate. The
/// trim is the actuator's own control [rad], 0 by default. `damping` is the hinge's own linear
/// damping. Damping belongs on the hinge, where MuJoCo integrates it implicitly. The last term
/// compensates it if the rates are commanded.
///
/// If any command is NaN, the targets are the present joint angles, and trims and rates have no
/// effect. The servos then exert no force.
///
/// rhythm_binding.h defines which elements of a model these are. No step depends on an earlier one.
#pragma once

#include "kinematics/assembled_rhythm.h"
#include "plugin/engine_views.h"
#include "plugin/rhythm_binding.h"
#include "rhythm_tables/rhythm_config.h"

namespace girdle {

class RhythmController {
 public:
  /// Finds the actuators of the instance and checks the model around them. Throws
  /// std::runtime_error that names the element and the fix.
  RhythmController(const ModelView& model, int instance, const RhythmConfig& config);

  /// Writes the forces of the nine servos, which are always finite. The forces of the commands stay
  /// 0. If the sensors were written for another command, it writes them again, so that the change
  /// of a control alone reaches them.
  void Actuate(const ModelView& model, const DataView& data) noexcept;

  /// Writes the sensors of the instance (sensor_layout). Precondition: the positions in `data`
  /// include forward kinematics.
  void Sense(const ModelView& model, const DataView& data) noexcept;

  /// Returns true once if MuJoCo has not computed the thorax although positions are computed.
  /// MuJoCo omits a thorax that stands still if sleeping was enabled after mj_makeData.
  [[nodiscard]] bool FirstMisses(const DataView& data) noexcept;

  [[nodiscard]] const RhythmBinding& binding() const noexcept { return binding_; }
  [[nodiscard]] const AssembledRhythm& rhythm() const noexcept { return rhythm_; }

 private:
  /// The aim of the servos.
  struct Aim {
    ArmCommand used;
    JointAngles target_rad;
    Vector3 target_p_TS_m;     ///< position of PAC, if servos drive it
    double axial_isb_rad = 0;  ///< ISB's third angle of the humerus of the aim
    bool holds = false;        ///< a command is NaN: no force, targets are the present angles
  };

  void SolveAim(const ArmCommand& command) noexcept;
  [[nodiscard]] ArmCommand ReadCommand(const ModelView& model, const DataView& data) const noexcept;
  /// The reference is valid until the next call.
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

  /// The last solved command and its aim. It is not state, because a command always has the same
  /// aim. The servos reuse what the sensor has computed in the same step.
  ArmCommand solved_command_;
  Aim solved_{};
  bool misses_pose_ = false;
  Aim holding_{};  ///< the present joint angles, while a command is NaN
};

}  // namespace girdle
