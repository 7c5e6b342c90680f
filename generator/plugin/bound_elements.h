// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The elements of a model that make one shoulder's rhythm, as a step reads and writes them: places
/// in the engine's arrays. They are found once (rhythm_binding.h); nothing here can fail.
#pragma once

#include <algorithm>

#include "plugin/engine_views.h"

namespace girdle {

/// Control of an actuator [rad, rad/s; of a slide m]; one that the model lacks is 0.
struct BoundControl {
  int address = -1;

  [[nodiscard]] bool exists() const noexcept { return address >= 0; }
  /// As the user set it.
  [[nodiscard]] double Raw(const DataView& data) const noexcept {
    return exists() ? data.ctrl[address] : 0;
  }
  /// Within its range, where the model gives one and MuJoCo is to heed it.
  [[nodiscard]] double Read(const ModelView& model, const DataView& data) const noexcept;
  /// The same of an angle, of which whole turns do not matter: where it is out of its range they
  /// are taken off, so that of -180 to 180 deg 350 is -10.
  [[nodiscard]] double ReadAngle(const ModelView& model, const DataView& data) const noexcept;
  /// Within its range, and 0 for what is not a finite number.
  [[nodiscard]] double ReadFinite(const ModelView& model, const DataView& data) const noexcept;

 private:
  /// Lower and upper end; null where nothing is to be heeded.
  [[nodiscard]] const mjtNum* RangeIn(const ModelView& model) const noexcept;
};

/// A servo and the hinge or slide that it acts on.
struct BoundServo {
  int qpos_address = 0;
  int dof_address = 0;
  int force_address = 0;
  BoundControl trim;
  double stiffness = 0;  ///< [N m/rad], of a slide [N/m]
  int group = 0;         ///< MuJoCo leaves it to a plugin to heed option/actuatorgroupdisable

  [[nodiscard]] bool IsDisabled(const ModelView& model) const noexcept;
};

/// A sensor that shows what sensor_layout says.
struct BoundSensor {
  int address = 0;    ///< of its first value
  double cutoff = 0;  ///< largest magnitude of a value; 0: any

  /// As MuJoCo cuts what the sensor's own stage has written.
  [[nodiscard]] double Cut(double value) const noexcept {
    return cutoff > 0 ? std::clamp(value, -cutoff, cutoff) : value;
  }
};

}  // namespace girdle
