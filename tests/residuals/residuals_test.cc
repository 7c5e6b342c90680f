// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "residuals/residuals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "anatomy/body_size.h"
#include "anatomy/built_in_anatomy.h"
#include "mjcf/shoulder_model.h"
#include "residuals/residual_report.h"
#include "rhythm_tables/built_in_tables.h"
#include "simulation/engine_fixture.h"

namespace girdle::residuals_test {
namespace {

TEST(Residual, AValueThatIsNoNumberDoesNotPass) {
  Residual residual;
  residual.tolerance = 1;
  residual.value = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(residual.passed());
  residual.value = 1;
  EXPECT_TRUE(residual.passed());
  residual.value = std::nextafter(1, 2);
  EXPECT_FALSE(residual.passed());
}

TEST(Residual, ALowerBoundIsForValuesAboveIt) {
  Residual residual;
  residual.tolerance = 8;
  residual.bound = Bound::kMoreThan;
  residual.value = 8;
  EXPECT_FALSE(residual.passed());
  residual.value = std::nextafter(8, 9);
  EXPECT_TRUE(residual.passed());
  residual.value = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(residual.passed());
}

const TextStyle kWideText{.width = 500};

TEST(ResidualReport, SaysOnWhichSideOfATolerancePasses) {
  ResidualReport report;
  report.residuals = {
      {"skin", "rises", 9, "mm", 8, "abduction", Bound::kMoreThan},
      {"skin", "jumps", 0.5, "mm/deg", 1, "abduction"},
  };
  const std::string text = ReportAsText(report, kWideText);
  EXPECT_NE(text.find("> 8  mm      pass"), std::string::npos) << text;
  EXPECT_EQ(text.find("> 1 "), std::string::npos) << text;
  const std::string json = ReportAsJson(report);
  EXPECT_NE(json.find("\"tolerance\": 8.0,\n      \"bound\": \"more than\""), std::string::npos)
      << json;
  EXPECT_NE(json.find("\"tolerance\": 1.0,\n      \"bound\": \"at most\""), std::string::npos)
      << json;
}

TEST(ResidualReport, SaysWhichLinesAreNoChecksOfTheirOwn) {
  ResidualReport report;
  report.residuals = {{"closure", "of its own", 2, "deg", std::nullopt, "abduction"},
                      {"closure", "of another", 2, "deg", std::nullopt, "abduction"}};
  report.residuals[1].follows = true;
  EXPECT_TRUE(report.passed());
  const std::string text = ReportAsText(report, kWideText);
  EXPECT_NE(text.find("-  deg   stated   abduction"), std::string::npos) << text;
  EXPECT_NE(text.find("-  deg   follows  abduction"), std::string::npos) << text;
  const std::string json = ReportAsJson(report);
  EXPECT_LT(json.find("\"follows\": false"), json.find("\"follows\": true")) << json;
}

class MeasureResidualsTest : public EngineTest {
 protected:
  // Measures the model of `rhythm` against `reference`.
  static ResidualReport Measure(const ShoulderRhythm& rhythm, const ShoulderRhythm& reference,
                                ShoulderModelOptions options = {}) {
    options.table = std::nullopt;
    const std::string xml = ShoulderModelXml(BuiltInAnatomy(), rhythm, options);
    ShoulderSimulation simulation(LoadModel({{"shoulder.xml", xml}}), "shoulder.xml");
    return MeasureResiduals(simulation, {reference, options.assembly}, BuiltInAnatomy(),
                            [](double) {});
  }

  static std::string FailedLines(const ResidualReport& report) {
    std::string text;
    for (const Residual& residual : report.residuals) {
      if (!residual.passed()) {
        text += residual.group + " " + residual.item + "\n";
      }
    }
    return text;
  }

  static const Residual* Find(const ResidualReport& report, const std::string& item) {
    const auto found = std::find_if(report.residuals.begin(), report.residuals.end(),
                                    [&](const Residual& line) { return line.item == item; });
    return found == report.residuals.end() ? nullptr : &*found;
  }

