// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/surface_spline.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace girdle {
namespace {

/// Rows of a small dense matrix.
using Matrix = std::vector<std::vector<double>>;

// Solves a x = b for several right-hand sides at once, by elimination with row exchange. x replaces
// b. The systems of this file are never singular.
void Solve(Matrix& a, Matrix& b) {
  const std::size_t n = a.size();
  for (std::size_t column = 0; column < n; ++column) {
    std::size_t pivot = column;
    for (std::size_t row = column + 1; row < n; ++row) {
      if (std::abs(a[row][column]) > std::abs(a[pivot][column])) {
        pivot = row;
      }
    }
    std::swap(a[column], a[pivot]);
    std::swap(b[column], b[pivot]);
    for (std::size_t row = 0; row < n; ++row) {
      if (row == column) {
        continue;
      }
      const double factor = a[row][column] / a[column][column];
      for (std::size_t k = column; k < n; ++k) {
        a[row][k] -= factor * a[column][k];
      }
      for (std::size_t k = 0; k < b[row].size(); ++k) {
        b[row][k] -= factor * b[column][k];
      }
    }
  }
  for (std::size_t row = 0; row < n; ++row) {
    for (double& value : b[row]) {
      value /= a[row][row];
    }
  }
}

// Returns weights w of the values f for the slopes m at the knots of the not-a-knot spline: m_i =
// sum_k w_ik f_k. Here h_i is the width of interval i and d_i = (f_i+1 - f_i) / h_i. Second
// derivatives agree at the inner knots, and third derivatives agree at the second and the second
// last knot:
//   h_i m_i-1 + 2 (h_i-1 + h_i) m_i + h_i-1 m_i+1 = 3 (h_i d_i-1 + h_i-1 d_i)
//   (m_0 + m_1 - 2 d_0) / h_0^2 = (m_1 + m_2 - 2 d_1) / h_1^2
Matrix SlopeWeights(const std::vector<double>& knots) {
  const std::size_t n = knots.size();
  const auto width = [&knots](std::size_t i) { return knots[i + 1] - knots[i]; };
  Matrix a(n, std::vector<double>(n));
  Matrix b(n, std::vector<double>(n));
  const auto add_secant = [&](std::size_t row, std::size_t interval, double factor) {
    b[row][interval + 1] += factor / width(interval);
    b[row][interval] -= factor / width(interval);
  };
  for (std::size_t i = 1; i + 1 < n; ++i) {
    a[i][i - 1] = width(i);
    a[i][i] = 2 * (width(i - 1) + width(i));
    a[i][i + 1] = width(i - 1);
    add_secant(i, i - 1, 3 * width(i));
    add_secant(i, i, 3 * width(i - 1));
  }
  const auto join = [&](std::size_t row, std::size_t i) {
    const double first = 1 / (width(i) * width(i));
    const double second = 1 / (width(i + 1) * width(i + 1));
    a[row][i] = first;
    a[row][i + 1] = first - second;
    a[row][i + 2] = -second;
    add_secant(row, i, 2 * first);
    add_secant(row, i + 1, -2 * second);
  };
  join(0, 0);
  join(n - 1, n - 3);
  Solve(a, b);
  return b;
}

constexpr std::size_t kParabolaKnots = 3;

}  // namespace

SplineAxis::SplineAxis(const std::vector<double>& knots)
    : knots_(knots.size()), powers_(knots_ == kParabolaKnots ? kParabolaPowers : kPowers) {
  if (knots_ < kParabolaKnots) {
    throw std::invalid_argument(std::to_string(knots_) + " knots given, at least 3 are needed");
  }
  // The second and the second last knot are no breaks: one polynomial continues over each of them.
  breaks_.push_back(knots.front());
  for (std::size_t i = 2; i + 2 < knots_; ++i) {
    breaks_.push_back(knots[i]);
  }
  breaks_.push_back(knots.back());
  pieces_per_unit_ = static_cast<double>(pieces()) / (breaks_.back() - breaks_.front());
  weights_.resize(pieces() * kPowers * knots_);
  const auto set = [this](std::size_t piece, std::size_t power, std::size_t knot, double value) {
    weights_[(piece * kPowers + power) * knots_ + knot] = value;
  };
  if (knots_ == kParabolaKnots) {
    // Newton's form, f_0 + [f_0 f_1] s + [f_0 f_1 f_2] s (s - h_0), expanded in powers of s.
    const double h_0 = knots[1] - knots[0];
    const double h_1 = knots[2] - knots[1];
    const std::array<double, 3> second = {1 / (h_0 * (h_0 + h_1)), -1 / (h_0 * h_1),
                                          1 / (h_1 * (h_0 + h_1))};
    const std::array<double, 3> first = {-1 / h_0, 1 / h_0, 0};
    set(0, 0, 0, 1);
    for (std::size_t knot = 0; knot < kParabolaKnots; ++knot) {
      set(0, 1, knot, first[knot] - h_0 * second[knot]);
      set(0, 2, knot, second[knot]);
    }
    return;
  }
  const Matrix slopes = SlopeWeights(knots);
  for (std::size_t piece = 0; piece < pieces(); ++piece) {
    // The knot interval at whose beginning the piece begins.
    const std::size_t i = piece == 0 ? 0 : piece + 1;
    const double h = knots[i + 1] - knots[i];
    for (std::size_t knot = 0; knot < knots_; ++knot) {
      const double f_0 = knot == i ? 1 : 0;
      const double f_1 = knot == i + 1 ? 1 : 0;
      const double d = (f_1 - f_0) / h;
      const double m_0 = slopes[i][knot];
      const double m_1 = slopes[i + 1][knot];
      set(piece, 0, knot, f_0);
      set(piece, 1, knot, m_0);
      set(piece, 2, knot, (3 * d - 2 * m_0 - m_1) / h);
      set(piece, 3, knot, (m_0 + m_1 - 2 * d) / (h * h));
    }
  }
}

}  // namespace girdle
