// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The angles of the arm as people write them: signs, units, bounds.
///
/// Girdle and ISB's Y-X'-Y'' of the humerus in the thorax (Wu et al., J Biomech 2005;38:981) both
/// write a plane of elevation about the thorax's y, 0 in abduction and 90 in forward flexion, an
/// elevation and an axial rotation. They differ in the sign of the elevation,
///
/// - Girdle: the angle between the humerus and hanging down, 0 to 180.
/// - ISB: a turn about x, which raises the arm where it is negative, 0 to -180;
///
/// and in what the axial rotation counts from: Girdle's from the rhythm's own turn, ISB's as the
/// third angle (AxialFrom).
///
/// ISB's three angles write every rotation twice: (plane, e, axial) and (plane + 180, -e, axial +
/// 180). The second way is refused instead of read: a file with the other sign of the elevation
/// would otherwise be an arm that points backwards.
///
/// Every function throws std::invalid_argument; its message says what is expected and how to mend
/// it, and whoever read the angle puts place and value before it.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "kinematics/shoulder_rhythm.h"
#include "kinematics/words.h"

namespace girdle {

/// Which sign the elevation of a raised arm has.
enum class AngleConvention { kGirdle, kIsb };
inline constexpr std::array<std::string_view, 2> kAngleConventionNames = {"girdle", "isb"};
constexpr const auto& WordsOf(AngleConvention /*which*/) noexcept { return kAngleConventionNames; }

/// The unit of angles in a file, whatever its columns are called.
enum class AngleUnit { kDegree, kRadian };
inline constexpr std::array<std::string_view, 2> kAngleUnitNames = {"deg", "rad"};
constexpr const auto& WordsOf(AngleUnit /*which*/) noexcept { return kAngleUnitNames; }

/// How the angles of a file are to be read.
struct AngleReading {
  AngleConvention convention = AngleConvention::kGirdle;
  /// If nothing: degrees, and a file that looks like radians is refused (AngleSpan).
  std::optional<AngleUnit> unit = std::nullopt;
  AxialFrom axial_from = AxialFrom::kRhythm;  ///< what a column of axial turns counts from
  /// Whether a file has to have that column: somebody said what it counts from.
  bool must_have_axial = false;
  /// Whether rows of a file without that column have the axial turn of an option.
  bool has_axial_option = false;
};

/// An elevation may be beyond its ends by as much [deg], as rounding and filters make it, and is
/// read as that end. A hanging arm that shakes never is: its elevation is an angle from hanging,
/// and what changes is the plane.
inline constexpr double kElevationRounding_deg = 0.5;

/// A plane or an axial rotation may have gone round so often; far beyond, its digits say nothing.
inline constexpr double kMostTurned_deg = 3600;

/// Returns an elevation as Girdle counts it, within 0 to 180 [deg]. If an axial turn stands beside
/// it, the message about another sign says what that means for the axial turn.
[[nodiscard]] double ElevationRead_deg(double elevation_deg, AngleConvention convention,
                                       bool has_axial = false);

/// Returns a plane within -180 to 180 [deg]: 350 is -10, 181 is -179. One that is within already
/// stays as it is.
[[nodiscard]] double PlaneRead_deg(double plane_deg);

/// Returns an axial rotation [deg], whatever it counts from.
[[nodiscard]] double AxialRead_deg(double axial_deg);

}  // namespace girdle
