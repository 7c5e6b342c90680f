// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/pair.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "kinematics/random_rotations.h"
#include "kinematics/rotation.h"

namespace girdle::pair_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

bool SameBits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool Holds(Pair pair, double first, double second) {
  return SameBits(pair[0], first) && SameBits(pair[1], second);
}

// Of either sign and any size that can be multiplied and divided.
rc::Gen<double> AnyNumber() {
  return rc::gen::exec(
      [] { return std::ldexp(*NumberWithin(-1, 1), static_cast<int>(*NumberWithin(-60, 60))); });
}

// How many doubles lie between two.
std::int64_t UnitsApart(double a, double b) {
  const auto place = [](double x) {
    const auto bits = std::bit_cast<std::int64_t>(x);
    return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits : bits;
  };
  return std::abs(place(a) - place(b));
}

TEST(Pair, HoldsBothOfItsNumbers) {
  EXPECT_TRUE(Holds(Pair(1.5, -2), 1.5, -2));
  EXPECT_TRUE(Holds(Pair(3), 3, 3));
}

RC_GTEST_PROP(Pair, GivesEachElementTheBitsItWouldHaveAlone, ()) {
  const std::array<double, 4> x = {*AnyNumber(), *AnyNumber(), *AnyNumber(), *AnyNumber()};
  const Pair a(x[0], x[1]);
  const Pair b(x[2], x[3]);
  RC_ASSERT(Holds(a + b, x[0] + x[2], x[1] + x[3]));
  RC_ASSERT(Holds(a - b, x[0] - x[2], x[1] - x[3]));
  RC_ASSERT(Holds(a * b, x[0] * x[2], x[1] * x[3]));
  RC_ASSERT(Holds(a / b, x[0] / x[2], x[1] / x[3]));
  RC_ASSERT(Holds(-a, -x[0], -x[1]));
  RC_ASSERT(Holds(2 * a, 2 * x[0], 2 * x[1]));
  const Pair square = a * a;
  RC_ASSERT(Holds(Sqrt(square), Sqrt(square[0]), Sqrt(square[1])));
}

TEST(Pair, ChoosesElementByElement) {
  EXPECT_TRUE(Holds(Pair::WhereLess({1, 2}, {2, 1}, {10, 20}, {30, 40}), 10, 40));
}

TEST(Pair, DoesNotTakeEqualNumbersForLess) {
  EXPECT_TRUE(Holds(Pair::WhereLess({1, -0.0}, {1, 0.0}, 10, 30), 30, 30));
}

TEST(Pair, DoesNotTakeANanForLess) {
  EXPECT_TRUE(Holds(Pair::WhereLess({kNan, 1}, {1, kNan}, 10, 30), 30, 30));
}

RC_GTEST_PROP(PolynomialValue, IsHornersToRounding, ()) {
  const double x = *NumberWithin(-1, 1);
  const auto check = [x]<std::size_t N>(std::array<double, N> c) {
    double largest = 0;
    for (double& coefficient : c) {
      coefficient = *NumberWithin(-1, 1);
      largest += std::abs(coefficient);
    }
    double sum = 0;
    for (std::size_t i = N; i-- > 0;) sum = c[i] + x * sum;
    const double tolerance = 1e-15 * (1 + largest);
    RC_ASSERT(std::abs(PolynomialValue(c, x) - sum) <= tolerance);
    RC_ASSERT(
        Holds(PolynomialValue(c, Pair(x, 0.5)), PolynomialValue(c, x), PolynomialValue(c, 0.5)));
  };
  check(std::array<double, 0>{});
  check(std::array<double, 1>{});
  check(std::array<double, 2>{});
  check(std::array<double, 3>{});
  check(std::array<double, 6>{});
  check(std::array<double, 11>{});
  check(std::array<double, 13>{});
  check(std::array<double, 24>{});
}

RC_GTEST_PROP(SineAndCosine, OfAPairAreTheLibrarys, ()) {
  const std::array<double, 2> x = {*NumberWithin(-20, 20), *NumberWithin(-20, 20)};
  const SineAndCosine<Pair> both = SineAndCosineOf(Pair(x[0], x[1]));
  for (std::size_t i = 0; i < x.size(); ++i) {
    const SineAndCosine<double> alone = SineAndCosineOf(x[i]);
    RC_ASSERT(both.sine[i] == alone.sine && both.cosine[i] == alone.cosine);
    RC_ASSERT(std::abs(alone.sine - std::sin(x[i])) < 4.5e-16);
    RC_ASSERT(std::abs(alone.cosine - std::cos(x[i])) < 4.5e-16);
  }
}

