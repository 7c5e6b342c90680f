// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "plugin/bound_elements.h"

#include <algorithm>
#include <cmath>

#include "kinematics/rotation.h"

namespace girdle {

const mjtNum* BoundControl::RangeIn(const ModelView& model) const noexcept {
  const bool is_limited = exists() && model.actuator_ctrllimited[address] != 0 &&
                          !model.Disables(model.engine->disable_clampctrl);
  return is_limited ? model.actuator_ctrlrange + 2 * address : nullptr;
}

double BoundControl::Read(const ModelView& model, const DataView& data) const noexcept {
  const double value = Raw(data);
  const mjtNum* const range = RangeIn(model);
  return range == nullptr ? value : std::clamp(value, range[0], range[1]);
}

double BoundControl::ReadAngle(const ModelView& model, const DataView& data) const noexcept {
  const double value = Raw(data);
  const mjtNum* const range = RangeIn(model);
  if (range == nullptr || !std::isfinite(value) || (value >= range[0] && value <= range[1])) {
    return Read(model, data);
  }
  const double middle = (range[0] + range[1]) / 2;
  return std::clamp(middle + std::remainder(value - middle, 2 * kPi), range[0], range[1]);
}

double BoundControl::ReadFinite(const ModelView& model, const DataView& data) const noexcept {
  const double value = Read(model, data);
  return std::isfinite(value) ? value : 0;
}

// The option has one bit for each of the first groups. Other groups cannot be disabled.
bool BoundServo::IsDisabled(const ModelView& model) const noexcept {
  constexpr int kBits = 31;
  return group >= 0 && group < kBits && ((model.disableactuator >> group) & 1) != 0;
}

}  // namespace girdle
