// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/jet.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>

#include "kinematics/random_rotations.h"

namespace girdle::jet_test {
namespace {

// A few dozen roundings of numbers of size ten.
constexpr double kRounding = 1e-12;
// Central differences over 1e-5 of formulas whose third derivatives are below 1e3.
constexpr double kStep = 1e-5;
constexpr double kDifferenceTolerance = 1e-6;

constexpr std::array<double, 5> kCoefficients = {0.3, -0.7, 0.2, 0.9, -0.4};

template <typename T>
T Sine(const T& x) {
  return SineAndCosineOf(x).sine;
}
template <typename T>
T Cosine(const T& x) {
  return SineAndCosineOf(x).cosine;
}

// Every operation that duals have too.
template <typename T>
T Formula(const T& e, const T& p) {
  const T product = e * p - 0.3 * e + T(0.5);
  const T waves = Sine(product) * Cosine(T(e - 2.0 * p)) + Sine(p) * p;
  return waves * Decay(T(0.2 * product)) - Polynomial(kCoefficients, e + 0.5 * p) * (-p);
}

// And those of jets alone.
template <typename T>
T JetFormula(const T& e, const T& p) {
  const T length = Sqrt(e * e + p * p + T(1.0));
  return Atan2(Formula(e, p), length) * length;
}
double JetFormula(double e, double p) {
  const double length = std::sqrt(e * e + p * p + 1);
  return std::atan2(Formula(e, p), length) * length;
}

template <int Order>
struct Point {
  Jet<double, Order> e;
  Jet<double, Order> p;
  Point(double e_at, double p_at) : e(e_at), p(p_at) {
    e.part[kByElevation] = 1;
    p.part[kByPlane] = 1;
  }
};

// Along two lines at once: value.value, value.slope and slope.slope.
using Twice = Dual<Dual<double>>;

RC_GTEST_PROP(Jet, HasTheDerivativesThatDualsOfDualsGive, ()) {
  const double e = *NumberWithin(-1, 1);
  const double p = *NumberWithin(-1, 1);
  const auto mixed = [&](double first_e, double first_p, double second_e, double second_p) {
    return Formula(Twice({e, first_e}, {second_e, 0.0}), Twice({p, first_p}, {second_p, 0.0}));
  };
  const Point<2> point(e, p);
  const Jet<double, 2> jet = Formula(point.e, point.p);
  const Twice ee = mixed(1, 0, 1, 0);
  const Twice ep = mixed(1, 0, 0, 1);
  const Twice pp = mixed(0, 1, 0, 1);
  const auto near = [](double a, double b) { return std::abs(a - b) < kRounding; };
  RC_ASSERT(near(jet.part[kValue], Formula(e, p)));
  RC_ASSERT(near(jet.part[kByElevation], ee.value.slope));
  RC_ASSERT(near(jet.part[kByPlane], pp.value.slope));
  RC_ASSERT(near(jet.part[kByElevationTwice], ee.slope.slope));
  RC_ASSERT(near(jet.part[kByElevationAndPlane], ep.slope.slope));
  RC_ASSERT(near(jet.part[kByPlaneTwice], pp.slope.slope));
}

RC_GTEST_PROP(Jet, HasTheDerivativesThatDifferencesGive, ()) {
  const double e = *NumberWithin(-1, 1);
  const double p = *NumberWithin(-1, 1);
  const auto jet_at = [](double e_at, double p_at) {
    const Point<2> point(e_at, p_at);
    return JetFormula(point.e, point.p);
  };
  const Jet<double, 2> jet = jet_at(e, p);
  const auto near = [](double a, double b) { return std::abs(a - b) < kDifferenceTolerance; };
  RC_ASSERT(std::abs(jet.part[kValue] - JetFormula(e, p)) < kRounding);
  RC_ASSERT(near(jet.part[kByElevation],
                 (JetFormula(e + kStep, p) - JetFormula(e - kStep, p)) / (2 * kStep)));
  RC_ASSERT(near(jet.part[kByPlane],
                 (JetFormula(e, p + kStep) - JetFormula(e, p - kStep)) / (2 * kStep)));
  const auto slope = [&](JetPart part, double e_step, double p_step) {
    return (jet_at(e + e_step, p + p_step).part[part] - jet_at(e - e_step, p - p_step).part[part]) /
           (2 * kStep);
  };
  RC_ASSERT(near(jet.part[kByElevationTwice], slope(kByElevation, kStep, 0)));
  RC_ASSERT(near(jet.part[kByElevationAndPlane], slope(kByElevation, 0, kStep)));
  RC_ASSERT(near(jet.part[kByElevationAndPlane], slope(kByPlane, kStep, 0)));
  RC_ASSERT(near(jet.part[kByPlaneTwice], slope(kByPlane, 0, kStep)));
}

RC_GTEST_PROP(Jet, OfFirstOrderIsTheBeginningOfSecond, ()) {
  const double e = *NumberWithin(-1, 1);
  const double p = *NumberWithin(-1, 1);
  const Point<1> once(e, p);
  const Point<2> twice(e, p);
  const Jet<double, 1> first = JetFormula(once.e, once.p);
  const Jet<double, 2> second = JetFormula(twice.e, twice.p);
  for (std::size_t part = 0; part < first.part.size(); ++part) {
    RC_ASSERT(first.part[part] == second.part[part]);
  }
}

RC_GTEST_PROP(Jet, OfPairsHoldsTheJetsOfBoth, ()) {
  const auto formula = [](const auto& e, const auto& p) {
    return Sine(e * p) * Cosine(p) - Polynomial(kCoefficients, e);
  };
  const Point<2> a(*NumberWithin(-1, 1), *NumberWithin(-1, 1));
  const Point<2> b(*NumberWithin(-1, 1), *NumberWithin(-1, 1));
  const auto paired = [](const Jet<double, 2>& x, const Jet<double, 2>& y) {
    Jet<Pair, 2> pair;
    for (std::size_t i = 0; i < pair.part.size(); ++i) pair.part[i] = {x.part[i], y.part[i]};
    return pair;
  };
  const Jet<Pair, 2> both = formula(paired(a.e, b.e), paired(a.p, b.p));
  RC_ASSERT(Element(both, 0).part == formula(a.e, a.p).part);
  RC_ASSERT(Element(both, 1).part == formula(b.e, b.p).part);
}

TEST(Jet, OfAConstantHasNoDerivatives) {
  const Jet<double, 2> constant(3);
  EXPECT_EQ(constant.part, (std::array<double, 6>{3, 0, 0, 0, 0, 0}));
  EXPECT_EQ(ValueOf(constant), 3);
}

TEST(Jet, OfTwoEqualElementsIsBoth) {
  const Point<2> point(0.25, 0.5);
  const Jet<Pair, 2> both = Both(point.e);
  EXPECT_EQ(Element(both, 0).part, point.e.part);
  EXPECT_EQ(Element(both, 1).part, point.e.part);
}

TEST(LargestLeaf, IsTheLargestValueWithoutDerivatives) {
  Jet<Pair, 1> jet(Pair(2, 5));
  jet.part[kByPlane] = Pair(100, 100);
  EXPECT_EQ(LargestLeaf(jet), 5);
  EXPECT_EQ(LargestLeaf(Dual<Jet<Pair, 1>>(jet, Jet<Pair, 1>(Pair(50, 60)))), 5);
}

TEST(DerivativeOf, APolynomialHasItsPowersAsFactors) {
  EXPECT_EQ(DerivativeOf(std::array<double, 4>{7, 5, 3, 2}), (std::array<double, 3>{5, 6, 6}));
  EXPECT_EQ(DerivativeOf(std::array<double, 1>{7}), (std::array<double, 0>{}));
  EXPECT_EQ(DerivativeOf(std::array<double, 0>{}), (std::array<double, 0>{}));
}

}  // namespace
}  // namespace girdle::jet_test
