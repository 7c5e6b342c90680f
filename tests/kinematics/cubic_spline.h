// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The interpolating cubic spline by its textbook definition, to hold the product's against.
///
/// Every interval has four unknown coefficients. Equations: the values at both ends of every
/// interval, first and second derivatives continuous over inner knots, third ones over the second
/// and the second last. Three knots: Lagrange's parabola.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace girdle {

class CubicSpline {
 public:
  CubicSpline(std::vector<double> knots, std::vector<double> values)
      : knots_(std::move(knots)), values_(std::move(values)) {
    if (knots_.size() > 3) Solve();
  }

  /// Outside the knots the nearest polynomial goes on.
  [[nodiscard]] double At(double x) const {
    if (coefficients_.empty()) return Parabola(x);
    const auto upper = std::lower_bound(knots_.begin() + 1, knots_.end() - 1, x);
    const auto i = static_cast<std::size_t>(upper - knots_.begin()) - 1;
    const long double s = Share(i, x);
    const long double* const c = &coefficients_[4 * i];
    return static_cast<double>(c[0] + s * (c[1] + s * (c[2] + s * c[3])));
  }

 private:
  using Row = std::vector<long double>;

  [[nodiscard]] long double Width(std::size_t i) const {
    return static_cast<long double>(knots_[i + 1]) - knots_[i];
  }
  // Each interval has its own variable from 0 to 1.
  [[nodiscard]] long double Share(std::size_t i, double x) const {
    return (static_cast<long double>(x) - knots_[i]) / Width(i);
  }

  [[nodiscard]] double Parabola(double x) const {
    long double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      long double product = values_[i];
      for (std::size_t j = 0; j < 3; ++j) {
        if (j != i) {
          product *= (static_cast<long double>(x) - knots_[j]) /
                     (static_cast<long double>(knots_[i]) - knots_[j]);
        }
      }
      sum += product;
    }
    return static_cast<double>(sum);
  }

  void Solve() {
    const std::size_t intervals = knots_.size() - 1;
    const std::size_t unknowns = 4 * intervals;
    std::vector<Row> rows;  // with the right-hand side at the end
    const auto equation = [&]() -> Row& { return rows.emplace_back(unknowns + 1, 0); };
    for (std::size_t i = 0; i < intervals; ++i) {
      Row& begin = equation();
      begin[4 * i] = 1;
      begin[unknowns] = values_[i];
      Row& end = equation();
      for (std::size_t k = 0; k < 4; ++k) end[4 * i + k] = 1;
      end[unknowns] = values_[i + 1];
    }
    // Derivatives of s^k at 1: 1, k, k (k - 1), ...
    const auto join = [&](std::size_t i, std::size_t order) {
      const std::array<std::array<long double, 4>, 4> at_end = {
          {{1, 1, 1, 1}, {0, 1, 2, 3}, {0, 0, 2, 6}, {0, 0, 0, 6}}};
      const std::array<long double, 4> at_begin = {1, 1, 2, 6};
      Row& row = equation();
      for (std::size_t k = 0; k < 4; ++k) {
        row[4 * i + k] = at_end[order][k] / std::pow(Width(i), static_cast<long double>(order));
      }
      row[4 * (i + 1) + order] =
          -at_begin[order] / std::pow(Width(i + 1), static_cast<long double>(order));
    };
    for (std::size_t i = 0; i + 1 < intervals; ++i) {
      join(i, 1);
      join(i, 2);
    }
    join(0, 3);
    if (intervals > 2) join(intervals - 2, 3);
    Eliminate(rows);
    for (const Row& row : rows) coefficients_.push_back(row[unknowns]);
  }

  // Gauss and Jordan with row exchange.
  static void Eliminate(std::vector<Row>& rows) {
    const std::size_t n = rows.size();
    for (std::size_t column = 0; column < n; ++column) {
      std::size_t pivot = column;
      for (std::size_t row = column + 1; row < n; ++row) {
        if (std::abs(rows[row][column]) > std::abs(rows[pivot][column])) pivot = row;
      }
      std::swap(rows[pivot], rows[column]);
      const long double scale = rows[column][column];
      for (long double& element : rows[column]) element /= scale;
      for (std::size_t row = 0; row < n; ++row) {
        const long double factor = rows[row][column];
        if (row == column || factor == 0) continue;
        for (std::size_t k = column; k <= n; ++k) rows[row][k] -= factor * rows[column][k];
      }
    }
  }

  std::vector<double> knots_;
  std::vector<double> values_;
  Row coefficients_;
};

}  // namespace girdle
