// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "rhythms/comparison.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstddef>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/random_rotations.h"
#include "rhythm_tables/built_in_tables.h"
#include "rhythms/comparison_report.h"

namespace girdle::comparison_test {
namespace {

// Quaternions in double precision.
constexpr double kRounding = 1e-12;
constexpr DefinedAngles kAll = {{true, true, true, true, true, true}};

std::vector<double> Radians(std::vector<double> angles_deg) {
  for (double& angle : angles_deg) angle = RadiansFromDegrees(angle);
  return angles_deg;
}

ComparisonMap Map(const std::vector<double>& elevations_deg,
                  const std::vector<double>& planes_deg) {
  return {Radians(elevations_deg), Radians(planes_deg)};
}

const ShoulderRhythm& Measured() {
  static const ShoulderRhythm kRhythm = BuiltInRhythm({Interpolation::kSquad, Closure::kTable});
  return kRhythm;
}

// The measured girdle itself, changed by turns in clavicle and scapula: q_TC dC, q_TS dS.
PublishedRhythm Turned(const Quaternion& clavicle_turn, const Quaternion& scapula_turn) {
  PublishedRhythm rhythm;
  rhythm.name = "turned";
  rhythm.defined = kAll;
  rhythm.girdle = [=](double elevation_rad, double plane_rad) -> GirdlePose {
    const ShoulderPose pose = Measured().Solve({elevation_rad, plane_rad, 0}).pose;
    return {pose.q_TC * clavicle_turn, pose.q_TS() * scapula_turn};
  };
  return rhythm;
}

const Quaternion kNoTurn(1, 0, 0, 0);

DifferenceSummary Summary(const DifferenceSummaries& summaries, ComparedAngle which) {
  return summaries[static_cast<std::size_t>(which)].value();
}

TEST(Compare, FindsNoDifferenceBetweenARhythmAndItself) {
  const Comparison comparison =
      Compare(Measured(), {Turned(kNoTurn, kNoTurn)}, Map({15, 60, 120}, {0, 45, 90}));
  for (std::size_t k = 0; k < kDifferenceCount; ++k) {
    EXPECT_NEAR(comparison.rhythms[0].on_map[k].value().rms_rad, 0, kRounding)
        << kDifferenceNames[k];
    EXPECT_NEAR(comparison.rhythms[0].on_map[k].value().largest_rad, 0, kRounding)
        << kDifferenceNames[k];
  }
}

TEST(Compare, FindsATurnThatIsTheSameEverywhere) {
  const Comparison comparison =
      Compare(Measured(), {Turned(Exp({0.1, 0.2, -0.2}), Exp({0, -0.5, 0}))},
              Map({15, 60, 120}, {0, 45, 90}));
  const DifferenceSummaries& found = comparison.rhythms[0].in_table;
  for (const auto& [which, turn_rad] :
       {std::pair(ComparedAngle::kSc, 0.3), std::pair(ComparedAngle::kGh, 0.5)}) {
    EXPECT_NEAR(Summary(found, which).rms_rad, turn_rad, kRounding);
    EXPECT_NEAR(Summary(found, which).largest_rad, turn_rad, kRounding);
  }
}

// Of Y-X'-Z'' the last turn is about the moving bone's own z.
TEST(Compare, TellsTiltFromTheOtherAnglesWithItsSign) {
  const Comparison comparison =
      Compare(Measured(), {Turned(kNoTurn, Exp({0, 0, -0.25}))}, Map({15, 60, 120}, {0, 45, 90}));
  const DifferenceSummaries& found = comparison.rhythms[0].in_table;
  EXPECT_NEAR(Summary(found, ComparedAngle::kTilt).largest_rad, -0.25, kRounding);
  EXPECT_NEAR(Summary(found, ComparedAngle::kTilt).rms_rad, 0.25, kRounding);
  EXPECT_NEAR(Summary(found, ComparedAngle::kUpwardRotation).largest_rad, 0, kRounding);
  EXPECT_NEAR(Summary(found, ComparedAngle::kInternalRotation).largest_rad, 0, kRounding);
  EXPECT_NEAR(Summary(found, ComparedAngle::kAc).rms_rad, 0.25, kRounding);
}

TEST(Compare, SaysWhereTheLargestDifferenceIs) {
  PublishedRhythm rhythm = Turned(kNoTurn, kNoTurn);
  rhythm.girdle = [girdle = rhythm.girdle](double elevation_rad, double plane_rad) {
    GirdlePose pose = girdle(elevation_rad, plane_rad);
    const bool is_there = std::abs(elevation_rad - RadiansFromDegrees(60)) < kRounding &&
                          std::abs(plane_rad - RadiansFromDegrees(90)) < kRounding;
    pose.q_TC = pose.q_TC * Exp({0, 0, is_there ? 0.6 : 0.2});
    return pose;
  };
  const Comparison comparison = Compare(Measured(), {rhythm}, Map({15, 60}, {0, 90}));
  const DifferenceSummary found = Summary(comparison.rhythms[0].on_map, ComparedAngle::kSc);
  EXPECT_NEAR(found.largest_rad, 0.6, kRounding);
  EXPECT_DOUBLE_EQ(found.elevation_rad, RadiansFromDegrees(60));
  EXPECT_DOUBLE_EQ(found.plane_rad.value(), RadiansFromDegrees(90));
  EXPECT_NEAR(found.rms_rad, std::sqrt((0.36 + 3 * 0.04) / 4), kRounding);
}

// All planes are one there, and the last bits say which of them is worst.
TEST(Compare, NamesNoPlaneWhereTheArmHangsOrIsStraightUp) {
  const PublishedRhythm rhythm = Turned(kNoTurn, Exp({0, 0, 0.3}));
  for (const double elevation_deg : {0.0, 5.0, 175.0, 180.0}) {
    const Comparison comparison = Compare(BuiltInRhythm(), {rhythm}, Map({elevation_deg}, {0, 45}));
    const DifferenceSummary found = Summary(comparison.rhythms[0].on_map, ComparedAngle::kGh);
    const bool is_straight = elevation_deg == 0 || elevation_deg == 180;
    EXPECT_DOUBLE_EQ(found.elevation_rad, RadiansFromDegrees(elevation_deg));
    EXPECT_EQ(found.plane_rad.has_value(), !is_straight) << elevation_deg;
    const std::string text = ComparisonAsText(comparison);
    const std::string elevation = " " + std::to_string(static_cast<int>(elevation_deg));
    EXPECT_EQ(text.find(elevation + "\n") != std::string::npos, is_straight) << text;
    EXPECT_EQ(text.find(elevation + "/") == std::string::npos, is_straight) << text;
    const std::string json = ComparisonAsJson(comparison);
    EXPECT_EQ(json.find("\"plane_deg\": null") != std::string::npos, is_straight) << json;
  }
}

TEST(Compare, TakesADifferenceOfAnglesTheShortWay) {
  MapPosition position{0, 0, {kNoTurn, kNoTurn, kNoTurn}, true};
  position.measured.q_TC = QuaternionFromEuler(EulerSequence::kYXZ, {3, 0, 0});
  const Differences found = DifferencesAt(
      position, {QuaternionFromEuler(EulerSequence::kYXZ, {-3, 0, 0}), kNoTurn}, kAll);
  EXPECT_NEAR(found[static_cast<std::size_t>(ComparedAngle::kProtraction)].value(), 2 * kPi - 6,
              kRounding);
}

TEST(Compare, LeavesOutWhatARhythmDoesNotSay) {
  const MapPosition position = PositionsOf(Measured(), Map({60}, {40})).at(0);
  const auto is_compared = [&position](const DefinedAngles& defined) {
    std::string letters;
    for (const auto& difference_rad : DifferencesAt(position, {kNoTurn, kNoTurn}, defined)) {
      letters += difference_rad ? 'x' : '-';
    }
    return letters;
  };
  // SC AC GH, protraction elevation, internal upward tilt
  EXPECT_EQ(is_compared(kAll), "xxxxxxxx");
  EXPECT_EQ(is_compared({{false, false, false, false, true, false}}), "------x-");
  EXPECT_EQ(is_compared({{true, true, false, true, true, true}}), "--xxxxxx");
  EXPECT_EQ(is_compared({{true, true, true, true, true, false}}), "x--xxxx-");
  EXPECT_EQ(is_compared({}), "--------");
}

TEST(Compare, HasNoFiguresWhereNothingIsSaid) {
  PublishedRhythm silent = Turned(kNoTurn, kNoTurn);
  silent.defined = {};
  const Comparison comparison = Compare(Measured(), {silent}, Map({60}, {40}));
  for (std::size_t k = 0; k < kDifferenceCount; ++k) {
    EXPECT_FALSE(comparison.rhythms[0].on_map[k]) << kDifferenceNames[k];
    EXPECT_FALSE(comparison.rhythms[0].in_table[k]) << kDifferenceNames[k];
  }
}

TEST(Compare, LeavesOutPositionsThatTheMeasuredRhythmDoesNotReach) {
  const ComparisonMap map = Map({0, 15, 60, 120, 180}, {-180, 0, 40, 90, 180});
  std::size_t reached = 0;
  for (const double elevation_rad : map.elevations_rad) {
    for (const double plane_rad : map.planes_rad) {
      reached += Measured().Solve({elevation_rad, plane_rad, 0}).clamped ? 0 : 1;
    }
  }
  const Comparison comparison = Compare(Measured(), {}, map);
  ASSERT_LT(reached, 25U);
  EXPECT_EQ(comparison.compared_on_map, reached);
  EXPECT_EQ(comparison.compared_in_table, 9U);
  EXPECT_EQ(comparison.position_count(), 25U);
}

TEST(ScapulohumeralRatio, IsTheJointsShareOverTheScapulas) {
  EXPECT_DOUBLE_EQ(ScapulohumeralRatio(0.9, 0.3).value(), 2);
  EXPECT_DOUBLE_EQ(ScapulohumeralRatio(0.9, 0.45).value(), 1);
  EXPECT_FALSE(ScapulohumeralRatio(0.9, 0));
}

TEST(ScapulohumeralRatio, OfThePublishedRhythmsIsTheirClosedForm) {
  const auto published = PublishedRhythms(BuiltInRhythmCoefficients());
  const Comparison comparison = Compare(Measured(), published, Map({60}, {40}));
  ASSERT_EQ(comparison.ratios.size(), 15U);
  for (const RatioRow& row : comparison.ratios) {
    for (std::size_t i = 0; i < published.size(); ++i) {
      const std::optional<double>& ratio = row.published.at(i);
      if (published[i].name == "Inman") {
        EXPECT_NEAR(ratio.value(), 2, kRounding);
      }
      if (published[i].name == "Braman") {
        EXPECT_NEAR(ratio.value(), (1 - 0.301) / 0.301, kRounding);
      }
      if (published[i].name == "de Groot and Brand") {
        EXPECT_NEAR(ratio.value(), (1 - 0.396) / 0.396, kRounding);
      }
      if (published[i].name == "frozen girdle") {
        EXPECT_FALSE(ratio);
      }
    }
  }
}

// Two humeri in their scapulae differ by q_TH^-1 (q_TS' q_TS^-1) q_TH, whose angle is that of q_TS'
// to q_TS.
RC_GTEST_PROP(DifferencesAt, OfTheGlenohumeralJointIsThatOfTheScapulaInTheThorax, ()) {
  const MapPosition position{0, 0, {*UnitQuaternion(), *UnitQuaternion(), *UnitQuaternion()}, true};
  const GirdlePose girdle{*UnitQuaternion(), *UnitQuaternion()};
  const Differences found = DifferencesAt(position, girdle, kAll);
  const double scapula_rad = AngleBetween(girdle.q_TS, position.measured.q_TS());
  RC_ASSERT(std::abs(found[static_cast<std::size_t>(ComparedAngle::kGh)].value() - scapula_rad) <
            kRounding);
}

}  // namespace
}  // namespace girdle::comparison_test