// Where one quadrant gives way to the next, and at the multiples of a quarter turn themselves.
TEST(SineAndCosine, AreTheLibrarysAtTheEndsOfQuadrants) {
  for (int eighths = -16; eighths <= 16; ++eighths) {
    const double middle = eighths * kPi / 4;
    for (const double x : {std::nextafter(middle, -10), middle, std::nextafter(middle, 10)}) {
      const SineAndCosine<double> alone = SineAndCosineOf(x);
      EXPECT_NEAR(alone.sine, std::sin(x), 4.5e-16) << x;
      EXPECT_NEAR(alone.cosine, std::cos(x), 4.5e-16) << x;
    }
  }
}

RC_GTEST_PROP(Decay, IsTheLibrarysToTwoUnits, ()) {
  constexpr std::int64_t kUnits = 2;
  const double x = *NumberWithin(-699, 699);
  const double small = *NumberWithin(-1, 1);
  RC_ASSERT(UnitsApart(Decay(x), std::exp(-x)) <= kUnits);
  RC_ASSERT(UnitsApart(Decay(small), std::exp(-small)) <= kUnits);
}

TEST(Decay, IsOneAtZeroAndNothingFarAway) {
  EXPECT_EQ(Decay(0), 1);
  EXPECT_GT(Decay(std::nextafter(700, 0)), 0);
  EXPECT_EQ(Decay(700), 0);
  EXPECT_EQ(Decay(std::numeric_limits<double>::infinity()), 0);
}

// As pair.h promises.
constexpr std::int64_t kArcTangentUnits = 4;

RC_GTEST_PROP(ArcTangent, OfAPairIsTheLibrarysToFourUnits, ()) {
  const double y = *AnyNumber();
  const double x = *AnyNumber();
  const double other_y = *NumberWithin(-1, 1);
  const double other_x = *NumberWithin(-1, 1);
  const Pair angle = Atan2(Pair(y, other_y), Pair(x, other_x));
  RC_ASSERT(UnitsApart(angle[0], std::atan2(y, x)) <= kArcTangentUnits);
  RC_ASSERT(UnitsApart(angle[1], std::atan2(other_y, other_x)) <= kArcTangentUnits);
}

struct SpecialPoint {
  double y;
  double x;
};

void PrintTo(const SpecialPoint& point, std::ostream* out) {
  *out << "y " << point.y << ", x " << point.x;
}

class ArcTangentOf : public testing::TestWithParam<SpecialPoint> {};

TEST_P(ArcTangentOf, ASpecialPointIsTheLibrarys) {
  const auto [y, x] = GetParam();
  const Pair angle = Atan2(Pair(y, 1), Pair(x, 1));
  EXPECT_LE(UnitsApart(angle[0], std::atan2(y, x)), kArcTangentUnits)
      << angle[0] << " and " << std::atan2(y, x);
  EXPECT_LE(UnitsApart(angle[1], kPi / 4), kArcTangentUnits);
}

const double kLimit = std::tan(kPi / 8);

INSTANTIATE_TEST_SUITE_P(
    Points, ArcTangentOf,
    testing::Values(SpecialPoint{0, 0}, SpecialPoint{0, 1}, SpecialPoint{0, -1}, SpecialPoint{1, 0},
                    SpecialPoint{-1, 0}, SpecialPoint{1, 1}, SpecialPoint{-1, 1},
                    SpecialPoint{1, -1}, SpecialPoint{-1, -1}, SpecialPoint{kLimit, 1},
                    SpecialPoint{std::nextafter(kLimit, 0), 1},
                    SpecialPoint{std::nextafter(kLimit, 1), 1}, SpecialPoint{1, kLimit},
                    SpecialPoint{1, -kLimit}, SpecialPoint{std::nextafter(1, 0), 1},
                    SpecialPoint{std::nextafter(1, 2), 1}, SpecialPoint{1e-300, 1},
                    SpecialPoint{1e-300, -1}, SpecialPoint{-1e-300, -1}, SpecialPoint{1, 1e-300},
                    SpecialPoint{1e-300, 1e-300}, SpecialPoint{1e-300, -2e-300},
                    SpecialPoint{1e300, 1e-300}, SpecialPoint{1e300, 1e300},
                    SpecialPoint{5e-324, 5e-324}));

// A signed zero counts as plus.
TEST(ArcTangent, DoesNotSeeTheSignOfAZero) {
  EXPECT_EQ(Atan2(Pair(0.0, -0.0), Pair(-0.0, 0.0))[0], 0);
  EXPECT_EQ(Atan2(Pair(0.0, -0.0), Pair(-0.0, 0.0))[1], 0);
  EXPECT_NEAR(Atan2(Pair(-0.0), Pair(-1.0))[0], kPi, 1e-15);
}

}  // namespace
}  // namespace girdle::pair_test
