// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "motions/arm_angles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace girdle::arm_angles_test {
namespace {

constexpr AngleConvention kGirdle = AngleConvention::kGirdle;
constexpr AngleConvention kIsb = AngleConvention::kIsb;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

template <typename Function>
std::string RefusalOf(const Function& read) {
  try {
    static_cast<void>(read());
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

std::string RefusalOf(double elevation_deg, AngleConvention convention) {
  return RefusalOf([=] { return ElevationRead_deg(elevation_deg, convention); });
}

TEST(ElevationRead, IsAnAngleFromHanging) {
  for (const double elevation_deg : {0.0, 0.1, 90.0, 180.0}) {
    EXPECT_EQ(ElevationRead_deg(elevation_deg, kGirdle), elevation_deg);
    EXPECT_EQ(ElevationRead_deg(-elevation_deg, kIsb), elevation_deg);
  }
  EXPECT_FALSE(std::signbit(ElevationRead_deg(0.0, kIsb)));
}

TEST(ElevationRead, TakesWhatRoundingMakesBeyondItsEnds) {
  EXPECT_EQ(ElevationRead_deg(-0.5, kGirdle), 0);
  EXPECT_EQ(ElevationRead_deg(180.5, kGirdle), 180);
  EXPECT_EQ(ElevationRead_deg(0.5, kIsb), 0);
  EXPECT_EQ(ElevationRead_deg(-180.5, kIsb), 180);
}

TEST(ElevationRead, RefusesTheOtherSignWithTheConventionThatHasIt) {
  const std::string negative = RefusalOf(-0.51, kGirdle);
  EXPECT_NE(negative.find("In ISB's Y-X'-Y'' a raised arm has a negative elevation"),
            std::string::npos)
      << negative;
  EXPECT_NE(negative.find("--convention isb"), std::string::npos);
  const std::string positive = RefusalOf(0.51, kIsb);
  EXPECT_NE(positive.find("--convention girdle"), std::string::npos) << positive;
  EXPECT_NE(positive.find("(plane + 180, -elevation, axial + 180)"), std::string::npos);
}

TEST(ElevationRead, RefusesWhatIsBeyondStraightUp) {
  EXPECT_EQ(RefusalOf(181, kGirdle), "expected 0 to 180 degrees");
  EXPECT_EQ(RefusalOf(-181, kIsb), "expected 0 to -180 degrees");
  EXPECT_EQ(RefusalOf(kNan, kGirdle), "expected 0 to 180 degrees");
  EXPECT_EQ(RefusalOf(kNan, kIsb), "expected 0 to -180 degrees");
}

TEST(PlaneRead, IsAnAngle) {
  EXPECT_EQ(PlaneRead_deg(350), -10);
  EXPECT_EQ(PlaneRead_deg(400), 40);
  EXPECT_EQ(PlaneRead_deg(181), -179);
  EXPECT_EQ(PlaneRead_deg(-181), 179);
  EXPECT_EQ(PlaneRead_deg(3600), 0);
  for (const double within_deg : {-180.0, -33.3, 0.0, 180.0}) {
    EXPECT_EQ(PlaneRead_deg(within_deg), within_deg);
  }
}

TEST(PlaneRead, RefusesAngleWhoseDigitsSayNothing) {
  for (const double plane_deg : {3600.5, -3601.0, 1e300, kNan}) {
    EXPECT_EQ(RefusalOf([=] { return PlaneRead_deg(plane_deg); }),
              "expected an angle within -3600 to 3600 degrees");
    EXPECT_EQ(RefusalOf([=] { return AxialRead_deg(plane_deg); }),
              "expected an angle within -3600 to 3600 degrees");
  }
}

}  // namespace
}  // namespace girdle::arm_angles_test
