// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "rhythms/continuity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/gtc/quaternion.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "anatomy/built_in_anatomy.h"
#include "rhythm_tables/built_in_tables.h"

namespace girdle::continuity_test {
namespace {

const ShoulderRhythm& Rhythm() {
  static const ShoulderRhythm kRhythm = BuiltInRhythm();
  return kRhythm;
}

const JointRanges& Ranges() {
  static const JointRanges kRanges = BuiltInAnatomy().ranges;
  return kRanges;
}

std::vector<std::string> NamesOfFailures(const std::vector<RhythmCheck>& checks) {
  std::vector<std::string> names;
  for (const RhythmCheck& check : checks) {
    if (!check.passed()) names.push_back(check.name);
  }
  return names;
}

double Deg(double angle_rad) { return DegreesFromRadians(angle_rad); }
double AboveZero(double x) { return std::max(x, 0.0); }

// What is wrong with a rhythm: a turn of the clavicle, and of the humerus in the scapula, about y
// [deg] at an elevation and a plane [deg].
struct Flaw {
  std::string check;  ///< that has to see it
  std::function<double(double elevation_deg, double plane_deg)> clavicle_deg;
  std::function<double(double elevation_deg, double plane_deg)> humerus_deg;
};

void PrintTo(const Flaw& flaw, std::ostream* out) { *out << flaw.check; }

double Nothing(double /*elevation_deg*/, double /*plane_deg*/) { return 0; }

PoseFunction With(const Flaw& flaw) {
  return [flaw](const ArmCommand& command) {
    ShoulderPose pose = Rhythm().SolvePose(command);
    const double elevation_deg = Deg(command.elevation_rad);
    const double plane_deg = Deg(command.plane_rad);
    const auto about_y = [](double angle_deg) {
      const double half_rad = RadiansFromDegrees(angle_deg) / 2;
      return Quaternion(std::cos(half_rad), 0, std::sin(half_rad), 0);
    };
    pose.q_TC = about_y(flaw.clavicle_deg(elevation_deg, plane_deg)) * pose.q_TC;
    pose.q_SH = pose.q_SH * about_y(flaw.humerus_deg(elevation_deg, plane_deg));
    return pose;
  };
}

TEST(RhythmChecks, PassForTheRhythmThatIsShipped) {
  EXPECT_EQ(NamesOfFailures(MeasureChecks(Rhythm(), Ranges())), std::vector<std::string>());
}

class RhythmFlaw : public testing::TestWithParam<Flaw> {};

TEST_P(RhythmFlaw, IsSeenByItsCheck) {
  const std::vector<std::string> failures =
      NamesOfFailures(MeasureChecks(Rhythm(), Ranges(), With(GetParam())));
  EXPECT_NE(std::find(failures.begin(), failures.end(), GetParam().check), failures.end())
      << testing::PrintToString(failures);
}

// Each a little above what its check allows.
INSTANTIATE_TEST_SUITE_P(
    Each, RhythmFlaw,
    testing::Values(
        Flaw{"jump of velocity over elevation knots",
             [](double e, double) { return 2e-9 * AboveZero(e - 60); }, Nothing},
        Flaw{"jump of acceleration over elevation knots",
             [](double e, double) { return 2e-7 * std::pow(AboveZero(e - 60), 2); }, Nothing},
        Flaw{"jump of velocity over plane knots",
             [](double, double p) { return 2e-9 * AboveZero(p - 40); }, Nothing},
        Flaw{"jump of acceleration over plane knots",
             [](double, double p) { return 2e-7 * std::pow(AboveZero(p - 40), 2); }, Nothing},
        Flaw{"jump of velocity where the table ends, over elevations",
             [](double e, double) { return 2e-6 * AboveZero(e - 135); }, Nothing},
        Flaw{"jump of velocity where the table ends, over elevations",
             [](double e, double p) { return p < -45 ? 2e-6 * AboveZero(e - 15) : 0; }, Nothing},
        Flaw{"jump of velocity where the table ends, over planes",
             [](double, double p) { return 2e-6 * AboveZero(p - 90); }, Nothing},
        Flaw{"all bones at elevation 0, plane to plane", [](double, double p) { return 1e-10 * p; },
             Nothing},
        Flaw{"clavicle and scapula at 180, plane to plane",
             [](double e, double p) { return e > 170 ? 1e-10 * p : 0; }, Nothing},
        Flaw{"humerus at 180, axial from swing, plane to plane", Nothing,
             [](double e, double p) { return e > 170 ? 1e-10 * p : 0; }},
        Flaw{"plane reached - commanded", [](double, double) { return 1e-8; }, Nothing},
        Flaw{"fastest bone per degree of elevation", Nothing,
             [](double e, double) { return 4 * e; }},
        Flaw{"fastest bone below elevation 15, per degree of elevation", Nothing,
             [](double e, double) { return -7 * std::min(e, 15.0); }},
        Flaw{"fastest bone behind plane -60, per degree of elevation", Nothing,
             [](double e, double p) { return p < -60 ? 7 * std::max(e, 15.0) : 0; }},
        Flaw{"fastest bone per degree of plane", Nothing, [](double, double p) { return 5 * p; }},
        Flaw{"joint out of its range", [](double, double) { return -30; }, Nothing}));

TEST(RhythmChecks, SeeAnArmThatIsNotWhereItWasTold) {
  const std::vector<std::string> failures =
      NamesOfFailures(MeasureChecks(Rhythm(), Ranges(), [](ArmCommand command) {
        command.elevation_rad += RadiansFromDegrees(1e-8);
        return Rhythm().SolvePose(command);
      }));
  EXPECT_NE(std::find(failures.begin(), failures.end(), "elevation reached - commanded"),
            failures.end());
}

TEST(RhythmCheck, DoesNotPassWithoutANumber) {
  EXPECT_FALSE((RhythmCheck{"", std::nan(""), 1, "", ""}.passed()));
  EXPECT_FALSE((RhythmCheck{"", 1, 1, "", ""}.passed()));
  EXPECT_TRUE((RhythmCheck{"", 0.5, 1, "", ""}.passed()));
}

// The measured table's humerus turns faster about its own axis just above 15 deg than is allowed.
TEST(RhythmChecks, SayThatTheMeasuredTableTurnsTheHumerusTooFast) {
  const ShoulderRhythm measured(BuiltInRhythmTable(BuiltInTable::kMeasured), {}, Ranges());
  EXPECT_EQ(NamesOfFailures(MeasureChecks(measured, Ranges())),
            std::vector<std::string>{"fastest bone per degree of elevation"});
}

}  // namespace
}  // namespace girdle::continuity_test
