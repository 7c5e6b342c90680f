// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/surface_spline.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/cubic_spline.h"
#include "kinematics/random_rotations.h"

namespace girdle::surface_spline_test {
namespace {

// Elimination and sums of dozens of numbers of size one, over knots whose gaps differ up to
// eightfold.
constexpr double kRounding = 1e-11;

// Increasing, with gaps from 0.05 to 0.4.
std::vector<double> AnyKnots(int fewest, int most) {
  std::vector<double> knots = {*NumberWithin(-1, 1)};
  const int count = *rc::gen::inRange(fewest, most + 1);
  while (knots.size() < static_cast<std::size_t>(count)) {
    knots.push_back(knots.back() + *NumberWithin(0.05, 0.4));
  }
  return knots;
}

using Values = std::vector<std::vector<double>>;  // by elevation and plane

// A grid and values on it. Four elevations or more, three planes or more.
struct Sample {
  std::vector<double> elevations;
  std::vector<double> planes;
  Values values;
  SurfaceGrid grid;
  SurfaceSpline<double, 1> surface;

  Sample(std::vector<double> elevations_in, std::vector<double> planes_in, Values values_in)
      : elevations(std::move(elevations_in)),
        planes(std::move(planes_in)),
        values(std::move(values_in)),
        grid(SplineAxis(elevations), SplineAxis(planes)),
        surface(grid, [this](std::size_t i, std::size_t j) {
          return std::array<double, 1>{values[i][j]};
        }) {}

  [[nodiscard]] double At(double elevation, double plane) const {
    return surface.At(grid.PlaceOf(elevation, plane))[0];
  }
};

template <typename Function>
Values ValuesOf(const std::vector<double>& elevations, const std::vector<double>& planes,
                const Function& f) {
  Values values;
  for (const double elevation : elevations) {
    std::vector<double>& row = values.emplace_back();
    for (const double plane : planes) row.push_back(f(elevation, plane));
  }
  return values;
}

Sample AnySample(int fewest_planes = 3) {
  const std::vector<double> elevations = AnyKnots(4, 9);
  const std::vector<double> planes = AnyKnots(fewest_planes, 7);
  return {elevations, planes,
          ValuesOf(elevations, planes, [](double, double) { return *NumberWithin(-1, 1); })};
}

// Within the knots and a little outside.
double AnyPlace(const std::vector<double>& knots) {
  constexpr double kOutside = 0.05;
  return *NumberWithin(knots.front() - kOutside, knots.back() + kOutside);
}

RC_GTEST_PROP(SplineAxis, FindsThePieceThatHoldsAPlace, ()) {
  const std::vector<double> knots = AnyKnots(3, 12);
  const SplineAxis axis(knots);
  // Breaks are the knots but the second and the second last.
  std::vector<double> breaks = knots;
  if (breaks.size() > 3) breaks.erase(breaks.end() - 2);
  breaks.erase(breaks.begin() + 1);
  RC_ASSERT(axis.pieces() == breaks.size() - 1);
  const auto check = [&](double x) {
    std::size_t piece = 0;
    while (piece + 2 < breaks.size() && x > breaks[piece + 1]) ++piece;
    RC_ASSERT(axis.PieceAt(x) == piece);
    RC_ASSERT(axis.origin(piece) == breaks[piece]);
  };
  check(AnyPlace(knots));
  for (const double at : breaks) {
    check(at);
    check(std::nextafter(at, -10));
    check(std::nextafter(at, 10));
  }
}

TEST(SplineAxis, TakesTheFirstOrLastPieceFarOutside) {
  const SplineAxis axis({0, 1, 2, 3, 4, 5});
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(axis.PieceAt(-1e300), 0U);
  EXPECT_EQ(axis.PieceAt(-kInfinity), 0U);
  EXPECT_EQ(axis.PieceAt(1e300), axis.pieces() - 1);
  EXPECT_EQ(axis.PieceAt(kInfinity), axis.pieces() - 1);
}

TEST(SplineAxis, RefusesLessThanThreeKnots) {
  try {
    const SplineAxis axis({0, 1});
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()), "2 knots given, at least 3 are needed");
  }
}

RC_GTEST_PROP(SurfaceSpline, PassesThroughEveryValue, ()) {
  const Sample sample = AnySample();
  for (std::size_t i = 0; i < sample.elevations.size(); ++i) {
    for (std::size_t j = 0; j < sample.planes.size(); ++j) {
      RC_ASSERT(std::abs(sample.At(sample.elevations[i], sample.planes[j]) - sample.values[i][j]) <
                kRounding);
    }
  }
}

