// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Surfaces through values on a grid of elevations and planes, with continuous second derivatives.
///
/// A surface is the tensor product of cubic splines with the not-a-knot end condition (C. de Boor,
/// A Practical Guide to Splines, 2001, chapter IV). Third derivatives are continuous at the second
/// and the second last knot, so no assumption about the ends is needed. If a direction has three
/// knots, the parabola through them is used. Knots may be uneven.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "kinematics/jet.h"

namespace girdle {

/// The spline of one direction: its pieces, and the weights that give their polynomials from the
/// values at the knots.
class SplineAxis {
 public:
  static constexpr std::size_t kPowers = 4;          ///< of a cubic
  static constexpr std::size_t kParabolaPowers = 3;  ///< if there are three knots

  /// Precondition: `knots` increase strictly. Throws std::invalid_argument if there are fewer than
  /// three.
  explicit SplineAxis(const std::vector<double>& knots);

  [[nodiscard]] std::size_t knots() const noexcept { return knots_; }
  [[nodiscard]] std::size_t pieces() const noexcept { return breaks_.size() - 1; }
  /// The start of piece i, which is also the origin of its polynomial.
  [[nodiscard]] double origin(std::size_t piece) const noexcept { return breaks_[piece]; }
  /// Returns the piece i with origin_i < x <= origin_i+1. Outside the knots it is the first or last
  /// piece.
  [[nodiscard]] GIRDLE_INLINE std::size_t PieceAt(double x) const noexcept {
    const std::size_t last = pieces() - 1;
    // Correct for even breaks, nearly correct for others.
    const double guess = (x - breaks_.front()) * pieces_per_unit_;
    std::size_t piece =
        guess > 0 ? static_cast<std::size_t>(std::min(guess, static_cast<double>(last))) : 0;
    while (piece < last && x > breaks_[piece + 1]) {
      ++piece;
    }
    while (piece > 0 && x <= breaks_[piece]) {
      --piece;
    }
    return piece;
  }
  /// The coefficient of (x - origin)^power is the sum over all knots of weight times value.
  [[nodiscard]] double weight(std::size_t piece, std::size_t power,
                              std::size_t knot) const noexcept {
    return weights_[(piece * kPowers + power) * knots_ + knot];
  }
  /// Number of powers: 3 for a parabola, otherwise 4.
  [[nodiscard]] std::size_t powers() const noexcept { return powers_; }

 private:
  std::size_t knots_;
  std::size_t powers_;
  std::vector<double> breaks_;
  double pieces_per_unit_;
  std::vector<double> weights_;
};

/// The grid of elevations and planes that several surfaces share. It finds the place of a point.
class SurfaceGrid {
 public:
  /// The cell that contains a point, and the place within it.
  struct Place {
    std::size_t cell;
    double s;  ///< elevation from the cell's origin [rad]
    double t;  ///< plane from the cell's origin [rad]
  };

  SurfaceGrid(SplineAxis elevations, SplineAxis planes)
      : elevations_(std::move(elevations)), planes_(std::move(planes)) {}

  /// Returns the place of a point. Outside the grid it is in the nearest cell, whose polynomial
  /// continues.
  [[nodiscard]] GIRDLE_INLINE Place PlaceOf(double elevation_rad, double plane_rad) const noexcept {
    const std::size_t i = elevations_.PieceAt(elevation_rad);
    const std::size_t j = planes_.PieceAt(plane_rad);
    return {i * planes_.pieces() + j, elevation_rad - elevations_.origin(i),
            plane_rad - planes_.origin(j)};
  }

  [[nodiscard]] const SplineAxis& elevations() const noexcept { return elevations_; }
  [[nodiscard]] const SplineAxis& planes() const noexcept { return planes_; }

 private:
  SplineAxis elevations_;
  SplineAxis planes_;
};

/// K surfaces over (elevation, plane) [rad], each with values of the leaf type L (double, Pair or
/// Four). Evaluation allocates nothing.
template <typename L, std::size_t K>
class SurfaceSpline {
 public:
  using Values = std::array<L, K>;

  /// `value_at(elevation knot, plane knot)` returns the values at a knot. The surfaces pass through
  /// them.
  SurfaceSpline(const SurfaceGrid& grid,
                const std::function<Values(std::size_t, std::size_t)>& value_at)
      : plane_powers_(grid.planes().powers()) {
    std::vector<Values> values;
    for (std::size_t m = 0; m < grid.elevations().knots(); ++m) {
      for (std::size_t n = 0; n < grid.planes().knots(); ++n) {
        values.push_back(value_at(m, n));
      }
    }
    for (std::size_t i = 0; i < grid.elevations().pieces(); ++i) {
      for (std::size_t j = 0; j < grid.planes().pieces(); ++j) {
        for (std::size_t l = 0; l < plane_powers_; ++l) {
          Row& row = rows_.emplace_back();
          for (std::size_t k = 0; k < SplineAxis::kPowers; ++k) {
            row[k] = Coefficient(grid, i, k, j, l, values);
          }
        }
      }
    }
  }

