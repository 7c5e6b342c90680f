// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The elements of a model that make one shoulder's rhythm, as indices into the engine's arrays. A
/// step reads and writes them. They are found once (rhythm_binding.h), and no function here can
/// fail.
#pragma once

#include <algorithm>

#include "plugin/engine_views.h"

namespace girdle {

/// The control of an actuator [rad or rad/s; m for a slide]. If the model lacks the actuator, the
/// control is 0.
struct BoundControl {
  int address = -1;

  [[nodiscard]] bool exists() const noexcept { return address >= 0; }
  /// The control as the user set it.
  [[nodiscard]] double Raw(const DataView& data) const noexcept {
    return exists() ? data.ctrl[address] : 0;
  }
  /// The control limited to its range. It is not limited if the model gives no range or if MuJoCo
  /// ignores ranges.
  [[nodiscard]] double Read(const ModelView& model, const DataView& data) const noexcept;
  /// The control of an angle, limited to its range. Whole turns do not matter: if the angle is out
  /// of its range, whole turns are removed first. In a range of -180 to 180 deg, 350 becomes -10.
  [[nodiscard]] double ReadAngle(const ModelView& model, const DataView& data) const noexcept;
  /// The control limited to its range, or 0 if it is not finite.
  [[nodiscard]] double ReadFinite(const ModelView& model, const DataView& data) const noexcept;

 private:
  /// Lower and upper limit, or null if the control is not limited.
  [[nodiscard]] const mjtNum* RangeIn(const ModelView& model) const noexcept;
};

/// A servo and the hinge or slide that it acts on.
struct BoundServo {
  int qpos_address = 0;
  int dof_address = 0;
  int force_address = 0;
  BoundControl trim;
  double stiffness = 0;  ///< [N m/rad], of a slide [N/m]
  int group = 0;         ///< MuJoCo leaves option/actuatorgroupdisable to the plugin

  [[nodiscard]] bool IsDisabled(const ModelView& model) const noexcept;
};

/// A sensor with the values of sensor_layout.
struct BoundSensor {
  int address = 0;    ///< of its first value
  double cutoff = 0;  ///< largest magnitude of a value; 0: no limit

  /// Limits a value to the cutoff, as MuJoCo does after the sensor's own stage.
  [[nodiscard]] double Cut(double value) const noexcept {
    return cutoff > 0 ? std::clamp(value, -cutoff, cutoff) : value;
  }
};

}  // namespace girdle