// First along plane, then along elevation, by polynomials' coefficients.
RC_GTEST_PROP(SurfaceSpline, IsTheNotAKnotSplineOfBothDirections, ()) {
  const Sample sample = AnySample();
  const double elevation = AnyPlace(sample.elevations);
  const double plane = AnyPlace(sample.planes);
  std::vector<double> along;
  for (const std::vector<double>& row : sample.values) {
    along.push_back(CubicSpline(sample.planes, row).At(plane));
  }
  const double expected = CubicSpline(sample.elevations, along).At(elevation);
  RC_ASSERT(std::abs(sample.At(elevation, plane) - expected) <
            kRounding * (1 + std::abs(expected)));
}

// Degree 3 in elevation and in plane; 2 in plane where there are three.
RC_GTEST_PROP(SurfaceSpline, ReproducesCubicPolynomials, ()) {
  const std::vector<double> elevations = AnyKnots(4, 9);
  const std::vector<double> planes = AnyKnots(3, 7);
  const std::size_t plane_powers = planes.size() == 3 ? 3 : 4;
  std::array<std::array<double, 4>, 4> c{};
  for (auto& row : c) {
    for (std::size_t l = 0; l < plane_powers; ++l) row[l] = *NumberWithin(-1, 1);
  }
  const auto polynomial = [&c](double x, double y) {
    double sum = 0;
    for (std::size_t k = 4; k-- > 0;) {
      sum = sum * x + c[k][0] + y * (c[k][1] + y * (c[k][2] + y * c[k][3]));
    }
    return sum;
  };
  const Sample sample(elevations, planes, ValuesOf(elevations, planes, polynomial));
  const double elevation = AnyPlace(elevations);
  const double plane = AnyPlace(planes);
  const double expected = polynomial(elevation, plane);
  RC_ASSERT(std::abs(sample.At(elevation, plane) - expected) <
            10 * kRounding * (1 + std::abs(expected)));
}

// Of (0, 0), (1, 1), (4, 16).
TEST(SurfaceSpline, OfThreeKnotsIsTheParabola) {
  const std::vector<double> elevations = {0, 1, 2, 3};
  const std::vector<double> planes = {0, 1, 4};
  const Sample sample(elevations, planes, ValuesOf(elevations, planes, [](double, double plane) {
                        return plane * plane;
                      }));
  for (const double plane : {-1.0, 0.5, 2.0, 3.5, 5.0}) {
    EXPECT_NEAR(sample.At(1.5, plane), plane * plane, kRounding) << plane;
  }
}

// Orders (i, j) of all derivatives that must be continuous.
constexpr std::array<std::array<std::size_t, 2>, 9> kContinuousOrders = {
    {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}, {2, 1}, {1, 2}, {2, 2}}};

// Derivatives over gaps as small as 0.05 grow by its powers.
double DerivativeRounding(std::size_t i, std::size_t j) {
  return kRounding * std::pow(20.0, static_cast<double>(i + j));
}

// The surface's derivative of an order that is not known before.
double Partial(const SurfaceSpline<double, 1>& surface, const SurfaceGrid::Place& place,
               std::size_t i, std::size_t j) {
  constexpr std::size_t kOrders = 4;
  const auto one_of = [&]<std::size_t... Order>(std::index_sequence<Order...>) {
    double partial = 0;
    ((i * kOrders + j == Order
          ? void(partial = surface.Partial<Order / kOrders, Order % kOrders>(place)[0])
          : void()),
     ...);
    return partial;
  };
  return one_of(std::make_index_sequence<kOrders * kOrders>());
}

RC_GTEST_PROP(SurfaceSpline, HasTwoContinuousDerivativesOverEveryKnot, ()) {
  const Sample sample = AnySample();
  const double elevation = AnyPlace(sample.elevations);
  const double plane = AnyPlace(sample.planes);
  const auto check = [&](double e_before, double p_before, double e_after, double p_after) {
    for (const auto& [i, j] : kContinuousOrders) {
      const double before = Partial(sample.surface, sample.grid.PlaceOf(e_before, p_before), i, j);
      const double after = Partial(sample.surface, sample.grid.PlaceOf(e_after, p_after), i, j);
      RC_ASSERT(std::abs(after - before) < DerivativeRounding(i, j));
    }
  };
  for (const double knot : sample.elevations) {
    check(knot, plane, std::nextafter(knot, 10), plane);
    check(std::nextafter(knot, -10), plane, knot, plane);
  }
  for (const double knot : sample.planes) {
    check(elevation, knot, elevation, std::nextafter(knot, 10));
    check(elevation, std::nextafter(knot, -10), elevation, knot);
  }
}

