// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/rhythm_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace girdle::rhythm_table_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The arguments of a table, valid as they are: two planes of three elevations.
struct TableParts {
  std::vector<double> planes_rad = {RadiansFromDegrees(0), RadiansFromDegrees(40)};
  std::vector<double> elevations_rad = {RadiansFromDegrees(15), RadiansFromDegrees(20),
                                        RadiansFromDegrees(25)};
  std::vector<RhythmPosition> positions = std::vector<RhythmPosition>(6);

  [[nodiscard]] RhythmTable Build() const { return {planes_rad, elevations_rad, positions}; }
};

TEST(RhythmTable, KeepsPositionsPlaneByPlane) {
  TableParts parts;
  for (std::size_t i = 0; i < parts.positions.size(); ++i) {
    parts.positions[i].angles_rad[0] = 0.1 * static_cast<double>(i);
  }
  const RhythmTable table = parts.Build();
  EXPECT_EQ(table.planes_rad(), parts.planes_rad);
  EXPECT_EQ(table.elevations_rad(), parts.elevations_rad);
  for (std::size_t plane = 0; plane < 2; ++plane) {
    for (std::size_t elevation = 0; elevation < 3; ++elevation) {
      EXPECT_EQ(table.position(plane, elevation).angles_rad[0],
                parts.positions[3 * plane + elevation].angles_rad[0]);
    }
  }
}

TEST(RhythmTable, TakesAnglesOfHalfATurn) {
  TableParts parts;
  parts.positions[1].angles_rad[2] = kPi;
  parts.positions[2].angles_rad[5] = -kPi;
  EXPECT_NO_THROW(static_cast<void>(parts.Build()));
}

struct Flaw {
  const char* name;
  std::function<void(TableParts&)> change;
  const char* message;
};

void PrintTo(const Flaw& flaw, std::ostream* out) { *out << flaw.name; }

class FlawedTable : public testing::TestWithParam<Flaw> {};

TEST_P(FlawedTable, IsRefusedWithIndexAndValue) {
  TableParts parts;
  GetParam().change(parts);
  try {
    static_cast<void>(parts.Build());
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()), GetParam().message);
  }
}

INSTANTIATE_TEST_SUITE_P(
    OneFlawEach, FlawedTable,
    testing::Values(
        Flaw{"one plane",
             [](TableParts& parts) {
               parts.planes_rad.resize(1);
               parts.positions.resize(3);
             },
             "planes: 1 given, at least 2 are needed to interpolate"},
        Flaw{"one elevation",
             [](TableParts& parts) {
               parts.elevations_rad.resize(1);
               parts.positions.resize(2);
             },
             "elevations: 1 given, at least 2 are needed to interpolate"},
        Flaw{"a plane that is not a number", [](TableParts& parts) { parts.planes_rad[1] = kNan; },
             "planes[1] is not finite"},
        Flaw{"an infinite plane", [](TableParts& parts) { parts.planes_rad[1] = kInfinity; },
             "planes[1] is not finite"},
        Flaw{"an elevation that is not a number",
             [](TableParts& parts) { parts.elevations_rad[0] = kNan; },
             "elevations[0] is not finite"},
        Flaw{"a plane twice", [](TableParts& parts) { parts.planes_rad[1] = parts.planes_rad[0]; },
             "planes[1] = 0.000000 deg does not increase"},
        Flaw{"elevations in disorder",
             [](TableParts& parts) { parts.elevations_rad[2] = RadiansFromDegrees(18); },
             "elevations[2] = 18.000000 deg does not increase"},
        Flaw{"a position too few", [](TableParts& parts) { parts.positions.pop_back(); },
             "the grid needs 6 positions, 5 given"},
        Flaw{"a position too many", [](TableParts& parts) { parts.positions.emplace_back(); },
             "the grid needs 6 positions, 7 given"},
        Flaw{"an angle above half a turn",
             [](TableParts& parts) { parts.positions[4].angles_rad[7] = RadiansFromDegrees(181); },
             "position 4: gh_flexion = 181.000000 deg is not within [-180, 180]"},
        Flaw{"an angle below half a turn",
             [](TableParts& parts) { parts.positions[0].angles_rad[0] = RadiansFromDegrees(-181); },
             "position 0: sc_protraction = -181.000000 deg is not within [-180, 180]"},
        Flaw{"an angle that is not a number",
             [](TableParts& parts) { parts.positions[5].angles_rad[8] = kNan; },
             "position 5: gh_axial = nan deg is not within [-180, 180]"}));

