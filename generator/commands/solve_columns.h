// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The columns that `girdle solve` answers each row of a CSV with: one table of names, units and
/// how they are computed.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "anatomy/anatomy.h"
#include "commands/shoulder_points.h"
#include "kinematics/shoulder_rhythm.h"
#include "text/number_text.h"
#include "text/output_columns.h"

namespace girdle {

/// Stems of columns that have the same names where one pose is answered as JSON.
inline constexpr std::string_view kClampedStem = "clamped";
inline constexpr std::string_view kUsedElevationStem = "used_elevation";
inline constexpr std::string_view kUsedPlaneStem = "used_plane";
inline constexpr std::string_view kDistanceStem = "distance";
inline constexpr std::string_view kOriginStem = "origin";

/// What a row is answered with beside its angles and where they come from.
struct SolveAdditions {
  /// The derivatives of the joints' rotations; the interpolation has to be smooth.
  bool rates = false;
  /// Whose ShoulderPoints, if anybody's.
  std::optional<Anatomy> points_of = std::nullopt;
};

/// What the columns of a row that is solved are made of; as in ShoulderSolution.
struct SolvedRow {
  JointAngles angles_rad;  ///< in the order of kCoordinateNames
  bool clamped;
  ArmCommand used;
  double distance_rad;
  Origin origin;
  double used_axial_isb_rad;           ///< ISB's third angle
  std::optional<ShoulderRates> rates;  ///< where they are asked for
  std::vector<ShoulderPoint> points;   ///< where they are asked for
};

/// Returns the columns in their order:
///
/// Nine angles, `sc_protraction_deg` and so on; `clamped`, the direction that is answered,
/// `used_elevation_deg` and `used_plane_deg`; `distance_deg`, `origin`; `used_axial_deg`, the
/// humerus's turn on top of the rhythm's own, and `used_axial_isb_deg`, ISB's third angle; the
/// offsets of the clavicle that were left, `used_shrug_deg` and `used_protraction_deg`.
///
/// With rates three columns a joint for each of elevation and plane, `sc_w_elevation_x` and so on:
/// the angular velocity of the child in the parent, in the parent's axes [deg per deg].
///
/// With points three columns for each of them, `elbow_x_mm` and so on, in the thorax frame.
[[nodiscard]] WrittenColumns<SolvedRow, AppendRounded> SolveColumns(
    const SolveAdditions& additions);

}  // namespace girdle
