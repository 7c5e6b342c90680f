// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/arm_directions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace girdle {
namespace {

// For angles up to an eighth of a turn.
constexpr auto kCosine = rotation_algebra_detail::AlternatingSeries<9>(0);
constexpr auto kSine = rotation_algebra_detail::AlternatingSeries<8>(1);
// pi/2 in two parts, the first with a short significand, so that small multiples of it are exact.
constexpr double kQuarterTurnHigh = 1.5707963109016418;
constexpr double kQuarterTurnLow = 1.5893254773528196e-08;

// Of two angles.
struct SinesAndCosines {
  Pair sine;
  Pair cosine;
};

// With x = n pi/2 + r, |r| <= pi/4, the series of r, changed places and signs by the quadrant n.
[[gnu::noinline]] SinesAndCosines SineAndCosine(Pair x) noexcept {
  const Pair n = Pair::Rounded((2 / kPi) * x);
  const Pair r = (x - kQuarterTurnHigh * n) - kQuarterTurnLow * n;
  const Pair square = r * r;
  const Pair sine = r * PolynomialValue(kSine, square);
  const Pair cosine = PolynomialValue(kCosine, square);
  const auto one = [&](std::size_t i) -> std::array<double, 2> {
    const auto quadrant = static_cast<long long>(n[i]) & 3;
    const double along = (quadrant & 1) != 0 ? cosine[i] : sine[i];
    const double across = (quadrant & 1) != 0 ? sine[i] : cosine[i];
    return {(quadrant & 2) != 0 ? -along : along,
            quadrant == 1 || quadrant == 2 ? -across : across};
  };
  const auto first = one(0);
  const auto second = one(1);
  return {{first[0], second[0]}, {first[1], second[1]}};
}

}  // namespace

// Both to 2 units in the last place of 1 for angles of some turns, which is all that an arm has.
QuaternionOf<double> HumerusRotation(double theta_rad, double psi_rad, double tau_rad) noexcept {
  const SinesAndCosines half = SineAndCosine(Pair(0.5 * theta_rad, 0.5 * tau_rad));
  const SinesAndCosines across = SineAndCosine(Pair(psi_rad - 0.5 * tau_rad));
  return {half.cosine[0] * half.cosine[1], -(half.sine[0] * across.cosine[0]),
          half.cosine[0] * half.sine[1], half.sine[0] * across.sine[0]};
}

LowestPlane LowestPlaneAt(double elevation_rad) noexcept {
  constexpr double kFree_rad = -60 * kRadiansPerDegree;
  constexpr double kTight_rad = -30 * kRadiansPerDegree;
  constexpr double kFreeUpTo_rad = 60 * kRadiansPerDegree;
  constexpr double kTightFrom_rad = 85 * kRadiansPerDegree;
  constexpr double kSlope = (kTight_rad - kFree_rad) / (kTightFrom_rad - kFreeUpTo_rad);
  if (!(elevation_rad > kFreeUpTo_rad)) {
    return {kFree_rad, 0};
  }
  if (elevation_rad >= kTightFrom_rad) {
    return {kTight_rad, 0};
  }
  return {kFree_rad + kSlope * (elevation_rad - kFreeUpTo_rad), kSlope};
}

double AngleFromRectangle(const ArmRectangle& rectangle, double elevation_rad,
                          double plane_rad) noexcept {
  const double theta = std::clamp(elevation_rad, 0.0, kPi);
  const double lowest = rectangle.lowest_elevation_rad;
  const double highest = rectangle.highest_elevation_rad;
  // The plane from the middle of the rectangle's, in [-pi, pi].
  const double middle = (rectangle.first_plane_rad + rectangle.last_plane_rad) / 2;
  const double half_width = (rectangle.last_plane_rad - rectangle.first_plane_rad) / 2;
  const double beyond = std::abs(std::remainder(plane_rad - middle, 2 * kPi)) - half_width;
  if (!(beyond > 0)) {
    return std::max({lowest - theta, theta - highest, 0.0});
  }
  // The nearest direction lies on the edge plane, `beyond` away. Along it the cosine of the angle
  // is cos(theta) cos(e) + sin(theta) sin(e) cos(beyond), largest at this elevation e.
  const double along = std::atan2(std::sin(theta) * std::cos(beyond), std::cos(theta));
  const double end = std::cos(along - lowest) < std::cos(along - highest) ? highest : lowest;
  const double e = along > lowest && along < highest ? along : end;
  const double sine_half_e = std::sin((theta - e) / 2);
  const double sine_half_b = std::sin(beyond / 2);
  // Haversine formula: precise for small angles.
  const double h =
      sine_half_e * sine_half_e + std::sin(theta) * std::sin(e) * sine_half_b * sine_half_b;
  return 2 * std::asin(std::min(std::sqrt(h), 1.0));
}

}  // namespace girdle
