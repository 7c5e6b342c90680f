// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Rotation matrices from sines and cosines alone, to hold quaternions against.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "kinematics/rotation.h"

namespace girdle {

/// Element [row][column].
using RowMatrix = std::array<std::array<double, 3>, 3>;

inline RowMatrix TurnAboutX(double angle_rad) {
  const double c = std::cos(angle_rad);
  const double s = std::sin(angle_rad);
  return {{{1, 0, 0}, {0, c, -s}, {0, s, c}}};
}

inline RowMatrix TurnAboutY(double angle_rad) {
  const double c = std::cos(angle_rad);
  const double s = std::sin(angle_rad);
  return {{{c, 0, s}, {0, 1, 0}, {-s, 0, c}}};
}

inline RowMatrix TurnAboutZ(double angle_rad) {
  const double c = std::cos(angle_rad);
  const double s = std::sin(angle_rad);
  return {{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}};
}

inline RowMatrix Product(const RowMatrix& a, const RowMatrix& b) {
  RowMatrix product{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      for (std::size_t k = 0; k < 3; ++k) {
        product[row][column] += a[row][k] * b[k][column];
      }
    }
  }
  return product;
}

/// Largest difference between a matrix and what a quaternion makes of the three unit vectors.
inline double Difference(const RowMatrix& matrix, const Quaternion& q_AB) {
  double largest = 0;
  for (int column = 0; column < 3; ++column) {
    Vector3 unit{0, 0, 0};
    unit[column] = 1;
    const Vector3 turned = q_AB * unit;
    for (int row = 0; row < 3; ++row) {
      // Written so that a NaN is the largest of all.
      const double difference = std::abs(
          matrix[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] - turned[row]);
      if (!(difference <= largest)) largest = difference;
    }
  }
  return largest;
}

}  // namespace girdle
