// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The plugin's logic: joint servos whose targets follow commands through the shoulder rhythm.
///
/// One instance of `girdle.rhythm` is shared by the actuators of a shoulder. Commands have gear 0:
/// elevation, plane and axial [rad]; a model may add shrug and protraction [rad], and how fast the
/// first three change, elevation_rate, plane_rate and axial_rate [rad/s]. Nine are servos, one a
/// hinge:
///
///     force = kp (target + trim - q) + damping (d target / dt)
///
/// with the target from the inverse kinematics of the commands, q the hinge's coordinate, the trim
/// the actuator's own control [rad], 0 by default, and the hinge's own linear damping, which the
/// last term makes up for where the rates are commanded. Damping belongs on the hinge, where MuJoCo
/// integrates it implicitly.
///
/// The servos tell the assembly (assembly.h): those of AC make a tree; those of the scapula on the
/// thorax a loop, where three more may drive the scapula's place.
///
/// A command that is not a number is none: the targets are then where the joints are, and trims and
/// rates count for nothing.
///
/// An actuator's role is the name of model_names.h that stands last in its own name, so that
/// `him_elevation_r` and `elevation_r` are the same. No step depends on an earlier one.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "kinematics/assembled_rhythm.h"
#include "names/model_names.h"
#include "plugin/engine_views.h"
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

 private:
  /// Control of an actuator [rad, rad/s]; one that the model lacks is 0.
  struct Control {
    int address = -1;

    [[nodiscard]] bool exists() const noexcept { return address >= 0; }
    /// As the user set it.
    [[nodiscard]] double Raw(const DataView& data) const noexcept {
      return exists() ? data.ctrl[address] : 0;
    }
    /// Within its range, where the model gives one and MuJoCo is to heed it.
    [[nodiscard]] double Read(const ModelView& model, const DataView& data) const noexcept;
    /// The same, and 0 for what is not a finite number.
    [[nodiscard]] double ReadFinite(const ModelView& model, const DataView& data) const noexcept;
  };
  struct Servo {
    int qpos_address = 0;
    int dof_address = 0;
    int force_address = 0;
    Control trim;
    double stiffness = 0;  ///< [N m/rad], of a slide [N/m]
    int group = 0;         ///< MuJoCo leaves it to a plugin to heed option/actuatorgroupdisable

    [[nodiscard]] bool IsDisabled(const ModelView& model) const noexcept;
  };
  struct Sensor {
    int address = 0;
    double cutoff = 0;  ///< largest magnitude of a value; 0: any

    /// As MuJoCo cuts what the sensor's own stage has written.
    [[nodiscard]] double Cut(double value) const noexcept {
      return cutoff > 0 ? std::clamp(value, -cutoff, cutoff) : value;
    }
  };
  /// What the servos aim at.
  struct Aim {
    ArmCommand used;
    JointAngles target_rad;
    Vector3 target_p_TS_m;  ///< place of PAC, where that is driven
    bool holds = false;     ///< there is no command: the joints stay where they are
  };

  /// What a servo can be: a tree's nine coordinates, a loop's own three, the scapula's place.
  static constexpr std::size_t kScapulothoracicRole = kCoordinateCount;
  static constexpr std::size_t kTranslationRole = kScapulothoracicRole + 3;
  static constexpr std::size_t kServoRoleCount = kTranslationRole + 3;
  static constexpr std::array<std::string_view, kServoRoleCount> kServoRoles = [] {
    std::array<std::string_view, kServoRoleCount> roles{};
    std::copy(kCoordinateNames.begin(), kCoordinateNames.end(), roles.begin());
    std::copy(kScapulothoracicNames.begin(), kScapulothoracicNames.end(),
              roles.begin() + kScapulothoracicRole);
    std::copy(kTranslationNames.begin(), kTranslationNames.end(), roles.begin() + kTranslationRole);
    return roles;
  }();

  void AddCommand(const ModelView& model, int actuator, std::size_t role);
  void AddServo(const ModelView& model, int actuator, std::size_t role, const RhythmConfig& config);
  /// Which assembly the servos make; throws if they make none.
  [[nodiscard]] Assembly CheckServos(const std::array<bool, kServoRoleCount>& has_servo);
  /// Throws if a servo that has to hold its joint has no stiffness.
  void CheckStiffness(const RhythmConfig& config) const;
  void FindClavicle(const ModelView& model);
  void FindSensors(const ModelView& model, int instance);
  [[nodiscard]] JointRanges RangesOf(const ModelView& model) const noexcept;
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

  std::array<Control, kAllCommandCount> commands_{};
  /// The nine coordinates, then the scapula's place.
  std::array<Servo, kCoordinateCount + 3> servos_{};
  bool has_translations_ = false;
  Side side_ = Side::kRight;
  Vector3 p_TC_m_{0, 0, 0};  ///< clavicle in the thorax, taken to the right; for the place
  Vector3 p_CS_m_{0, 0, 0};  ///< scapula on the clavicle, likewise
  std::vector<Sensor> sensors_;
  int thorax_body_ = 0;
  int humerus_body_ = 0;
  bool has_rates_ = false;
  std::optional<AssembledRhythm> rhythm_;  ///< set by the constructor

  /// The last command solved and its aim. Not state: the same command always has the same aim. It
  /// spares the servos what the sensor has computed in the same step.
  ArmCommand solved_command_;
  Aim solved_{};
  Aim holding_{};  ///< where the joints are, while a command is not a number
};

}  // namespace girdle
