// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Derivatives at the end of an interval, from values on one side of it only.
///
/// f1 .. f4 are the values at h, 2h, 3h, 4h. The value at the end itself is subtracted from each,
/// so f0 = 0. h may be negative. The arrays below are the weights of these formulas:
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

/// h [rad] for functions of an arm command. It is small enough for the error of the formulas and
/// large enough for rounding.
inline constexpr double kOneSidedStep_rad = 0.02 * kRadiansPerDegree;

}  // namespace girdle
