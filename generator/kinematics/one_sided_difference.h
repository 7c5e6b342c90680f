// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Derivatives at the end of an interval, from values on that side of it alone.
///
/// Weights of the values f1 .. f4 at h, 2h, 3h, 4h when f0 = 0 at the end itself (subtract it); h
/// may be negative:
///
///     f' h    = 3 f1 - 3/2 f2 + 1/3 f3                   (third order, for coarse values)
///     f' h    = 4 f1 - 3 f2 + 4/3 f3 - 1/4 f4            (fourth order)
///     f'' h^2 = -26/3 f1 + 19/2 f2 - 14/3 f3 + 11/12 f4  (third order)
#pragma once

#include <array>

#include "kinematics/rotation.h"

namespace girdle {

inline constexpr std::array<double, 3> kOneSidedFirstOfCoarse = {3, -3.0 / 2, 1.0 / 3};
inline constexpr std::array<double, 4> kOneSidedFirst = {4, -3, 4.0 / 3, -1.0 / 4};
inline constexpr std::array<double, 4> kOneSidedSecond = {-26.0 / 3, 19.0 / 2, -14.0 / 3,
                                                          11.0 / 12};

/// h for what changes with the command of an arm [rad]: small enough for the formulas' error, large
/// enough for rounding.
inline constexpr double kOneSidedStep_rad = 0.02 * kRadiansPerDegree;

}  // namespace girdle
