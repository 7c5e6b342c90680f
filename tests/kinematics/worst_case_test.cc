// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/worst_case.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace girdle::worst_case_test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Lengths = WorstCase<std::size_t, Worse::kSmaller>;

// Adds values whose places are their numbers in the list.
template <typename Case>
Case Of(const std::vector<double>& values) {
  Case worst;
  for (std::size_t i = 0; i < values.size(); ++i) {
    worst.Add(values[i], i);
  }
  return worst;
}

TEST(WorstCase, IsTheLargestMagnitudeWithItsSignAndPlace) {
  const auto worst = Of<WorstCase<std::size_t>>({1, -3, 2});
  EXPECT_EQ(worst.value(), -3);
  EXPECT_EQ(worst.magnitude(), 3);
  EXPECT_EQ(worst.place(), 1U);
  EXPECT_EQ(worst.count(), 3U);
  EXPECT_EQ(worst.rms(), std::sqrt(14.0 / 3));
}

TEST(WorstCase, OfEqualMagnitudesTheFirstCounts) {
  const auto worst = Of<WorstCase<std::size_t>>({0, -2, 2});
  EXPECT_EQ(worst.value(), -2);
  EXPECT_EQ(worst.place(), 1U);
}

TEST(WorstCase, CanBeTheSmallest) {
  const auto smallest = Of<Lengths>({3, -1, 2});
  EXPECT_EQ(smallest.value(), -1);
  EXPECT_EQ(smallest.place(), 1U);
}

// Wherever the NaN comes in a row, it is the worst, and the first one is where it is.
TEST(WorstCase, NaNIsWorseThanEveryNumber) {
  for (const std::vector<double>& values :
       {std::vector<double>{kNaN, 1, kInfinity}, {1, kNaN, kNaN}, {kInfinity, -kInfinity, kNaN}}) {
    const auto first = static_cast<std::size_t>(
        std::find_if(values.begin(), values.end(), [](double x) { return std::isnan(x); }) -
        values.begin());
    const auto worst = Of<WorstCase<std::size_t>>(values);
    EXPECT_TRUE(std::isnan(worst.value()));
    EXPECT_TRUE(std::isnan(worst.magnitude()));
    EXPECT_TRUE(std::isnan(worst.rms()));
    EXPECT_EQ(worst.place(), first);
    const auto smallest = Of<Lengths>(values);
    EXPECT_TRUE(std::isnan(smallest.value()));
    EXPECT_EQ(smallest.place(), first);
  }
}

TEST(WorstCase, OfNothingIsNaN) {
  const WorstCase<std::string> worst;
  EXPECT_TRUE(worst.empty());
  EXPECT_TRUE(std::isnan(worst.value()));
  EXPECT_TRUE(std::isnan(worst.rms()));
  EXPECT_EQ(worst.place(), "");
}

TEST(WorstCase, TakesAZeroAsAValue) {
  const auto worst = Of<WorstCase<std::size_t>>({0, 0});
  EXPECT_FALSE(worst.empty());
  EXPECT_EQ(worst.value(), 0);
  EXPECT_EQ(worst.rms(), 0);
}

TEST(WorstCase, MakesItsPlaceOfSeveralParts) {
  struct Place {
    std::string name;
    double elevation_rad = 0;
  };
  WorstCase<Place> worst;
  worst.Add(1, "low", 0.1);
  worst.Add(2, "high", 0.2);
  worst.Add(1, "low again", 0.3);
  EXPECT_EQ(worst.place().name, "high");
  EXPECT_EQ(worst.place().elevation_rad, 0.2);
}

TEST(WorseOf, KeepsTheSignAndTakesNaNBeforeAnyNumber) {
  EXPECT_EQ(WorseOf(1, -2), -2);
  EXPECT_EQ(WorseOf(-2, 1), -2);
  EXPECT_TRUE(std::isnan(WorseOf(kNaN, kInfinity)));
  EXPECT_TRUE(std::isnan(WorseOf(kInfinity, kNaN)));
}

}  // namespace
}  // namespace girdle::worst_case_test
