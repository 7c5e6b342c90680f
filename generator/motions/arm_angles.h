// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The angles of the arm in files and options: signs, units, bounds.
///
/// Girdle and the ISB (Y-X'-Y'' of the humerus in the thorax, Wu et al., J Biomech 2005;38:981) use
/// the same plane of elevation: about the thorax's y, 0 in abduction, 90 in forward flexion. They
/// differ in two angles.
///
/// - Elevation: for Girdle it is the angle between the humerus and hanging down, 0 to 180. For the
///   ISB it is a turn about x, which raises the arm if it is negative, 0 to -180.
/// - Axial rotation: Girdle counts it from the rhythm's own turn. The ISB counts it as the third
///   angle (AxialFrom).
///
/// The three angles of the ISB describe every rotation in two ways: (plane, e, axial) and (plane +
/// 180, -e, axial + 180). The second way is an error here. Otherwise a file with the wrong sign of
/// the elevation would become an arm that points backwards.
///
/// Every function throws std::invalid_argument. The message says what is expected and how to
/// correct it. The caller puts place and value before it.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "kinematics/shoulder_rhythm.h"
#include "kinematics/words.h"

namespace girdle {

/// The sign that the elevation of a raised arm has.
enum class AngleConvention { kGirdle, kIsb };
inline constexpr std::array<std::string_view, 2> kAngleConventionNames = {"girdle", "isb"};
constexpr const auto& WordsOf(AngleConvention /*which*/) noexcept { return kAngleConventionNames; }

/// The unit of the angles in a file, whatever the names of its columns are.
enum class AngleUnit { kDegree, kRadian };
inline constexpr std::array<std::string_view, 2> kAngleUnitNames = {"deg", "rad"};
constexpr const auto& WordsOf(AngleUnit /*which*/) noexcept { return kAngleUnitNames; }

/// How the angles of a file are read.
struct AngleReading {
  AngleConvention convention = AngleConvention::kGirdle;
  /// If empty: degrees, and a file that looks like radians is an error (AngleSpan).
  std::optional<AngleUnit> unit = std::nullopt;
  AxialFrom axial_from = AxialFrom::kRhythm;  ///< zero of a column of axial turns
  /// Whether a file must have a column of axial turns, because its zero was given.
  bool must_have_axial = false;
  /// Whether an option gives the axial turn if a file has no column for it.
  bool has_axial_option = false;
};

/// Rounding and filters may put an elevation beyond its range by this much [deg]. It is then read
/// as the end of the range. A hanging arm that trembles never leaves the range: its elevation is
/// the angle from hanging, and the plane changes instead.
inline constexpr double kElevationRounding_deg = 0.5;

/// Largest plane and axial rotation [deg], since an angle may be counted over several turns. The
/// digits of a far larger one mean nothing.
inline constexpr double kMostTurned_deg = 3600;

/// Returns an elevation in Girdle's convention, 0 to 180 [deg]. If the file has axial turns too
/// (`has_axial`), the message about a wrong sign says what it means for them.
[[nodiscard]] double ElevationRead_deg(double elevation_deg, AngleConvention convention,
                                       bool has_axial = false);

/// Returns a plane within -180 to 180 [deg]: 350 becomes -10, 181 becomes -179. A plane that is
/// within already is unchanged.
[[nodiscard]] double PlaneRead_deg(double plane_deg);

/// Returns an axial rotation [deg] with any zero, unchanged.
[[nodiscard]] double AxialRead_deg(double axial_deg);

}  // namespace girdle
