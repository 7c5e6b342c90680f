// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Commands at which the direction passes from one cell of a rhythm's table to the next.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "kinematics/shoulder_rhythm.h"

namespace girdle {

/// The direction along which a knot line is crossed.
enum class Direction { kElevation, kPlane };
inline constexpr std::array<std::string_view, 2> kDirectionNames = {"elevation", "plane"};
constexpr const auto& WordsOf(Direction /*which*/) noexcept { return kDirectionNames; }

/// Returns a command moved by `step_rad` along a direction.
[[nodiscard]] ArmCommand MovedAlong(Direction direction, const ArmCommand& command,
                                    double step_rad) noexcept;

/// Returns values from `from_rad` to `to_rad` in even steps of about `step_rad`.
[[nodiscard]] std::vector<double> EvenSteps(double from_rad, double to_rad,
                                            double step_rad = kRadiansPerDegree);

/// Returns places on all inner knot lines that are crossed along a direction, about a degree apart.
/// They stay half a degree from the table's borders, where a difference has no room.
[[nodiscard]] std::vector<ArmCommand> KnotCrossings(const RhythmTable& table, Direction direction);

/// Returns fewer of these places, for slow checks: where the lines meet those of the other
/// direction, and halfway between.
[[nodiscard]] std::vector<ArmCommand> FewKnotCrossings(const RhythmTable& table,
                                                       Direction direction);

/// Returns the knots [rad] of the lines that are crossed along a direction, including the table's
/// borders.
[[nodiscard]] const std::vector<double>& KnotsAlong(const RhythmTable& table,
                                                    Direction direction) noexcept;

}  // namespace girdle
