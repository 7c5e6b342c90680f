// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "simulation/residuals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

#include "mjcf/shoulder_model.h"
#include "simulation/engine_fixture.h"
#include "simulation/residual_report.h"
#include "tables/built_in.h"

namespace girdle {
namespace {

TEST(DistanceFromEllipsoid, IsThatOfASphereForEqualRadii) {
  const Ellipsoid sphere{{0.1, -0.2, 0.3}, {0.5, 0.5, 0.5}};
  std::mt19937 random(5);
  std::normal_distribution<double> coordinate(0, 0.5);
  for (int sample = 0; sample < 100; ++sample) {
    const Vector3 point{coordinate(random), coordinate(random), coordinate(random)};
    EXPECT_NEAR(DistanceFromEllipsoid(sphere, point), glm::distance(point, sphere.center_m) - 0.5,
                1e-12)
        << point.x << " " << point.y << " " << point.z;
  }
}

TEST(DistanceFromEllipsoid, UndoesAStepAlongTheNormal) {
  const Ellipsoid ellipsoid{{-0.087, -0.083, 0.049}, {0.077, 0.201, 0.076}};
  std::mt19937 random(6);
  std::uniform_real_distribution<double> angle(0, 2 * kPi);
  for (int sample = 0; sample < 100; ++sample) {
    const double u = angle(random);
    const double v = angle(random);
    const Vector3 direction{std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v)};
    const Vector3 normal = glm::normalize(direction / ellipsoid.radii_m);
    for (const double step_m : {0.03, 1e-6, -0.01}) {
      // The smallest radius of curvature is 0.076^2 / 0.201 = 29 mm: 10 mm inside is still
      // unambiguous.
      const Vector3 point = ellipsoid.center_m + ellipsoid.radii_m * direction + step_m * normal;
      EXPECT_NEAR(DistanceFromEllipsoid(ellipsoid, point), step_m, 1e-9) << "u " << u << " v " << v;
    }
  }
}

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

TEST(ResidualReport, SaysWhatFailed) {
  ResidualReport report;
  report.residuals = {{"joint constraint", "SC", 2, "mm", 1, "abduction"},
                      {"closure", "plane", 20, "deg", std::nullopt, "flexion"}};
  EXPECT_FALSE(report.passed());
  const std::string text = ReportAsText(report);
  EXPECT_NE(text.find("FAIL"), std::string::npos) << text;
  EXPECT_NE(text.find("stated"), std::string::npos) << text;
  EXPECT_NE(text.find("1 residuals above their tolerances"), std::string::npos) << text;
}

class MeasureResidualsTest : public EngineTest {
 protected:
  // Measures the model of `rhythm` against `reference`.
  static ResidualReport Measure(const ShoulderRhythm& rhythm, const ShoulderRhythm& reference) {
    const std::string xml = ShoulderModelXml(BuiltInAnatomy(), rhythm, {.carries_table = true});
    ShoulderSimulation simulation(LoadModel({{"shoulder.xml", xml}}), "shoulder.xml");
    return MeasureResiduals(simulation, reference, BuiltInAnatomy(), [](double) {});
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
};

TEST_F(MeasureResidualsTest, PassesForTheModelOfTheSameRhythm) {
  for (const Interpolation interpolation : {Interpolation::kSquad, Interpolation::kSlerp}) {
    const ShoulderRhythm rhythm(BuiltInRhythmTable(), {interpolation, Closure::kTable});
    const ResidualReport report = Measure(rhythm, rhythm);
    EXPECT_EQ(FailedLines(report), "") << Name(interpolation);
    EXPECT_GT(report.residuals.size(), 20U);
  }
}

TEST_F(MeasureResidualsTest, FailsForAModelWhoseTableHasOneAngleChanged) {
  RhythmTable table = BuiltInRhythmTable();
  std::vector<RhythmPosition> positions;
  for (std::size_t plane = 0; plane < 3; ++plane) {
    for (std::size_t elevation = 0; elevation < 22; ++elevation) {
      positions.push_back(table.position(plane, elevation));
    }
  }
  positions[30].angles_rad[4] += RadiansFromDegrees(0.001);
  const ShoulderRhythm changed(RhythmTable(table.planes_rad(), table.elevations_rad(), positions));
  const std::string failed = FailedLines(Measure(changed, ShoulderRhythm(table)));
  EXPECT_NE(failed.find("kinematic consistency AC\n"), std::string::npos) << failed;
  EXPECT_NE(failed.find("kinematic consistency scapula landmarks\n"), std::string::npos) << failed;
  EXPECT_EQ(failed.find("kinematic consistency SC\n"), std::string::npos) << failed;
}

TEST_F(MeasureResidualsTest, FindsTheClosureThatIsKnownOfTheTable) {
  const ShoulderRhythm rhythm{BuiltInRhythmTable()};
  const ResidualReport report = Measure(rhythm, rhythm);
  const auto value_of = [&report](const std::string& item) {
    for (const Residual& residual : report.residuals) {
      if (residual.item == item) {
        return residual.value;
      }
    }
    ADD_FAILURE() << "no line for " << item;
    return std::numeric_limits<double>::quiet_NaN();
  };
  // Known of the rows: -1.7 to +1.3 deg; between them squad adds a little.
  EXPECT_NEAR(value_of("elevation reached - commanded"), 1.7, 0.1);
  // Known of the rows: 67 deg instead of 90 at elevation 120, and up to 42 off at 15.
  EXPECT_NEAR(value_of("plane, from elevation 30"), 23, 0.5);
  EXPECT_NEAR(value_of("plane, below elevation 30"), 42, 0.5);
  EXPECT_NEAR(value_of("published ST, rms"), 2.03, 0.005);
}

}  // namespace
}  // namespace girdle