// Differences of the surface itself: the product's derivatives take no part.
RC_GTEST_PROP(SurfaceSpline, HasTheSlopesOfItsValues, ()) {
  constexpr double kStep = 1e-5;
  constexpr double kTolerance = 1e-5;
  const Sample sample = AnySample();
  const double elevation = AnyPlace(sample.elevations);
  const double plane = AnyPlace(sample.planes);
  const auto place = sample.grid.PlaceOf(elevation, plane);
  const double by_elevation =
      (sample.At(elevation + kStep, plane) - sample.At(elevation - kStep, plane)) / (2 * kStep);
  const double by_plane =
      (sample.At(elevation, plane + kStep) - sample.At(elevation, plane - kStep)) / (2 * kStep);
  RC_ASSERT(std::abs(Partial(sample.surface, place, 1, 0) - by_elevation) < kTolerance);
  RC_ASSERT(std::abs(Partial(sample.surface, place, 0, 1) - by_plane) < kTolerance);
}

RC_GTEST_PROP(SurfaceSpline, HasPartialsThatFollowFromLowerOnes, ()) {
  constexpr double kStep = 1e-6;
  const Sample sample = AnySample();
  const double elevation = AnyPlace(sample.elevations);
  const double plane = AnyPlace(sample.planes);
  // Within one cell: third derivatives leap between them.
  const auto at = sample.grid.PlaceOf(elevation, plane);
  const auto shifted = [&at](double s, double t) {
    return SurfaceGrid::Place{at.cell, at.s + s, at.t + t};
  };
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const double by_elevation = (Partial(sample.surface, shifted(kStep, 0), i, j) -
                                   Partial(sample.surface, shifted(-kStep, 0), i, j)) /
                                  (2 * kStep);
      const double by_plane = (Partial(sample.surface, shifted(0, kStep), i, j) -
                               Partial(sample.surface, shifted(0, -kStep), i, j)) /
                              (2 * kStep);
      // The lower one is rounded to 1e-16 of its size, over a step of 1e-6.
      const auto near = [&](double derivative, double difference) {
        const double lower = std::abs(Partial(sample.surface, at, i, j));
        const double size = std::pow(20.0, static_cast<double>(i + j));  // of what sums to it
        return std::abs(derivative - difference) < 1e-7 * (size + lower + std::abs(derivative));
      };
      RC_ASSERT(near(Partial(sample.surface, at, i + 1, j), by_elevation));
      RC_ASSERT(near(Partial(sample.surface, at, i, j + 1), by_plane));
    }
  }
}

RC_GTEST_PROP(SurfaceSpline, GivesItsPartialsAsJets, ()) {
  const Sample sample = AnySample();
  const auto place = sample.grid.PlaceOf(AnyPlace(sample.elevations), AnyPlace(sample.planes));
  const auto twice = sample.surface.JetsAt<2>(place)[0];
  const auto once = sample.surface.JetsAt<1>(place)[0];
  const std::array<std::array<std::size_t, 2>, 6> orders = {
      {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}}};
  RC_ASSERT(std::abs(sample.surface.At(place)[0] - twice.part[kValue]) < kRounding);
  for (std::size_t part = 0; part < orders.size(); ++part) {
    const auto [i, j] = orders[part];
    const double partial = Partial(sample.surface, place, i, j);
    RC_ASSERT(std::abs(twice.part[part] - partial) < DerivativeRounding(i, j));
    if (part < once.part.size()) RC_ASSERT(once.part[part] == twice.part[part]);
  }
}

RC_GTEST_PROP(SurfaceSpline, GivesEachOfAPairTheBitsItWouldHaveAlone, ()) {
  const Sample sample = AnySample();
  const SurfaceSpline<Pair, 1> pairs(sample.grid, [&](std::size_t i, std::size_t j) {
    return std::array<Pair, 1>{Pair(sample.values[i][j], -0.3 * sample.values[i][j])};
  });
  const SurfaceSpline<double, 1> second(sample.grid, [&](std::size_t i, std::size_t j) {
    return std::array<double, 1>{-0.3 * sample.values[i][j]};
  });
  const auto place = sample.grid.PlaceOf(AnyPlace(sample.elevations), AnyPlace(sample.planes));
  RC_ASSERT(pairs.At(place)[0][0] == sample.surface.At(place)[0]);
  RC_ASSERT(pairs.At(place)[0][1] == second.At(place)[0]);
  const auto jet = pairs.JetsAt<2>(place)[0];
  for (std::size_t part = 0; part < jet.part.size(); ++part) {
    RC_ASSERT(jet.part[part][0] == sample.surface.JetsAt<2>(place)[0].part[part]);
    RC_ASSERT(jet.part[part][1] == second.JetsAt<2>(place)[0].part[part]);
  }
}

