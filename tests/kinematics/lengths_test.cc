// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/lengths.h"

#include <gtest/gtest.h>

#include <cmath>

namespace girdle::lengths_test {
namespace {

TEST(RoundedLength, IsTheNearestTenthOfAMillimeter) {
  EXPECT_EQ(RoundedLength_m(0.12344), 0.1234);
  EXPECT_EQ(RoundedLength_m(0.12346), 0.1235);
  EXPECT_EQ(RoundedLength_m(-0.12346), -0.1235);
}

TEST(RoundedUpLength, IsNeverShorter) {
  EXPECT_EQ(RoundedUpLength_m(0.12341), 0.1235);
  EXPECT_EQ(RoundedUpLength_m(0.25), 0.25);
}

TEST(RoundedPlace, HasEachCoordinateRounded) {
  EXPECT_EQ(RoundedPlace_m({0.12344, 0.12346, -1.00004}), Vector3(0.1234, 0.1235, -1));
}

TEST(LengthSteps, AreThoseOfTheDecimals) {
  EXPECT_EQ(kLengthStepsPerMeter, std::pow(10, kLengthDecimals));
}

}  // namespace
}  // namespace girdle::lengths_test
