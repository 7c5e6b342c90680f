// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "residuals/skin_residuals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "anatomy/built_in_anatomy.h"
#include "residuals/skinned_model.h"
#include "rhythm_tables/built_in_tables.h"
#include "simulation/engine_fixture.h"

namespace girdle::skin_residuals_test {
namespace {

constexpr const char* kOverElevationDrawn = "jump of AC skin over elevation knots, MuJoCo";
constexpr const char* kOverElevation = "jump of AC skin over elevation knots, linear blend";
constexpr const char* kOverPlaneDrawn = "jump of AC skin over plane knots, MuJoCo";
constexpr const char* kOverPlane = "jump of AC skin over plane knots, linear blend";
const std::set<std::string> kJumps = {kOverElevationDrawn, kOverElevation, kOverPlaneDrawn,
                                      kOverPlane};

// What passes unless the interpolation has a bound of its own [mm/deg].
constexpr double kDrawn = 0.01;
constexpr double kBlended = 1e-6;

// The thorax somewhere else in the world.
ModelFiles MovedTo(const std::string& place) {
  ModelFiles files = SkinnedModel();
  std::string& xml = files.front().second;
  const std::size_t pos = xml.find("pos=\"", xml.find("<body name=\"thorax\"")) + 5;
  xml.replace(pos, xml.find('"', pos) - pos, place);
  return files;
}

class SkinJumps : public EngineTest {
 protected:
  static std::vector<Residual> Measure(const ShoulderRhythm& rhythm, Side side = Side::kRight,
                                       const ModelFiles& files = SkinnedModel(),
                                       GirdleMotion girdle = GirdleMotion::kMeasured) {
    LoadedShoulders loaded(LoadModel(files), "shoulder.xml");
    loaded.Watch(side);
    ShoulderSimulation simulation(std::move(loaded), AssembledRhythm(rhythm, Assembly::kTree));
    SkinMeter meter(simulation, simulation.rhythm(), BuiltInAnatomy(), girdle);
    return meter.Measure();
  }

  static Residual Line(const std::vector<Residual>& lines, const std::string& item) {
    const auto found = std::find_if(lines.begin(), lines.end(),
                                    [&](const Residual& line) { return line.item == item; });
    if (found == lines.end()) {
      ADD_FAILURE() << "no line for " << item;
      return {"", item, std::numeric_limits<double>::quiet_NaN(), "", 0.0, ""};
    }
    return *found;
  }

