// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "anatomy/postures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <string>

#include "anatomy/built_in_anatomy.h"
#include "rhythm_tables/built_in_tables.h"
#include "text/csv_text.h"
#include "text/input_error.h"

namespace girdle::postures_test {
namespace {

// Quaternions in double precision.
constexpr double kRounding = 1e-14;

// Two postures whose six angles all differ.
constexpr const char* kValid =
    "posture,sc_protraction_deg,sc_elevation_deg,sc_rotation_deg,ac_internal_rotation_deg,"
    "ac_upward_rotation_deg,ac_tilt_deg\n"
    "relaxed,-20,-6,1,60,-3,-8\n"
    "slouched,-10,2,3,55,4,-15\n";

Posture Read(const CsvText& text, const std::string& posture) {
  std::istringstream in(text.Text());
  return ReadPosture(in, "t.csv", posture);
}

void ExpectAngles(const Posture& posture, const std::array<double, 6>& angles_deg) {
  JointAngles angles_rad{};
  std::transform(angles_deg.begin(), angles_deg.end(), angles_rad.begin(), RadiansFromDegrees);
  const ShoulderPose expected = PoseFromAngles(angles_rad);
  EXPECT_LT(AngleBetween(posture.q_TC, expected.q_TC), kRounding);
  EXPECT_LT(AngleBetween(posture.q_CS, expected.q_CS), kRounding);
}

TEST(ReadPosture, ReadsTheRowOfItsName) {
  ExpectAngles(Read(CsvText(kValid), "relaxed"), {-20, -6, 1, 60, -3, -8});
  ExpectAngles(Read(CsvText(kValid), "slouched"), {-10, 2, 3, 55, 4, -15});
}

TEST(ReadPosture, TakesColumnsAndRowsInAnyOrder) {
  CsvText text(kValid);
  std::reverse(text.columns.begin(), text.columns.end());
  for (auto& row : text.rows) std::reverse(row.begin(), row.end());
  std::reverse(text.rows.begin(), text.rows.end());
  ExpectAngles(Read(text, "relaxed"), {-20, -6, 1, 60, -3, -8});
}

TEST(ReadPosture, TakesAnglesUpToHalfACircle) {
  CsvText text(kValid);
  text.Cell(0, "sc_protraction_deg") = "-180";
  text.Cell(0, "ac_internal_rotation_deg") = "180";
  EXPECT_NO_THROW(static_cast<void>(Read(text, "relaxed")));
}

class FlawedPostures : public testing::TestWithParam<CsvFlaw> {};

TEST_P(FlawedPostures, AreRefusedWithPlaceAndFix) {
  CsvText text(kValid);
  GetParam().change(text);
  EXPECT_EQ(MessageOf<InputError>([&] { static_cast<void>(Read(text, "relaxed")); }),
            GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    OneChangeEach, FlawedPostures,
    testing::Values(
        CsvFlaw{"no such row", [](CsvText& text) { text.RemoveRow(0); },
                "t.csv: has no posture 'relaxed'. Add a row for it"},
        CsvFlaw{"a row in capitals", [](CsvText& text) { text.Cell(0, "posture") = "Relaxed"; },
                "t.csv: has no posture 'relaxed'. Add a row for it"},
        CsvFlaw{"a row twice", [](CsvText& text) { text.Cell(1, "posture") = "relaxed"; },
                "t.csv:3: posture 'relaxed' is given twice. Remove one of the rows"},
        CsvFlaw{"an angle above half a circle",
                [](CsvText& text) { text.Cell(0, "ac_tilt_deg") = "180.5"; },
                "t.csv:2: ac_tilt_deg is 180.5, expected -180 to 180"},
        CsvFlaw{"an angle below half a circle, in a row of another name",
                [](CsvText& text) { text.Cell(1, "sc_rotation_deg") = "-181"; },
                "t.csv:3: sc_rotation_deg is -181, expected -180 to 180"},
        CsvFlaw{"an angle that is no number",
                [](CsvText& text) { text.Cell(0, "sc_elevation_deg") = "-5.9O"; },
                "t.csv:2: sc_elevation_deg is '-5.9O', expected a finite number such as 22.5"},
        CsvFlaw{"no column of names", [](CsvText& text) { text.RemoveColumn("posture"); },
                "t.csv:1: column 'posture' is missing. The header has: sc_protraction_deg, "
                "sc_elevation_deg, sc_rotation_deg, ac_internal_rotation_deg, "
                "ac_upward_rotation_deg, ac_tilt_deg"},
        CsvFlaw{"no column of an angle", [](CsvText& text) { text.RemoveColumn("ac_tilt_deg"); },
                "t.csv:1: column 'ac_tilt_deg' is missing. The header has: posture, "
                "sc_protraction_deg, "
                "sc_elevation_deg, sc_rotation_deg, ac_internal_rotation_deg, "
                "ac_upward_rotation_deg"}),
    [](const auto& parameter) { return "Flaw" + std::to_string(parameter.index); });

TEST(HangingIn, KeepsTheGirdleAndHangsTheArmAsTheRhythmDoes) {
  const ShoulderRhythm rhythm = BuiltInRhythm();
  const Posture posture = RelaxedStanding();
  const ShoulderPose pose = HangingIn(posture, rhythm);
  EXPECT_EQ(pose.q_TC, posture.q_TC);
  EXPECT_EQ(pose.q_CS, posture.q_CS);
  EXPECT_LT(AngleBetween(pose.q_TH(), rhythm.SolvePose({}).q_TH()), kRounding);
}

}  // namespace
}  // namespace girdle::postures_test
