// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Compares published rhythms with the measured one over a map of elevations and planes.
///
/// At every position all rhythms have the humerus of the measured one (q_TH), so differences come
/// from the girdle alone. A position at which the measured rhythm is clamped is omitted everywhere,
/// because the answer there belongs to another position. An angle that a rhythm does not define is
/// not compared.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "kinematics/shoulder_rhythm.h"
#include "rhythms/published_rhythms.h"

namespace girdle {

/// The compared angles. The first three are the angle of the rotation between both rhythms, never
/// negative. The others are the published minus the measured Y-X'-Z'' angle, within [-pi, pi]. Near
/// 90 degrees of upward rotation the other two angles of a scapula diverge together; kGh stays
/// correct there.
enum class ComparedAngle {
  kSc,  ///< clavicle in thorax
  kAc,  ///< scapula in clavicle
  kGh,  ///< humerus in scapula; with equal humeri it is also the scapula in the thorax
  kProtraction,
  kClavicleElevation,  ///< negative if the clavicle is higher
  kInternalRotation,
  kUpwardRotation,  ///< negative if the scapula is further upward
  kTilt,
};
inline constexpr std::size_t kDifferenceCount = 8;
inline constexpr std::array<std::string_view, kDifferenceCount> kDifferenceNames = {
    "sc",
    "ac",
    "gh",
    "sc_protraction",
    "sc_elevation",
    "st_internal_rotation",
    "st_upward_rotation",
    "st_tilt",
};

/// Differences [rad] in the order of ComparedAngle. Empty if the rhythm does not define enough
/// angles.
using Differences = std::array<std::optional<double>, kDifferenceCount>;

/// Positions of a map: all combinations of an elevation and a plane.
struct ComparisonMap {
  std::vector<double> elevations_rad;
  std::vector<double> planes_rad;
};

/// A position and the measured rhythm there.
struct MapPosition {
  double elevation_rad;
  double plane_rad;
  ShoulderPose measured;
  bool is_in_table;  ///< within the table's elevations and planes
};

/// Returns the positions of the map at which the rhythm is not clamped, elevation by elevation.
[[nodiscard]] std::vector<MapPosition> PositionsOf(const ShoulderRhythm& measured,
                                                   const ComparisonMap& map);

/// Returns the differences between a girdle and the measured one at a position.
[[nodiscard]] Differences DifferencesAt(const MapPosition& position, const GirdlePose& girdle,
                                        const DefinedAngles& defined) noexcept;

/// Summary of a difference over many positions, each counted once. All in radians.
struct DifferenceSummary {
  double rms_rad = 0;
  double largest_rad = 0;    ///< the value of largest magnitude, with its sign
  double elevation_rad = 0;  ///< of the largest value
  /// Plane of the largest value. Empty at elevations 0 and 180, where the plane of an arm has no
  /// meaning.
  std::optional<double> plane_rad = std::nullopt;
};

/// Summaries in the order of ComparedAngle. Empty if nothing was compared.
using DifferenceSummaries = std::array<std::optional<DifferenceSummary>, kDifferenceCount>;

struct RhythmComparison {
  PublishedRhythm rhythm;
  DifferenceSummaries in_table;
  DifferenceSummaries on_map;
};

/// Scapulohumeral ratios are computed from this elevation on. Below it the table is partly derived.
inline constexpr double kRatioFrom_rad = 30 * kRadiansPerDegree;

/// Returns (change of humeral elevation - change of upward rotation) / change of upward rotation:
/// degrees in the glenohumeral joint per degree of the scapula. Humeral elevation is the commanded
/// one. Upward rotation is the second Y-X'-Z'' angle of the scapula in the thorax, counted positive
/// upwards. Both are changes from kRatioFrom_rad. Returns nothing if the scapula does not turn.
[[nodiscard]] std::optional<double> ScapulohumeralRatio(double elevation_change_rad,
                                                        double upward_rotation_change_rad) noexcept;

struct RatioRow {
  double plane_rad;
  double elevation_rad;
  /// Empty if the measured rhythm is clamped at this elevation or at kRatioFrom_rad.
  std::optional<double> measured;
  std::vector<std::optional<double>> published;  ///< in the order of the rhythms
};

struct Comparison {
  RhythmOptions options;  ///< of the measured rhythm
  ComparisonMap map;
  std::size_t compared_on_map = 0;  ///< positions that are not clamped
  std::size_t compared_in_table = 0;
  double table_from_elevation_rad = 0;
  double table_to_elevation_rad = 0;
  double table_from_plane_rad = 0;
  double table_to_plane_rad = 0;
  std::vector<RhythmComparison> rhythms;
  std::vector<RatioRow> ratios;  ///< in planes 0, 40 and 90, for any map

  [[nodiscard]] std::size_t position_count() const noexcept {
    return map.elevations_rad.size() * map.planes_rad.size();
  }
};

/// Returns the comparison of all published rhythms with the measured one.
[[nodiscard]] Comparison Compare(const ShoulderRhythm& measured,
                                 const std::vector<PublishedRhythm>& published,
                                 const ComparisonMap& map);

}  // namespace girdle
