// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Coefficients of published shoulder rhythms, from data/published_rhythms.csv.
#pragma once

#include <array>
#include <cstddef>
#include <istream>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace girdle {

inline constexpr std::size_t kGirdleAngleCount = 6;

/// The angles that place clavicle and scapula in the thorax, in turning order (Y-X'-Z'' each).
/// Signs are those of the measured table.
inline constexpr std::array<std::string_view, kGirdleAngleCount> kGirdleAngleNames = {
    "sc_protraction",        // protraction +
    "sc_elevation",          // elevation -, depression +
    "sc_rotation",           // posterior rotation +
    "st_internal_rotation",  // internal rotation +
    "st_upward_rotation",    // upward rotation -
    "st_tilt",               // posterior tilt +
};

/// One angle as a linear function of the humerus's elevation and plane in the thorax.
struct LinearAngle {
  double rest_rad = 0;  ///< the angle of the resting person
  double rest_factor = 1;
  double constant_rad = 0;
  double per_elevation = 0;  ///< rad per rad of humeral elevation
  double per_plane = 0;      ///< rad per rad of plane of elevation

  /// Returns the part of the angle [rad] that depends on the arm.
  [[nodiscard]] constexpr double Change(double elevation_rad, double plane_rad) const noexcept {
    return per_elevation * elevation_rad + per_plane * plane_rad;
  }
  /// Returns the angle [rad].
  [[nodiscard]] constexpr double Angle(double elevation_rad, double plane_rad) const noexcept {
    return constant_rad + rest_factor * rest_rad + Change(elevation_rad, plane_rad);
  }
};

/// The angles of one rhythm in the order of kGirdleAngleNames. An angle that it does not define is
/// empty.
using GirdleAngles = std::array<std::optional<LinearAngle>, kGirdleAngleCount>;

/// The rhythms of a file, by their word in the file.
using RhythmCoefficients = std::map<std::string, GirdleAngles, std::less<>>;

/// Reads a file with the columns `rhythm`, `angle` (a word of kGirdleAngleNames), `rest_deg`,
/// `rest_factor`, `constant_deg`, `per_elevation` and `per_plane`. Each angle is one row. Throws
/// InputError with file and line.
[[nodiscard]] RhythmCoefficients ReadRhythmCoefficients(std::istream& in, const std::string& name);

/// Returns the coefficients of data/published_rhythms.csv.
[[nodiscard]] RhythmCoefficients BuiltInRhythmCoefficients();

}  // namespace girdle
