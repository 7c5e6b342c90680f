// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/solve_columns.h"

#include <array>
#include <cstddef>
#include <string>

#include "names/model_names.h"

namespace girdle {
namespace {

using Stems = std::vector<std::string>;

constexpr std::array<const char*, 3> kAxes = {"_x", "_y", "_z"};

Stems AngleStems(const SolveAdditions& /*additions*/) {
  return {kCoordinateNames.begin(), kCoordinateNames.end()};
}

// A joint's turn with elevation along three axes, with plane along three, and so for each joint.
constexpr std::size_t kRatesOfJoint = 2 * kAxes.size();
Stems RateStems(const SolveAdditions& additions) {
  Stems stems;
  for (const char* joint : {"sc", "ac", "gh"}) {
    for (const char* by : {"_w_elevation", "_w_plane"}) {
      for (const char* axis : kAxes) {
        if (additions.rates) {
          stems.push_back(std::string(joint) + by + axis);
        }
      }
    }
  }
  return stems;
}

Stems PointStems(const SolveAdditions& additions) {
  Stems stems;
  if (additions.points_of) {
    for (const ShoulderPoint& point : ShoulderPoints(*additions.points_of, {})) {
      for (const char* axis : kAxes) {
        stems.push_back(point.name + axis);
      }
    }
  }
  return stems;
}

Cell Rate(const SolvedRow& row, std::size_t k) {
  const AngularRate& rate = row.rates->joints[k / kRatesOfJoint];
  const std::size_t component = k % kRatesOfJoint;
  const Vector3& w = component < kAxes.size() ? rate.by_elevation : rate.by_plane;
  return w[static_cast<int>(component % kAxes.size())];
}

// In the order of the output. Further columns are a line here.
constexpr std::array<OutputColumns<SolvedRow, SolveAdditions>, 9> kSolveColumns = {{
    {AngleStems, kDegrees,
     [](const SolvedRow& row, std::size_t k) -> Cell {
       return DegreesFromRadians(row.angles_rad[k]);
     }},
    {[](const SolveAdditions&) { return Stems{std::string(kClampedStem)}; }, kNoUnit,
     [](const SolvedRow& row, std::size_t) -> Cell { return row.clamped ? 1.0 : 0.0; }},
    {[](const SolveAdditions&) {
       return Stems{std::string(kUsedElevationStem), std::string(kUsedPlaneStem)};
     },
     kDegrees,
     [](const SolvedRow& row, std::size_t k) -> Cell {
       return DegreesFromRadians(k == 0 ? row.used.elevation_rad : row.used.plane_rad);
     }},
    {[](const SolveAdditions&) { return Stems{std::string(kDistanceStem)}; }, kDegrees,
     [](const SolvedRow& row, std::size_t) -> Cell {
       return DegreesFromRadians(row.distance_rad);
     }},
    {[](const SolveAdditions&) { return Stems{std::string(kOriginStem)}; }, kNoUnit,
     [](const SolvedRow& row, std::size_t) -> Cell { return Name(row.origin); }},
    {[](const SolveAdditions&) {
       return Stems{kUsedAxialNames.begin(), kUsedAxialNames.end()};
     },
     kDegrees,
     [](const SolvedRow& row, std::size_t k) -> Cell {
       return DegreesFromRadians(k == 0 ? row.used.axial_rad : row.used_axial_isb_rad);
     }},
    {[](const SolveAdditions&) {
       return Stems{kUsedOffsetNames.begin(), kUsedOffsetNames.end()};
     },
     kDegrees,
     [](const SolvedRow& row, std::size_t k) -> Cell {
       return DegreesFromRadians(k == 0 ? row.used.shrug_rad : row.used.protraction_rad);
     }},
    {RateStems, kNoUnit, Rate},
    {PointStems, kMillimeters,
     [](const SolvedRow& row, std::size_t k) -> Cell {
       return row.points[k / kAxes.size()].p_mm[static_cast<int>(k % kAxes.size())];
     }},
}};

}  // namespace

WrittenColumns<SolvedRow, AppendRounded> SolveColumns(const SolveAdditions& additions) {
  return {kSolveColumns, additions};
}

}  // namespace girdle
