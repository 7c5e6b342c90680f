// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Units of length, and how finely lengths are told.
#pragma once

#include <cmath>

#include "kinematics/rotation.h"

namespace girdle {

/// Lengths are in meters, and in millimeters where people read them.
inline constexpr double kMillimetersPerMeter = 1000;

/// Lengths in files are rounded to 0.1 mm, so many decimals of a meter: bones are not known better,
/// and products have digits that nobody wants to read.
inline constexpr int kLengthDecimals = 4;
inline constexpr double kLengthStepsPerMeter = 1e4;

/// Returns the nearest length that is a whole number of 0.1 mm [m].
[[nodiscard]] inline double RoundedLength_m(double length_m) noexcept {
  return std::round(length_m * kLengthStepsPerMeter) / kLengthStepsPerMeter;
}
/// Returns the shortest such length that is not shorter [m].
[[nodiscard]] inline double RoundedUpLength_m(double length_m) noexcept {
  return std::ceil(length_m * kLengthStepsPerMeter) / kLengthStepsPerMeter;
}
/// Returns the nearest place whose coordinates are such lengths [m].
[[nodiscard]] inline Vector3 RoundedPlace_m(const Vector3& p_m) noexcept {
  return {RoundedLength_m(p_m.x), RoundedLength_m(p_m.y), RoundedLength_m(p_m.z)};
}

}  // namespace girdle