  static std::set<std::string> Failed(const std::vector<Residual>& lines) {
    std::set<std::string> failed;
    for (const Residual& line : lines) {
      if (!line.passed() && kJumps.contains(line.item)) {
        failed.insert(line.item);
      }
    }
    return failed;
  }
};

TEST_F(SkinJumps, PassOnTheSmoothRhythmOfEachSide) {
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const std::vector<Residual> lines = Measure(BuiltInRhythm(), side);
    EXPECT_EQ(Failed(lines), std::set<std::string>{}) << Name(side);
    for (const char* const item : {kOverElevationDrawn, kOverPlaneDrawn}) {
      EXPECT_EQ(Line(lines, item).tolerance, kDrawn);
      // The step was chosen for noise of a tenth.
      EXPECT_LT(Line(lines, item).value, kDrawn / 2) << item;
    }
    for (const char* const item : {kOverElevation, kOverPlane}) {
      EXPECT_EQ(Line(lines, item).tolerance, kBlended);
      EXPECT_LT(Line(lines, item).value, kBlended / 10) << item;
    }
  }
}

TEST_F(SkinJumps, FailOnSlerpBothWaysInBothDirections) {
  for (const Closure closure : {Closure::kTable, Closure::kExact}) {
    const std::vector<Residual> lines = Measure(BuiltInRhythm({Interpolation::kSlerp, closure}));
    EXPECT_EQ(Failed(lines), kJumps) << Name(closure);
    // Its planes are uneven too, and that is no excuse of slerp's.
    for (const char* const item : {kOverElevationDrawn, kOverPlaneDrawn}) {
      EXPECT_EQ(Line(lines, item).tolerance, kDrawn);
    }
    for (const char* const item : {kOverElevation, kOverPlane}) {
      EXPECT_EQ(Line(lines, item).tolerance, kBlended);
    }
    // The two ways measure one thing.
    EXPECT_NEAR(Line(lines, kOverElevationDrawn).value, Line(lines, kOverElevation).value, 0.05);
    EXPECT_NEAR(Line(lines, kOverPlaneDrawn).value, Line(lines, kOverPlane).value, 0.05);
  }
}

TEST_F(SkinJumps, OfSquadAreBoundedOverUnevenPlanesAndPassOverElevations) {
  const std::vector<Residual> lines =
      Measure(BuiltInRhythm({Interpolation::kSquad, Closure::kTable}));
  EXPECT_EQ(Failed(lines), std::set<std::string>{});
  EXPECT_EQ(Line(lines, kOverElevation).tolerance, kBlended);
  EXPECT_EQ(Line(lines, kOverElevationDrawn).tolerance, kDrawn);
  for (const char* const item : {kOverPlane, kOverPlaneDrawn}) {
    const Residual line = Line(lines, item);
    EXPECT_EQ(line.tolerance, 0.2);
    EXPECT_GT(line.value, kDrawn) << "needs no bound of its own";
    EXPECT_NE(line.where.find("knots 40 and 50 deg apart"), std::string::npos) << line.where;
  }
}

// A table of one's own: one angle of the clavicle changes, all others are 0. A row is bent.
RhythmTable TableOf(const std::vector<double>& planes_deg,
                    const std::vector<double>& elevations_deg, double bent_deg) {
  std::vector<double> planes_rad;
  std::vector<double> elevations_rad;
  std::vector<RhythmPosition> positions;
  for (const double plane_deg : planes_deg) {
    planes_rad.push_back(RadiansFromDegrees(plane_deg));
    for (const double elevation_deg : elevations_deg) {
      RhythmPosition position;
      position.angles_rad[0] = RadiansFromDegrees(-30 + elevation_deg / 8 + plane_deg / 20);
      positions.push_back(position);
    }
  }
  elevations_rad.reserve(elevations_deg.size());
  for (const double elevation_deg : elevations_deg) {
    elevations_rad.push_back(RadiansFromDegrees(elevation_deg));
  }
  positions[elevations_deg.size() + 1].angles_rad[0] += RadiansFromDegrees(bent_deg);
  return {planes_rad, elevations_rad, positions};
}

// Slerp of a turn about one axis at one speed has no corner; a bent row has one.
TEST_F(SkinJumps, OfATableOfTheUsersOwnAreThatTables) {
  for (const double bent_deg : {0.0, 3.0}) {
    const ShoulderRhythm rhythm(TableOf({0, 45, 90}, {30, 60, 90, 120}, bent_deg),
                                {Interpolation::kSlerp, Closure::kTable});
    const std::vector<Residual> lines = Measure(rhythm);
    EXPECT_EQ(Failed(lines), bent_deg == 0 ? std::set<std::string>{} : kJumps);
    for (const std::string& item : kJumps) {
      EXPECT_LT(Line(lines, item).tolerance.value(), 0.02) << item;
    }
  }
}

// (5) holds for even knots: no bound of its own is due.
TEST_F(SkinJumps, OfSquadOverEvenPlanesHaveNoBoundOfTheirOwn) {
  const ShoulderRhythm rhythm(TableOf({0, 45, 90}, {30, 60, 90, 120}, 3),
                              {Interpolation::kSquad, Closure::kTable});
  const std::vector<Residual> lines = Measure(rhythm);
  EXPECT_EQ(Failed(lines), std::set<std::string>{});
  EXPECT_EQ(Line(lines, kOverPlane).tolerance, kBlended);
}

TEST_F(SkinJumps, OfSquadOverUnevenElevationsAreBoundedToo) {
  const ShoulderRhythm rhythm(TableOf({0, 45, 90}, {30, 60, 80, 120}, 3),
                              {Interpolation::kSquad, Closure::kTable});
  const std::vector<Residual> lines = Measure(rhythm);
  const Residual line = Line(lines, kOverElevation);
  EXPECT_EQ(line.tolerance, 0.2);
  EXPECT_GT(line.value, kBlended);
  EXPECT_NE(line.where.find("knots 30 and 20 deg apart"), std::string::npos) << line.where;
}

// Between two planes there is no line to cross, and nothing that could fail.
TEST_F(SkinJumps, AreStatedToBeNoneWhereATableHasNoInnerKnots) {
  const ShoulderRhythm rhythm(TableOf({0, 90}, {30, 60, 90, 120}, 3),
                              {Interpolation::kSlerp, Closure::kTable});
  const std::vector<Residual> lines = Measure(rhythm);
  for (const char* const item : {kOverPlane, kOverPlaneDrawn}) {
    EXPECT_EQ(Line(lines, item).tolerance, std::nullopt);
    EXPECT_EQ(Line(lines, item).where, "the table has no inner knots");
  }
  EXPECT_EQ(Failed(lines), (std::set<std::string>{kOverElevation, kOverElevationDrawn}));
}

// Single precision is coarser there, and the step of the differences longer.
TEST_F(SkinJumps, AreMeasuredAwayFromTheWorldsOriginToo) {
  const auto files = MovedTo("3 -2 0.5");
  EXPECT_EQ(Failed(Measure(BuiltInRhythm(), Side::kRight, files)), std::set<std::string>{});
  EXPECT_EQ(
      Failed(Measure(BuiltInRhythm({Interpolation::kSlerp, Closure::kTable}), Side::kRight, files)),
      kJumps);
}

TEST_F(SkinJumps, OfAFrozenGirdleAreThoseOfTheArmAlone) {
  const ShoulderRhythm slerp = BuiltInRhythm({Interpolation::kSlerp, Closure::kTable});
  const std::vector<Residual> measured = Measure(slerp);
  const std::vector<Residual> frozen =
      Measure(slerp, Side::kRight, SkinnedModel(), GirdleMotion::kFrozen);
  for (const std::string& item : kJumps) {
    EXPECT_LT(Line(frozen, item).value, Line(measured, item).value) << item;
  }
}

}  // namespace
}  // namespace girdle::skin_residuals_test
