// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "motions/motion.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

#include "text/input_error.h"

namespace girdle::motion_test {
namespace {

Motion FromText(const std::string& text, const MotionReading& reading = {}) {
  std::istringstream in(text);
  return ReadMotion(in, "motion.csv", reading);
}

constexpr const char* kValid = "time_s,elevation_deg,plane_deg\n0,20,40\n1,80,40\n3,100,40\n";

TEST(ReachingMotion, StartsAndEndsAtItsCommandsAndHoldsThem) {
  const Motion motion = ReachingMotion("reach", {0.3, 0, 0.1}, {1.9, 0.5, -0.2}, 2);
  for (const double before : {-1.0, 0.0}) {
    EXPECT_EQ(motion.command(before).elevation_rad, 0.3) << before;
    EXPECT_EQ(motion.command(before).axial_rad, 0.1) << before;
  }
  for (const double after : {2.0, 5.0}) {
    EXPECT_DOUBLE_EQ(motion.command(after).elevation_rad, 1.9) << after;
    EXPECT_DOUBLE_EQ(motion.command(after).plane_rad, 0.5) << after;
  }
}

TEST(ReachingMotion, IsAtRestAtBothEndsAndFastestInTheMiddle) {
  const double duration_s = 2;
  const Motion motion = ReachingMotion("reach", {0, 0, 0}, {1, 0, 0}, duration_s);
  const double h = 1e-4;
  const auto speed = [&](double time_s) {
    return (motion.command(time_s + h).elevation_rad - motion.command(time_s - h).elevation_rad) /
           (2 * h);
  };
  EXPECT_NEAR(speed(0), 0, 1e-6);
  EXPECT_NEAR(speed(duration_s), 0, 1e-6);
  // 30 t^2 (1-t)^2 at t = 1/2 is 15/8, per duration.
  EXPECT_NEAR(speed(duration_s / 2), 15.0 / 8 / duration_s, 1e-6);
}

TEST(ReadMotion, GoesBetweenRowsAsThePathDoes) {
  const Motion motion = FromText("time_s,elevation_deg,plane_deg\n0,20,40\n1,80,400\n3,90,-310\n");
  EXPECT_EQ(motion.duration_s, 3);
  EXPECT_NEAR(DegreesFromRadians(motion.command(0.25).elevation_rad), 35, 1e-12);
  EXPECT_NEAR(DegreesFromRadians(motion.command(0.25).plane_rad), 40, 1e-12);
  EXPECT_EQ(motion.command(9).elevation_rad, RadiansFromDegrees(90));
  EXPECT_NEAR(DegreesFromRadians(motion.command(9).plane_rad), 50, 1e-12);
}

TEST(ReadMotion, StartsAtTheFirstTimeWhateverItIs) {
  for (const char* const times : {"3600.00", "-7.5", "1764520000.25"}) {
    const double first_s = std::stod(times);
    std::ostringstream text;
    text.precision(17);
    text << "time_s,elevation_deg,plane_deg\n"
         << first_s << ",20,40\n"
         << first_s + 0.25 << ",40,40\n"
         << first_s + 0.5 << ",60,40\n";
    const Motion motion = FromText(text.str());
    EXPECT_EQ(motion.duration_s, 0.5) << times;
    EXPECT_EQ(motion.command(0).elevation_rad, RadiansFromDegrees(20)) << times;
    EXPECT_EQ(motion.command(0.25).elevation_rad, RadiansFromDegrees(40)) << times;
  }
}

TEST(ReadMotion, LeavesOtherColumnsAlone) {
  const Motion motion = FromText("frame,time_s,elevation_deg,plane_deg\n1,0,20,40\n2,0.5,60,40\n");
  EXPECT_EQ(motion.command(0.5).elevation_rad, RadiansFromDegrees(60));
}

TEST(ReadMotion, ReadsTheConventionAndTheUnitThatAreSaid) {
  std::istringstream in("time_s,elevation_deg,plane_deg\n0,-0.5,0.25\n1,-1.5,0.25\n");
  const Motion motion =
      ReadMotion(in, "motion.csv", {{AngleConvention::kIsb, AngleUnit::kRadian}, 10});
  EXPECT_NEAR(motion.command(0).elevation_rad, 0.5, 1e-15);
  EXPECT_NEAR(motion.command(1).elevation_rad, 1.5, 1e-15);
  EXPECT_NEAR(motion.command(1).plane_rad, 0.25, 1e-15);
}

// The hint about so many rows that are so far apart, but for the first, which is much longer.
std::string HintOf(int rows, double step_s) {
  std::ostringstream text;
  text << "time_s,elevation_deg,plane_deg\n-500,20,40\n";
  for (int i = 1; i < rows; ++i) {
    text << i * step_s << ",30,40\n";
  }
  const Motion motion = FromText(text.str());
  return motion.notes.empty() ? "" : motion.notes.front();
}

TEST(ReadMotion, HintsAtStampsInMilliseconds) {
  EXPECT_EQ(HintOf(101, 10),
            "motion.csv: its 101 rows are 10 s apart (median), 1500 s in all. If time_s is in "
            "milliseconds, divide it by 1000");
  EXPECT_NE(HintOf(11, 1), "");
  EXPECT_EQ(HintOf(10, 1), "");
  EXPECT_EQ(HintOf(101, 0.99), "");
}

// Rows of the second to the fourth second are gaps.
constexpr const char* kWithGap =
    "time_s,elevation_deg,plane_deg\n0,20,40\n1,30,40\n2,,40\n3,NaN,40\n4,70,40\n5,NA,40\n";

MotionReading WithGaps(GapRule rule, std::size_t bridged_rows) {
  MotionReading reading;
  reading.gaps = {rule, bridged_rows};
  return reading;
}

std::string RefusalOf(const std::string& text, const MotionReading& reading) {
  try {
    static_cast<void>(FromText(text, reading));
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(ReadMotion, PassesOverGapsThatAreKept) {
  const Motion motion = FromText(kWithGap, WithGaps(GapRule::kKeep, 2));
  EXPECT_EQ(motion.bridged, 2U);
  EXPECT_EQ(motion.gaps, 1U);
  EXPECT_EQ(motion.duration_s, 5);
  // By the times of the rows: a third of the way from 30 to 70.
  EXPECT_NEAR(DegreesFromRadians(motion.command(2).elevation_rad), 30 + 40.0 / 3, 1e-12);
  EXPECT_EQ(motion.command(5).elevation_rad, RadiansFromDegrees(70));
}

TEST(ReadMotion, RefusesGapsThatAreNotBridged) {
  EXPECT_EQ(
      RefusalOf(kWithGap, {}),
      "motion.csv:4: elevation_deg is empty, a gap of 2 rows. Fill it, or give --bridge-gaps 2 "
      "or --gaps keep");
  EXPECT_EQ(RefusalOf(kWithGap, WithGaps(GapRule::kRefuse, 1)), RefusalOf(kWithGap, {}));
  EXPECT_EQ(RefusalOf(kWithGap, WithGaps(GapRule::kRefuse, 2)),
            "motion.csv:7: elevation_deg is 'NA', a gap of 1 row. Fill it, remove the row, or give "
            "--gaps keep");
}

TEST(ReadMotion, RefusesAFileOfGapsAloneAndATimeThatIsMissing) {
  EXPECT_EQ(RefusalOf("time_s,elevation_deg,plane_deg\n0,,40\n", WithGaps(GapRule::kKeep, 0)),
            "motion.csv:2: no row of the motion has all angles");
  EXPECT_EQ(RefusalOf("time_s,elevation_deg,plane_deg\n,20,40\n", WithGaps(GapRule::kKeep, 0)),
            "motion.csv:2: time_s is '', expected a finite number such as 22.5");
}

TEST(ReadMotion, ReadsNamesThatAreGivenAndNotesThem) {
  MotionReading reading;
  reading.columns = {{"time_s", "t"}, {"elevation_deg", "theta"}};
  const Motion motion = FromText("t,theta,plane_deg\n0,20,40\n0.5,60,40\n", reading);
  EXPECT_EQ(motion.command(0.5).elevation_rad, RadiansFromDegrees(60));
  EXPECT_EQ(motion.notes,
            (std::vector<std::string>{"motion.csv: read 't' as time_s, 'theta' as elevation_deg"}));
}

TEST(ReadMotion, SaysWhatAxialTurnsCountFrom) {
  EXPECT_EQ(FromText("time_s,elevation_deg,plane_deg,axial_deg\n0,20,40,1\n").axial_from,
            AxialFrom::kRhythm);
  EXPECT_EQ(FromText(kValid).axial_from, std::nullopt);
}

TEST(ReadMotion, RefusesWhatLooksLikeRadians) {
  std::string text = "time_s,elevation_deg,plane_deg\n";
  for (int i = 0; i < 10; ++i) {
    text += std::to_string(i) + ",0." + std::to_string(i) + ",0.7\n";
  }
  EXPECT_THROW(static_cast<void>(FromText(text)), InputError);
  EXPECT_NO_THROW(static_cast<void>(FromText(text + "10,40,0.7\n")));
}

TEST(ReadMotion, TakesAnAxialColumnAndAnyOrder) {
  const Motion motion = FromText("plane_deg,axial_deg,time_s,elevation_deg\n10,5,0,20\n");
  EXPECT_EQ(motion.command(0).axial_rad, RadiansFromDegrees(5));
  EXPECT_EQ(motion.command(0).plane_rad, RadiansFromDegrees(10));
}

TEST(ReadMotion, TakesOffsets) {
  const Motion motion = FromText(
      "time_s,elevation_deg,plane_deg,shrug_deg,protraction_deg\n0,20,0,0,4\n2,20,0,10,-6\n");
  EXPECT_NEAR(motion.command(0.5).shrug_rad, RadiansFromDegrees(2.5), 1e-14);
  EXPECT_NEAR(motion.command(0.5).protraction_rad, RadiansFromDegrees(1.5), 1e-14);
  EXPECT_EQ(motion.command(2).shrug_rad, RadiansFromDegrees(10));
  EXPECT_EQ(motion.command(2).protraction_rad, RadiansFromDegrees(-6));
}

TEST(ReadMotion, HasNoOffsetsUnlessTheFileSaysSo) {
  EXPECT_EQ(FromText(kValid).command(0.5).shrug_rad, 0);
  EXPECT_EQ(FromText(kValid).command(0.5).protraction_rad, 0);
}

TEST(ReachingMotion, MovesOffsetsToo) {
  const Motion motion = ReachingMotion("reach", {0, 0, 0, 0.1, -0.2}, {0, 0, 0, 0.3, 0.2}, 1);
  EXPECT_DOUBLE_EQ(motion.command(0.5).shrug_rad, 0.2);
  EXPECT_DOUBLE_EQ(motion.command(0.5).protraction_rad, 0);
}

TEST(RateOf, IsTheSlopeBetweenRows) {
  const Motion raised =
      FromText("time_s,elevation_deg,plane_deg,axial_deg\n0,20,40,5\n2,80,40,-5\n");
  const CommandRate rates = RateOf(raised, 0.5, 0.002);
  EXPECT_NEAR(rates[0], RadiansFromDegrees(30), 1e-11);
  EXPECT_NEAR(rates[1], 0, 1e-11);
  EXPECT_NEAR(rates[2], RadiansFromDegrees(-5), 1e-11);
}

TEST(RateOf, GoesOnFrom180AsMinus180) {
  const Motion across = FromText("time_s,elevation_deg,plane_deg\n0,90,170\n2,90,210\n");
  for (const double time_s : {0.1, 0.499, 0.5, 1.5}) {
    EXPECT_NEAR(RateOf(across, time_s, 0.002)[1], RadiansFromDegrees(20), 1e-10) << time_s;
  }
}

// What the command will have changed by when the step ends.
TEST(RateOf, IsThatOfTheStepThatBegins) {
  const Motion motion = FromText(kValid);
  const double step_s = 0.01;
  EXPECT_EQ(RateOf(motion, 3, step_s)[0], 0) << "the motion has ended";
  // Half of this step is on the first line, of 60 deg/s, half on the second, of 10 deg/s.
  EXPECT_NEAR(RateOf(motion, 1 - step_s / 2, step_s)[0], RadiansFromDegrees(35), 1e-11);
}

struct BadMotion {
  const char* name;
  const char* from;
  const char* to;
  const char* message;
};

class MotionRefusal : public testing::TestWithParam<BadMotion> {};

TEST_P(MotionRefusal, NamesLineAndValue) {
  std::string text = kValid;
  const std::size_t at = text.find(GetParam().from);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, std::string(GetParam().from).size(), GetParam().to);
  try {
    (void)FromText(text);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), GetParam().message);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Rows, MotionRefusal,
    testing::Values(BadMotion{"TimeGoesBack", "\n3,", "\n0.5,",
                              "motion.csv:4: time_s is 0.5, which does not increase (previous 1)"},
                    BadMotion{"TooLong", "\n3,", "\n3600.5,",
                              "motion.csv:4: time_s is 3600.5, 3600.5 s after the first row, "
                              "expected at most 3600. Check that it is in seconds; for a longer "
                              "motion give --longest SECONDS"},
                    BadMotion{"NearlyAColumn", "plane_deg", "plan_deg",
                              "motion.csv:1: column 'plan_deg' is not known. Did you mean "
                              "'plane_deg'? Correct its name or give --columns plane_deg=plan_deg. "
                              "If it is something else, give it a name that is less alike"},
                    BadMotion{"NearlyTheTime", "time_s", "time",
                              "motion.csv:1: column 'time' is not known. Did you mean 'time_s'? "
                              "Correct its name or give --columns time_s=time. If it is something "
                              "else, give it a name that is less alike"},
                    BadMotion{"NoRows", "0,20,40\n1,80,40\n3,100,40\n", "",
                              "motion.csv:1: the motion has no rows"}),
    [](const auto& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace girdle::motion_test