  /// Returns the values at a place of the grid.
  [[nodiscard]] GIRDLE_INLINE Values At(const SurfaceGrid::Place& place) const noexcept {
    const Row* cell = CellAt(place);
    Values sum = Along(cell[2], place.s);
    if (plane_powers_ == SplineAxis::kPowers) {
      sum = Added(sum, place.t, Along(cell[3], place.s));
    }
    sum = Added(Along(cell[1], place.s), place.t, sum);
    return Added(Along(cell[0], place.s), place.t, sum);
  }

  /// Returns the values with their derivatives by elevation and plane.
  template <int Order>
  [[nodiscard]] std::array<Jet<L, Order>, K> JetsAt(
      const SurfaceGrid::Place& place) const noexcept {
    return plane_powers_ == SplineAxis::kParabolaPowers
               ? JetSum<Order, SplineAxis::kParabolaPowers>(place)
               : JetSum<Order, SplineAxis::kPowers>(place);
  }

  /// Returns the derivative of order I by elevation and J by plane.
  template <std::size_t I, std::size_t J>
  [[nodiscard]] GIRDLE_INLINE Values Partial(const SurfaceGrid::Place& place) const noexcept {
    if constexpr (I >= SplineAxis::kPowers || J >= SplineAxis::kPowers) {
      Values zero;
      zero.fill(L(0.0));
      return zero;
    } else {
      return plane_powers_ == SplineAxis::kParabolaPowers
                 ? PartialSum<I, J, SplineAxis::kParabolaPowers>(place)
                 : PartialSum<I, J, SplineAxis::kPowers>(place);
    }
  }

 private:
  /// Coefficients of one power of plane, ordered by power of elevation.
  using Row = std::array<Values, SplineAxis::kPowers>;

  /// Returns the coefficient of the powers k and l in piece (i, j). `values` are ordered elevation
  /// by elevation.
  [[nodiscard]] static Values Coefficient(const SurfaceGrid& grid, std::size_t i, std::size_t k,
                                          std::size_t j, std::size_t l,
                                          const std::vector<Values>& values) {
    Values sum;
    sum.fill(L(0.0));
    for (std::size_t m = 0; m < grid.elevations().knots(); ++m) {
      for (std::size_t n = 0; n < grid.planes().knots(); ++n) {
        const double weight = grid.elevations().weight(i, k, m) * grid.planes().weight(j, l, n);
        const Values& value = values[m * grid.planes().knots() + n];
        for (std::size_t c = 0; c < K; ++c) {
          sum[c] = sum[c] + weight * value[c];
        }
      }
    }
    return sum;
  }

  [[nodiscard]] GIRDLE_INLINE const Row* CellAt(const SurfaceGrid::Place& place) const noexcept {
    return rows_.data() + place.cell * plane_powers_;
  }

  /// The cubic in elevation that belongs to one power of plane.
  [[nodiscard]] GIRDLE_INLINE static Values Along(const Row& row, double s) noexcept {
    Values value;
    for (std::size_t c = 0; c < K; ++c) {
      value[c] = row[0][c] + s * (row[1][c] + s * (row[2][c] + s * row[3][c]));
    }
    return value;
  }
  /// a + t b
  [[nodiscard]] GIRDLE_INLINE static Values Added(const Values& a, double t,
                                                  const Values& b) noexcept {
    Values sum;
    for (std::size_t c = 0; c < K; ++c) {
      sum[c] = a[c] + t * b[c];
    }
    return sum;
  }

  template <int Order, std::size_t PlanePowers>
  [[nodiscard]] std::array<Jet<L, Order>, K> JetSum(
      const SurfaceGrid::Place& place) const noexcept {
    const Row* cell = CellAt(place);
    const double s = place.s;
    const double t = place.t;
    std::array<Jet<L, Order>, K> jets;
    jets.fill(Jet<L, Order>(L(0.0)));
    for (std::size_t l = PlanePowers; l-- > 0;) {
      const Row& row = cell[l];
      for (std::size_t c = 0; c < K; ++c) {
        auto& part = jets[c].part;
        const L value = row[0][c] + s * (row[1][c] + s * (row[2][c] + s * row[3][c]));
        const L slope = row[1][c] + s * (2.0 * row[2][c] + (3.0 * s) * row[3][c]);
        if constexpr (Order == 2) {
          // Each line uses the values of the parts before this power.
          part[kByPlaneTwice] = 2.0 * part[kByPlane] + t * part[kByPlaneTwice];
          part[kByElevationAndPlane] = part[kByElevation] + t * part[kByElevationAndPlane];
          part[kByElevationTwice] =
              2.0 * row[2][c] + (6.0 * s) * row[3][c] + t * part[kByElevationTwice];
        }
        part[kByPlane] = part[kValue] + t * part[kByPlane];
        part[kByElevation] = slope + t * part[kByElevation];
        part[kValue] = value + t * part[kValue];
      }
    }
    return jets;
  }

