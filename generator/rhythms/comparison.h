// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Published rhythms held against the measured one over a map of elevations and planes.
///
/// At every position the humerus of all rhythms is where the measured one has it (q_TH), so that
/// differences come from the girdle alone. Positions at which the measured rhythm is clamped, so
/// that it stands for another position, are left out of everything. What a rhythm does not say is
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

/// What is compared. The first three are the angle of the rotation between the two, never negative;
/// the others are published minus measured Y-X'-Z'' angle, within [-pi, pi]. Where a scapula is
/// near 90 degrees of upward rotation its other two angles run away together; kGh stays true there.
enum class ComparedAngle {
  kSc,  ///< clavicle in thorax
  kAc,  ///< scapula in clavicle
  kGh,  ///< humerus in scapula; with the same humerus this is also the scapula in the thorax
  kProtraction,
  kClavicleElevation,  ///< clavicle higher: negative
  kInternalRotation,
  kUpwardRotation,  ///< scapula further upward: negative
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

/// Differences [rad] in the order of ComparedAngle; nothing where the rhythm does not say enough.
using Differences = std::array<std::optional<double>, kDifferenceCount>;

/// Positions of a map: every elevation with every plane.
struct ComparisonMap {
  std::vector<double> elevations_rad;
  std::vector<double> planes_rad;
};

/// A position and the measured rhythm there.
struct MapPosition {
  double elevation_rad;
  double plane_rad;
  ShoulderPose measured;
  bool is_in_table;  ///< within the elevations and planes of the table
};

/// Returns the positions of the map at which the rhythm is not clamped, elevation by elevation.
[[nodiscard]] std::vector<MapPosition> PositionsOf(const ShoulderRhythm& measured,
                                                   const ComparisonMap& map);

/// Returns how a girdle differs from the measured one at a position.
[[nodiscard]] Differences DifferencesAt(const MapPosition& position, const GirdlePose& girdle,
                                        const SaidAngles& said) noexcept;

/// A difference over many positions, each counted once. All in radians.
struct DifferenceSummary {
  double rms_rad = 0;
  double largest_rad = 0;    ///< the one of largest magnitude, with its sign
  double elevation_rad = 0;  ///< where it is
  /// Nothing at elevations 0 and 180, where the plane of an arm has no meaning.
  std::optional<double> plane_rad = std::nullopt;
};

/// In the order of ComparedAngle; nothing where nothing was compared.
using DifferenceSummaries = std::array<std::optional<DifferenceSummary>, kDifferenceCount>;

struct RhythmComparison {
  PublishedRhythm rhythm;
  DifferenceSummaries in_table;
  DifferenceSummaries on_map;
};

/// Elevation from which scapulohumeral ratios count: lower the table is partly derived.
inline constexpr double kRatioFrom_rad = 30 * kRadiansPerDegree;

/// Returns (change of humeral elevation - change of upward rotation) / change of upward rotation:
/// degrees in the glenohumeral joint per degree of the scapula. Upward rotation is the second
/// Y-X'-Z'' angle of the scapula in the thorax, upwards +; humeral elevation is that commanded;
/// both as changes from kRatioFrom_rad. Nothing if the scapula does not turn.
[[nodiscard]] std::optional<double> ScapulohumeralRatio(double elevation_change_rad,
                                                        double upward_rotation_change_rad) noexcept;

struct RatioRow {
  double plane_rad;
  double elevation_rad;
  /// Nothing where the measured rhythm is clamped, here or at kRatioFrom_rad.
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
  std::vector<RatioRow> ratios;  ///< in planes 0, 40 and 90, whatever the map

  [[nodiscard]] std::size_t position_count() const noexcept {
    return map.elevations_rad.size() * map.planes_rad.size();
  }
};

/// Returns the comparison of all rhythms with the measured one.
[[nodiscard]] Comparison Compare(const ShoulderRhythm& measured,
                                 const std::vector<PublishedRhythm>& published,
                                 const ComparisonMap& map);

}  // namespace girdle
