// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Where a command crosses from one cell of a rhythm's table into the next.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "kinematics/shoulder_rhythm.h"

namespace girdle {

/// What a line is crossed along.
enum class Direction { kElevation, kPlane };
inline constexpr std::array<std::string_view, 2> kDirectionNames = {"elevation", "plane"};
constexpr const auto& WordsOf(Direction /*which*/) noexcept { return kDirectionNames; }

/// Returns a command moved by so much along a direction.
[[nodiscard]] ArmCommand MovedAlong(Direction direction, const ArmCommand& command,
                                    double step_rad) noexcept;

/// Returns values from one end to the other [rad], in even steps of about this.
[[nodiscard]] std::vector<double> EvenSteps(double from_rad, double to_rad,
                                            double step_rad = kRadiansPerDegree);

/// Returns places on all inner knot lines that are crossed along a direction, about a degree apart;
/// half a degree from the table's borders, where differences have no room.
[[nodiscard]] std::vector<ArmCommand> KnotCrossings(const RhythmTable& table, Direction direction);

/// Returns some of these places, for what takes long to look at: where the lines meet those of the
/// other direction, and half way between.
[[nodiscard]] std::vector<ArmCommand> FewKnotCrossings(const RhythmTable& table,
                                                       Direction direction);

/// Returns the knots of the lines that are crossed along a direction [rad], the table's borders
/// among them.
[[nodiscard]] const std::vector<double>& KnotsAlong(const RhythmTable& table,
                                                    Direction direction) noexcept;

}  // namespace girdle
