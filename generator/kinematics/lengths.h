// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Units of length, and the precision of lengths in files.
#pragma once

#include <cmath>

#include "kinematics/rotation.h"

namespace girdle {

/// Lengths are in meters. Text for people has millimeters.
inline constexpr double kMillimetersPerMeter = 1000;

/// Lengths in files are rounded to 0.1 mm, which is this many decimals of a meter. Bones are not
/// known more precisely, and more digits only make files harder to read.
inline constexpr int kLengthDecimals = 4;
inline constexpr double kLengthStepsPerMeter = 1e4;

/// Returns the nearest length [m] that is a multiple of 0.1 mm.
[[nodiscard]] inline double RoundedLength_m(double length_m) noexcept {
  return std::round(length_m * kLengthStepsPerMeter) / kLengthStepsPerMeter;
}
/// Returns the shortest length [m] that is a multiple of 0.1 mm and not less than `length_m`.
[[nodiscard]] inline double RoundedUpLength_m(double length_m) noexcept {
  return std::ceil(length_m * kLengthStepsPerMeter) / kLengthStepsPerMeter;
}
/// Returns a place [m] with each coordinate rounded by RoundedLength_m.
[[nodiscard]] inline Vector3 RoundedPlace_m(const Vector3& p_m) noexcept {
  return {RoundedLength_m(p_m.x), RoundedLength_m(p_m.y), RoundedLength_m(p_m.z)};
}

}  // namespace girdle