  static double ValueOf(const ResidualReport& report, const std::string& item) {
    const Residual* line = Find(report, item);
    if (line == nullptr) {
      ADD_FAILURE() << "no line for " << item;
      return std::numeric_limits<double>::quiet_NaN();
    }
    return line->value;
  }
};

TEST_F(MeasureResidualsTest, PassesForTheModelOfTheSameRhythm) {
  for (const RhythmOptions& options :
       {RhythmOptions{}, RhythmOptions{Interpolation::kSmooth, Closure::kTable},
        RhythmOptions{Interpolation::kSquad, Closure::kTable},
        RhythmOptions{Interpolation::kSlerp, Closure::kExact}}) {
    const ShoulderRhythm rhythm = BuiltInRhythm(options);
    const ResidualReport report = Measure(rhythm, rhythm);
    EXPECT_EQ(FailedLines(report), "") << Name(options.interpolation) << Name(options.closure);
    EXPECT_GT(report.residuals.size(), 20U);
  }
}

RhythmTable WithOneAngleChanged(const RhythmTable& table) {
  std::vector<RhythmPosition> positions;
  for (std::size_t plane = 0; plane < 3; ++plane) {
    for (std::size_t elevation = 0; elevation < 22; ++elevation) {
      positions.push_back(table.position(plane, elevation));
    }
  }
  positions[30].angles_rad[4] += RadiansFromDegrees(0.001);
  return {table.planes_rad(), table.elevations_rad(), positions};
}

TEST_F(MeasureResidualsTest, FailsForAModelWhoseTableHasOneAngleChanged) {
  for (const RhythmOptions& options :
       {RhythmOptions{}, RhythmOptions{Interpolation::kSquad, Closure::kTable}}) {
    const ShoulderRhythm rhythm = BuiltInRhythm(options);
    const ShoulderRhythm changed(WithOneAngleChanged(rhythm.table()), options, rhythm.ranges());
    const std::string failed = FailedLines(Measure(changed, rhythm));
    EXPECT_NE(failed.find("kinematic consistency AC\n"), std::string::npos) << failed;
    EXPECT_NE(failed.find("kinematic consistency scapula landmarks\n"), std::string::npos)
        << failed;
    EXPECT_EQ(failed.find("kinematic consistency SC\n"), std::string::npos) << failed;
  }
}

// With closure exact the arm itself points where it is told to; the plugin of a model whose arm
// follows its table does not.
TEST_F(MeasureResidualsTest, ClosureOfTheDefaultIsCheckedAndHolds) {
  const ShoulderRhythm rhythm = BuiltInRhythm();
  const ResidualReport report = Measure(rhythm, rhythm);
  for (const char* const item : {"elevation reached - commanded", "plane reached - commanded"}) {
    const Residual* line = Find(report, item);
    ASSERT_NE(line, nullptr) << item;
    ASSERT_TRUE(line->tolerance) << item << " is only stated";
    EXPECT_LE(*line->tolerance, 1e-6) << item;
    EXPECT_LE(line->value, 1e-6) << item;
  }
  // What says that the arm may miss its plane has no place here.
  EXPECT_EQ(Find(report, "plane, from elevation 30"), nullptr);
  EXPECT_EQ(Find(report, "plane, below elevation 30"), nullptr);
}

TEST_F(MeasureResidualsTest, FindsAnArmThatFollowsItsTableInsteadOfTheCommand) {
  const ShoulderRhythm table = BuiltInRhythm({Interpolation::kSmooth, Closure::kTable});
  const ShoulderRhythm exact =
      BuiltInRhythm({Interpolation::kSmooth, Closure::kExact, Range::kClamp});
  const std::string failed = FailedLines(Measure(table, exact));
  EXPECT_NE(failed.find("closure plane reached - commanded\n"), std::string::npos) << failed;
  EXPECT_NE(failed.find("kinematic consistency GH\n"), std::string::npos) << failed;
}

TEST_F(MeasureResidualsTest, VisitsAGridOfTheWholeRange) {
  const ShoulderRhythm rhythm = BuiltInRhythm();
  const ResidualReport report = Measure(rhythm, rhythm);
  // No motion goes there: as far up and back as an arm reaches, 95 deg of plane beside the lowest
  // measured elevation of the frontal one, which is nearest.
  const double up_rad = RadiansFromDegrees(62.5);
  const double lowest_rad = RadiansFromDegrees(15);
  const double cosine = std::cos(up_rad) * std::cos(lowest_rad) +
                        std::sin(up_rad) * std::sin(lowest_rad) * std::cos(RadiansFromDegrees(95));
  const Residual* farthest = Find(report, "farthest from measured data");
  ASSERT_NE(farthest, nullptr);
  EXPECT_NEAR(farthest->value, DegreesFromRadians(std::acos(cosine)), 1e-9);
  EXPECT_FALSE(farthest->tolerance);
  EXPECT_EQ(farthest->where, "grid, elevation 62.5, plane -95");
}

TEST_F(MeasureResidualsTest, StatesTheGlidingOutsideMeasuredData) {
  const ShoulderRhythm whole = BuiltInRhythm();
  const Residual* stated = nullptr;
  const ResidualReport report = Measure(whole, whole);
  stated = Find(report, "TS, AI to ellipsoid, outside measured data");
  ASSERT_NE(stated, nullptr);
  EXPECT_FALSE(stated->tolerance);
  const ShoulderRhythm clamped =
      BuiltInRhythm({Interpolation::kSmooth, Closure::kExact, Range::kClamp});
  const ResidualReport within = Measure(clamped, clamped);
  EXPECT_EQ(Find(within, "TS, AI to ellipsoid, outside measured data"), nullptr);
  EXPECT_EQ(Find(within, "farthest from measured data"), nullptr);
}

TEST_F(MeasureResidualsTest, FindsTheBonesOfAnotherPerson) {
  const ShoulderRhythm rhythm = BuiltInRhythm();
  const Anatomy small = ScaledAnatomy(BuiltInAnatomy(), {.stature_m = 1.5});
  ShoulderSimulation simulation(
      LoadModel({{"shoulder.xml", ShoulderModelXml(small, rhythm, {.table = std::nullopt})}}),
      "shoulder.xml");
  const std::string failed = FailedLines(
      MeasureResiduals(simulation, {rhythm, Assembly::kTree}, BuiltInAnatomy(), [](double) {}));
  EXPECT_NE(failed.find(std::string(kBonesGroup) + " landmarks\n"), std::string::npos) << failed;
}

TEST_F(MeasureResidualsTest, TakesModelsWithOffsetsAndRates) {
  const ShoulderRhythm rhythm = BuiltInRhythm();
  const ResidualReport report = Measure(rhythm, rhythm, {.has_offsets = true, .has_rates = true});
  EXPECT_EQ(FailedLines(report), "");
  const ResidualReport without = Measure(rhythm, rhythm);
  const auto moving_deg = [](const ResidualReport& measured) {
    double largest = 0;
    for (const Residual& line : measured.residuals) {
      if (line.group == "tracking moving") largest = std::max(largest, line.value);
    }
    return largest;
  };
  // Fed forward, the joints lag by what their inertia costs.
  EXPECT_LT(moving_deg(report), moving_deg(without) / 4)
      << moving_deg(report) << ", without " << moving_deg(without);
}

TEST_F(MeasureResidualsTest, FindsTheClosureThatIsKnownOfTheTable) {
  const ShoulderRhythm rhythm = BuiltInRhythm({Interpolation::kSquad, Closure::kTable});
  const ResidualReport report = Measure(rhythm, rhythm);
  // Known of the rows: -1.7 to +1.3 deg; between them squad adds a little.
  EXPECT_NEAR(ValueOf(report, "elevation reached - commanded"), 1.7, 0.1);
  // Known of the rows: 67 deg instead of 90 at elevation 120, and up to 42 off at 15.
  EXPECT_NEAR(ValueOf(report, "plane, from elevation 30"), 23, 0.5);
  EXPECT_NEAR(ValueOf(report, "plane, below elevation 30"), 42, 0.5);
  EXPECT_NEAR(ValueOf(report, "published ST, rms"), 2.03, 0.005);
  // Three planes of 22 elevations.
  const Residual* const published = Find(report, "published ST, rms");
  ASSERT_NE(published, nullptr);
  EXPECT_EQ(published->where, "66 values");
}

}  // namespace
}  // namespace girdle::residuals_test
