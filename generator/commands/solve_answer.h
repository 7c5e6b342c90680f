// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The answer to one position or posture of the arm, as JSON and as text.
#pragma once

#include <string>

#include "commands/angle_arguments.h"
#include "commands/solve_columns.h"
#include "kinematics/shoulder_rhythm.h"

namespace girdle {

/// One position of the arm as typed. Angles are in degrees. The elevation has Girdle's sign.
struct TypedPosition {
  double elevation_deg;
  double plane_deg;
  double axial_deg;
  double shrug_deg;
  double protraction_deg;
  AxialFrom axial_from;

  /// Returns the position in radians, with the plane within -180 to 180 deg.
  [[nodiscard]] ArmCommand command() const {
    return {RadiansFromDegrees(elevation_deg),   RadiansFromDegrees(PlaneRead_deg(plane_deg)),
            RadiansFromDegrees(axial_deg),       RadiansFromDegrees(shrug_deg),
            RadiansFromDegrees(protraction_deg), axial_from};
  }
};

/// Returns the answer of `rhythm` to a position, with all digits.
[[nodiscard]] std::string PositionAsJson(const ShoulderRhythm& rhythm, const TypedPosition& typed,
                                         const SolveOutput& output);

/// Returns the answer of `rhythm` to a position, with as many decimals as `output` says.
[[nodiscard]] std::string PositionAsText(const ShoulderRhythm& rhythm, const TypedPosition& typed,
                                         const SolveOutput& output);

/// Returns the pose of a named posture, with all digits.
[[nodiscard]] std::string PostureAsJson(const std::string& posture, const ShoulderPose& pose,
                                        const SolveOutput& output);

/// Returns the pose of a named posture, with as many decimals as `output` says.
[[nodiscard]] std::string PostureAsText(const std::string& posture, const ShoulderPose& pose,
                                        const SolveOutput& output);

}  // namespace girdle