// "Every value is finite and every angle within [-pi, pi]."
TEST(RhythmTable, RefusesAPublishedScapulaAngleThatIsNotFinite) {
  TableParts parts;
  parts.positions[3].scapulothoracic_rad = Vector3(0.1, kNan, 0.2);
  EXPECT_THROW(static_cast<void>(parts.Build()), std::invalid_argument);
}

TEST(RhythmTable, RefusesAPublishedScapulaAngleAboveHalfATurn) {
  TableParts parts;
  parts.positions[3].scapulothoracic_rad = Vector3(0.1, RadiansFromDegrees(181), 0.2);
  EXPECT_THROW(static_cast<void>(parts.Build()), std::invalid_argument);
}

struct CellCase {
  double elevation_deg;
  double plane_deg;
  std::size_t elevation_index;
  std::size_t plane_index;
};

void PrintTo(const CellCase& cell, std::ostream* out) {
  *out << "elevation " << cell.elevation_deg << ", plane " << cell.plane_deg;
}

// Planes 0, 40, 90; elevations 15, 20, 30, 60.
RhythmTable UnevenTable() {
  const auto radians = [](std::vector<double> knots_deg) {
    for (double& knot : knots_deg) knot = RadiansFromDegrees(knot);
    return knots_deg;
  };
  return {radians({0, 40, 90}), radians({15, 20, 30, 60}), std::vector<RhythmPosition>(12)};
}

class CellOf : public testing::TestWithParam<CellCase> {};

// Where the place is, by its cell and weights, and the nearest of the grid to what was asked.
TEST_P(CellOf, APlaceHoldsIt) {
  const RhythmTable table = UnevenTable();
  const CellCase& at = GetParam();
  const RhythmCell cell =
      table.CellAt(RadiansFromDegrees(at.elevation_deg), RadiansFromDegrees(at.plane_deg));
  EXPECT_EQ(cell.elevation_index, at.elevation_index);
  EXPECT_EQ(cell.plane_index, at.plane_index);
  const auto place_deg = [](const std::vector<double>& knots_rad, std::size_t i, double weight) {
    return DegreesFromRadians(knots_rad.at(i) + weight * (knots_rad.at(i + 1) - knots_rad.at(i)));
  };
  const auto nearest_deg = [](double asked_deg, double lowest_deg, double highest_deg) {
    return std::isnan(asked_deg) ? lowest_deg : std::clamp(asked_deg, lowest_deg, highest_deg);
  };
  EXPECT_NEAR(place_deg(table.elevations_rad(), cell.elevation_index, cell.elevation_weight),
              nearest_deg(at.elevation_deg, 15, 60), 1e-12);
  EXPECT_NEAR(place_deg(table.planes_rad(), cell.plane_index, cell.plane_weight),
              nearest_deg(at.plane_deg, 0, 90), 1e-12);
}

// theta_i < theta <= theta_i+1 (6), psi_j < psi <= psi_j+1 (7); the lowest knots belong to the
// first cells.
INSTANTIATE_TEST_SUITE_P(Places, CellOf,
                         testing::Values(CellCase{15, 0, 0, 0}, CellCase{20, 40, 0, 0},
                                         CellCase{20.000001, 40.000001, 1, 1},
                                         CellCase{45, 65, 2, 1}, CellCase{60, 90, 2, 1},
                                         CellCase{14, -1, 0, 0}, CellCase{61, 91, 2, 1},
                                         CellCase{1e300, -1e300, 2, 0},
                                         CellCase{kInfinity, -kInfinity, 2, 0},
                                         CellCase{kNan, 65, 0, 1}, CellCase{45, kNan, 2, 0}));

}  // namespace
}  // namespace girdle::rhythm_table_test