  /// Sum over the powers k of s and l of t, by Horner's rule in both.
  template <std::size_t I, std::size_t J, std::size_t PlanePowers>
  [[nodiscard]] GIRDLE_INLINE Values PartialSum(const SurfaceGrid::Place& place) const noexcept {
    const Row* cell = CellAt(place);
    Values sum;
    sum.fill(L(0.0));
    for (std::size_t l = PlanePowers; l-- > J;) {
      for (std::size_t c = 0; c < K; ++c) {
        L value = Falling(SplineAxis::kPowers - 1, I) * cell[l][SplineAxis::kPowers - 1][c];
        for (std::size_t k = SplineAxis::kPowers - 1; k-- > I;) {
          value = Falling(k, I) * cell[l][k][c] + place.s * value;
        }
        sum[c] = Falling(l, J) * value + place.t * sum[c];
      }
    }
    return sum;
  }

  /// n (n - 1) ... (n - count + 1).
  [[nodiscard]] static constexpr double Falling(std::size_t n, std::size_t count) noexcept {
    double product = 1;
    for (std::size_t i = 0; i < count; ++i) {
      product *= static_cast<double>(n - i);
    }
    return product;
  }

  std::size_t plane_powers_;
  std::vector<Row> rows_;  ///< cell by cell; each cell has its powers of plane
};

/// Returns the derivative of order I by elevation and J by plane of the surfaces at a point. One
/// coordinate of the point may carry derivatives itself.
template <std::size_t I, std::size_t J, typename L, std::size_t K>
[[nodiscard]] std::array<L, K> Evaluate(const SurfaceSpline<L, K>& surface, const SurfaceGrid& grid,
                                        double elevation_rad, double plane_rad) noexcept {
  return surface.template Partial<I, J>(grid.PlaceOf(elevation_rad, plane_rad));
}
/// Composes f with a coordinate x, from f and its first and second derivative by x.
template <typename L, std::size_t K, int Order>
[[nodiscard]] std::array<Jet<L, Order>, K> ComposedValues(const Jet<double, Order>& x,
                                                          const std::array<L, K>& f,
                                                          const std::array<L, K>& slope,
                                                          const std::array<L, K>& curvature) {
  Jet<L, Order> leaves;
  for (std::size_t part = 0; part < leaves.part.size(); ++part) {
    leaves.part[part] = L(x.part[part]);
  }
  std::array<Jet<L, Order>, K> result;
  for (std::size_t c = 0; c < K; ++c) {
    result[c] = Composed(leaves, f[c], slope[c], curvature[c]);
  }
  return result;
}
template <std::size_t I, std::size_t J, typename L, std::size_t K, int Order>
[[nodiscard]] std::array<Jet<L, Order>, K> Evaluate(const SurfaceSpline<L, K>& surface,
                                                    const SurfaceGrid& grid,
                                                    const Jet<double, Order>& elevation_rad,
                                                    double plane_rad) noexcept {
  const SurfaceGrid::Place place = grid.PlaceOf(elevation_rad.part[kValue], plane_rad);
  return ComposedValues(elevation_rad, surface.template Partial<I, J>(place),
                        surface.template Partial<I + 1, J>(place),
                        surface.template Partial<I + 2, J>(place));
}
template <std::size_t I, std::size_t J, typename L, std::size_t K, int Order>
[[nodiscard]] std::array<Jet<L, Order>, K> Evaluate(const SurfaceSpline<L, K>& surface,
                                                    const SurfaceGrid& grid, double elevation_rad,
                                                    const Jet<double, Order>& plane_rad) noexcept {
  const SurfaceGrid::Place place = grid.PlaceOf(elevation_rad, plane_rad.part[kValue]);
  return ComposedValues(plane_rad, surface.template Partial<I, J>(place),
                        surface.template Partial<I, J + 1>(place),
                        surface.template Partial<I, J + 2>(place));
}

template <std::size_t I, std::size_t J, typename L, std::size_t K>
[[nodiscard]] std::array<Dual<L>, K> Evaluate(const SurfaceSpline<L, K>& surface,
                                              const SurfaceGrid& grid, double elevation_rad,
                                              const Dual<double>& plane_rad) noexcept {
  const SurfaceGrid::Place place = grid.PlaceOf(elevation_rad, plane_rad.value);
  const auto value = surface.template Partial<I, J>(place);
  const auto slope = surface.template Partial<I, J + 1>(place);
  std::array<Dual<L>, K> result;
  for (std::size_t c = 0; c < K; ++c) {
    result[c] = {value[c], L(plane_rad.slope) * slope[c]};
  }
  return result;
}

}  // namespace girdle
