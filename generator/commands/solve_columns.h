// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The columns that `girdle solve` adds to each row of a CSV: one table of names, units and
/// formulas.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "anatomy/anatomy.h"
#include "commands/shoulder_points.h"
#include "kinematics/assembly.h"
#include "kinematics/shoulder_rhythm.h"
#include "text/csv_dialect.h"
#include "text/output_columns.h"

namespace girdle {

/// Stems of columns whose names are also keys of the JSON for one pose.
inline constexpr std::string_view kClampedStem = "clamped";
inline constexpr std::string_view kUsedElevationStem = "used_elevation";
inline constexpr std::string_view kUsedPlaneStem = "used_plane";
inline constexpr std::string_view kDistanceStem = "distance";
inline constexpr std::string_view kOriginStem = "origin";
/// Stem of the column that tells bridged rows.
inline constexpr std::string_view kBridgedStem = "bridged";

/// How rotations are written.
enum class RotationForm {
  kAngles,       ///< as Euler angles
  kQuaternions,  ///< as w, x, y, z with w >= 0
};
inline constexpr std::array<std::string_view, 2> kRotationFormNames = {"degrees", "quaternions"};
constexpr const auto& WordsOf(RotationForm /*which*/) noexcept { return kRotationFormNames; }

inline constexpr int kDefaultDigits = 6;
inline constexpr int kMostDigits = 15;

/// Choices of what `girdle solve` writes for a position of the arm.
struct SolveOutput {
  RotationForm form = RotationForm::kAngles;
  /// The pose that rotations are counted from; the zero of each joint if empty.
  std::optional<ShoulderPose> since = std::nullopt;
  /// The origin of `since`.
  Origin since_origin = Origin::kMeasured;
  /// Whether the derivatives of the joints' rotations are written. Needs a smooth interpolation.
  bool derivatives = false;
  /// The anatomy whose ShoulderPoints are written. No points are written if empty.
  std::optional<Anatomy> points_of = std::nullopt;
  /// Whether a column tells which rows are bridged.
  bool has_bridged = false;
  /// Decimals of numbers in tables, 0 to kMostDigits.
  int digits = kDefaultDigits;
};

/// The rotations that are written. Each is of one bone in another.
inline constexpr std::size_t kWrittenRotationCount = 5;
inline constexpr std::array<std::string_view, kWrittenRotationCount> kWrittenRotationNames = {
    "sc",  // clavicle in thorax, q_TC
    "ac",  // scapula in clavicle, q_CS
    "gh",  // humerus in scapula, q_SH
    "st",  // scapula in thorax, q_TS
    "ht",  // humerus in thorax, q_TH
};
using WrittenRotations = std::array<Quaternion, kWrittenRotationCount>;

/// Returns the rotations of a pose in the order of kWrittenRotationNames, w >= 0. If `since` has a
/// pose, each is the turn q_0^-1 q since that pose, in the axes that the bone has there.
[[nodiscard]] WrittenRotations RotationsOf(const ShoulderPose& pose,
                                           const std::optional<ShoulderPose>& since) noexcept;

/// Stems of the angles that are written: kCoordinateNames, then kScapulothoracicNames.
inline constexpr std::size_t kWrittenAngleCount = kCoordinateCount + kScapulothoracicNames.size();
using WrittenAngles = std::array<double, kWrittenAngleCount>;
[[nodiscard]] std::vector<std::string> WrittenAngleNames();

/// Returns the angles of the joints, followed by those of the scapula in the thorax [rad].
[[nodiscard]] WrittenAngles WithScapulothoracic(const JointAngles& joints_rad,
                                                const Quaternion& q_TS) noexcept;

/// Returns the angles [rad] of RotationsOf in the order of WrittenAngleNames; ranges as in
/// AnglesFromPose.
[[nodiscard]] WrittenAngles AnglesOf(const WrittenRotations& rotations) noexcept;

/// The values that the columns of a solved row are computed from, as in ShoulderSolution.
struct SolvedRow {
  WrittenAngles angles_rad;    ///< if the form is degrees
  WrittenRotations rotations;  ///< if the form is quaternions
  bool clamped;
  ArmCommand used;
  double distance_rad;
  Origin origin;
  double used_axial_isb_rad;           ///< ISB's third angle
  std::optional<ShoulderRates> rates;  ///< if derivatives are chosen
  std::vector<ShoulderPoint> points;   ///< if points are chosen
  bool bridged = false;                ///< whether the row bridges a gap
};

/// Returns the columns in this order:
///
/// The angles, `sc_protraction_deg` and so on, or as quaternions `sc_qw` and so on, with
/// `_since_hanging` behind the stem where they are counted from the hanging arm; `clamped`, the
/// direction that is answered, `used_elevation_deg` and `used_plane_deg`; `distance_deg`, `origin`;
/// `bridged` where gaps are bridged;
/// `used_axial_deg`, the humerus's turn on top of the rhythm's own, and `used_axial_isb_deg`, ISB's
/// third angle; the offsets of the clavicle that were left, `used_shrug_deg` and
/// `used_protraction_deg`.
///
/// With derivatives, each joint has three columns for elevation and three for plane,
/// `sc_w_elevation_x` and so on: the angular velocity of the child in the parent, in the parent's
/// axes [deg per deg].
///
/// With points, each has three columns, `elbow_x_mm` and so on, in the thorax frame.
///
/// Separators and decimal marks are those of `dialect`.
[[nodiscard]] WrittenColumns<SolvedRow, RoundedNumbers> SolveColumns(
    const SolveOutput& output, const CsvDialect& dialect = {});

}  // namespace girdle