// Differences of the surface along a line of the grid, at a point that moves with (e, p):
// e + 0.3 p + 0.1 e p.
RC_GTEST_PROP(SurfaceSpline, FollowsTheChainRule, ()) {
  constexpr double kStep = 1e-5;
  const Sample sample = AnySample();
  using Second = Jet<double, 2>;
  const double e = *NumberWithin(-1, 1);
  const double p = *NumberWithin(-1, 1);
  const bool by_plane = *rc::gen::arbitrary<bool>();
  const double other = by_plane ? AnyPlace(sample.elevations) : AnyPlace(sample.planes);
  const auto moving = [](const auto& e_at, const auto& p_at) {
    return e_at + 0.3 * p_at + 0.1 * (e_at * p_at);
  };
  const auto place_of = [&](double at) {
    return by_plane ? sample.grid.PlaceOf(other, at) : sample.grid.PlaceOf(at, other);
  };
  const auto jet_at = [&](double e_at, double p_at) {
    Second e_jet(e_at);
    Second p_jet(p_at);
    e_jet.part[kByElevation] = 1;
    p_jet.part[kByPlane] = 1;
    const Second at = moving(e_jet, p_jet);
    return by_plane ? Evaluate<0, 0>(sample.surface, sample.grid, other, at)[0]
                    : Evaluate<0, 0>(sample.surface, sample.grid, at, other)[0];
  };
  const Second jet = jet_at(e, p);
  const auto slope_of = [&](JetPart part, double e_step, double p_step) {
    return (jet_at(e + e_step, p + p_step).part[part] - jet_at(e - e_step, p - p_step).part[part]) /
           (2 * kStep);
  };
  const auto near = [](double derivative, double difference) {
    // Far outside, a cubic's third derivative makes differences worse.
    return std::abs(derivative - difference) < 1e-4 * (1 + std::abs(derivative));
  };
  const auto place = place_of(moving(e, p));
  RC_ASSERT(std::abs(jet.part[kValue] - sample.surface.At(place)[0]) <
            kRounding * (1 + std::abs(jet.part[kValue])));
  // Second derivatives leap by little within a step over a knot.
  RC_ASSERT(near(jet.part[kByElevation], slope_of(kValue, kStep, 0)));
  RC_ASSERT(near(jet.part[kByPlane], slope_of(kValue, 0, kStep)));
  const auto far = [&](double e_at, double p_at) {
    return place_of(moving(e_at, p_at)).cell != place.cell;
  };
  RC_PRE(!far(e + kStep, p) && !far(e - kStep, p) && !far(e, p + kStep) && !far(e, p - kStep));
  RC_ASSERT(near(jet.part[kByElevationTwice], slope_of(kByElevation, kStep, 0)));
  RC_ASSERT(near(jet.part[kByElevationAndPlane], slope_of(kByElevation, 0, kStep)));
  RC_ASSERT(near(jet.part[kByPlaneTwice], slope_of(kByPlane, 0, kStep)));
}

// The derivative by plane as a surface of its own, and the like.
RC_GTEST_PROP(SurfaceSpline, CarriesTheSlopesOfItsPartials, ()) {
  const Sample sample = AnySample();
  const double elevation = AnyPlace(sample.elevations);
  const double plane = AnyPlace(sample.planes);
  const double slope = *NumberWithin(-1, 1);
  Jet<double, 1> moving_elevation(elevation);
  moving_elevation.part[kByElevation] = slope;
  Jet<double, 1> moving_plane(plane);
  moving_plane.part[kByPlane] = slope;
  const auto place = sample.grid.PlaceOf(elevation, plane);
  const auto by_plane = Evaluate<0, 1>(sample.surface, sample.grid, moving_elevation, plane)[0];
  const auto by_elevation = Evaluate<1, 0>(sample.surface, sample.grid, elevation, moving_plane)[0];
  RC_ASSERT((by_plane.part[kValue] == sample.surface.Partial<0, 1>(place)[0]));
  RC_ASSERT((by_elevation.part[kValue] == sample.surface.Partial<1, 0>(place)[0]));
  const double mixed = slope * sample.surface.Partial<1, 1>(place)[0];
  RC_ASSERT(by_plane.part[kByElevation] == mixed);
  RC_ASSERT(by_elevation.part[kByPlane] == mixed);
  const auto dual =
      Evaluate<1, 0>(sample.surface, sample.grid, elevation, Dual<double>(plane, slope))[0];
  RC_ASSERT(dual.value == by_elevation.part[kValue] && dual.slope == mixed);
  RC_ASSERT(by_plane.part[kByPlane] == 0);
  RC_ASSERT(by_elevation.part[kByElevation] == 0);
}

}  // namespace
}  // namespace girdle::surface_spline_test
