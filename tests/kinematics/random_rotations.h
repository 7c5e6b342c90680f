// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Random numbers, directions and rotations for property tests, and how a failing sample is shown.
#pragma once

#include <rapidcheck.h>

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <iomanip>
#include <limits>
#include <ostream>
#include <tuple>

#include "kinematics/rotation.h"

namespace glm {

inline void showValue(const girdle::Vector3& v, std::ostream& out) {
  out << std::setprecision(std::numeric_limits<double>::max_digits10) << "(" << v.x << ", " << v.y
      << ", " << v.z << ")";
}

inline void showValue(const girdle::Quaternion& q, std::ostream& out) {
  out << std::setprecision(std::numeric_limits<double>::max_digits10) << "(w " << q.w << ", x "
      << q.x << ", y " << q.y << ", z " << q.z << ")";
}

}  // namespace glm

namespace girdle {

/// Evenly spread over [lower, upper], whatever the size that RapidCheck asks for.
inline rc::Gen<double> NumberWithin(double lower, double upper) {
  constexpr std::int64_t kSteps = std::int64_t{1} << 53;
  return rc::gen::map(
      rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::int64_t>(0, kSteps + 1)),
      [lower, upper](std::int64_t step) {
        const double share = static_cast<double>(step) / static_cast<double>(kSteps);
        return lower + share * (upper - lower);
      });
}

/// Each component as NumberWithin.
inline rc::Gen<Vector3> VectorWithin(double lower, double upper) {
  const rc::Gen<double> number = NumberWithin(lower, upper);
  return rc::gen::map(rc::gen::tuple(number, number, number),
                      [](const std::tuple<double, double, double>& v) {
                        return Vector3(std::get<0>(v), std::get<1>(v), std::get<2>(v));
                      });
}

/// Unit vector of any direction.
inline rc::Gen<Vector3> UnitVector() {
  return rc::gen::map(rc::gen::pair(NumberWithin(-1, 1), NumberWithin(-kPi, kPi)),
                      [](const std::pair<double, double>& height_and_turn) {
                        const auto [height, turn] = height_and_turn;
                        const double radius = std::sqrt(1 - height * height);
                        return Vector3(radius * std::cos(turn), height, radius * std::sin(turn));
                      });
}

/// Unit quaternion of any rotation and either sign, evenly spread (Shoemake 1992).
inline rc::Gen<Quaternion> UnitQuaternion() {
  return rc::gen::map(
      rc::gen::tuple(NumberWithin(0, 1), NumberWithin(-kPi, kPi), NumberWithin(-kPi, kPi)),
      [](const std::tuple<double, double, double>& numbers) {
        const auto [share, first, second] = numbers;
        const double a = std::sqrt(1 - share);
        const double b = std::sqrt(share);
        return Quaternion(b * std::cos(second), a * std::sin(first), a * std::cos(first),
                          b * std::sin(second));
      });
}

/// Largest difference between the components of two quaternions: signs count.
inline double Difference(const Quaternion& a, const Quaternion& b) {
  double largest = 0;
  for (int i = 0; i < 4; ++i) {
    // Written so that a NaN is the largest of all.
    const double difference = std::abs(a[i] - b[i]);
    if (!(difference <= largest)) largest = difference;
  }
  return largest;
}

}  // namespace girdle
