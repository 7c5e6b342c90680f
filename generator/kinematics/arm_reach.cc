// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/arm_reach.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "kinematics/bump.h"
#include "kinematics/direction_algebra.h"
#include "kinematics/jet.h"

namespace girdle {
namespace {

constexpr double kCentreElevation_rad = 107.5 * kRadiansPerDegree;
constexpr double kRadius_rad = 45 * kRadiansPerDegree;
const double kCentreSine = std::sin(kCentreElevation_rad);
const double kCentreCosine = std::cos(kCentreElevation_rad);
const double kRadiusSine = std::sin(kRadius_rad);
const double kRadiusCosine = std::cos(kRadius_rad);

constexpr double kMiddlePlane_rad = (ArmReach::kFirstPlane_rad + ArmReach::kLastPlane_rad) / 2;
constexpr double kHalfWedge_rad = kPi - (ArmReach::kLastPlane_rad - kMiddlePlane_rad);

constexpr double kWedgeShare = 0.25;
constexpr double kWedgeUpTo_rad = 55 * kRadiansPerDegree;
constexpr double kWedgeFading_rad = 60 * kRadiansPerDegree;
constexpr double kNearestUpTo_rad = 20 * kRadiansPerDegree;
constexpr double kNearestFading_rad = 24 * kRadiansPerDegree;

ArmDirectionOf<double> ValuesOf(const ArmDirectionOf<double>& direction) noexcept {
  return direction;
}
template <int Order>
ArmDirectionOf<double> ValuesOf(const ArmDirectionOf<Jet<double, Order>>& direction) noexcept {
  return {ValueOf(direction.elevation_rad), ValueOf(direction.plane_rad)};
}

// Returns a plane of the chart, continued upward from the last plane.
template <typename T>
T Turned(const T& plane_rad) noexcept {
  return ValueOf(plane_rad) < kMiddlePlane_rad ? plane_rad + T(2 * kPi) : plane_rad;
}

}  // namespace

ArmReach::ArmReach(double first_plane_rad) noexcept
    : free_plane_rad_(std::clamp(first_plane_rad, kFirstPlane_rad, kFreePlane_rad)),
      centre_plane_rad_(free_plane_rad_ - std::asin(kRadiusSine / kCentreSine)) {
  if (centre_plane_rad_ >= kFirstPlane_rad) {
    corner_elevation_rad_ = kCentreElevation_rad - kRadius_rad;
  } else {
    // On the circle, cos R = cos(centre) cos(theta) + sin(centre) cos(psi - psi of the centre)
    // sin(theta). The corner is the lower of the two elevations at the first plane. They are equal
    // where the circle touches that plane.
    const double sine = kCentreSine * std::cos(kFirstPlane_rad - centre_plane_rad_);
    const double length = std::hypot(sine, kCentreCosine);
    corner_elevation_rad_ =
        std::asin(std::min(kRadiusCosine / length, 1.0)) - std::atan2(kCentreCosine, sine);
  }
  touch_elevation_rad_ =
      std::atan2(kCentreSine * std::cos(free_plane_rad_ - centre_plane_rad_), kCentreCosine);
}

double ArmReach::LowestPlaneAt(double elevation_rad) const noexcept {
  if (!(elevation_rad > corner_elevation_rad_)) {
    return kFirstPlane_rad;
  }
  if (elevation_rad >= touch_elevation_rad_) {
    return free_plane_rad_;
  }
  const double cosine = (kRadiusCosine - kCentreCosine * std::cos(elevation_rad)) /
                        (kCentreSine * std::sin(elevation_rad));
  return std::min(centre_plane_rad_ + std::acos(std::clamp(cosine, -1.0, 1.0)), free_plane_rad_);
}

// Returns the point where the great circle from the centre through the direction meets the circle.
// The axes are those of the centre: along its parallel to higher planes, and along its meridian to
// higher elevations.
template <typename T>
ArmDirectionOf<T> ArmReach::OnCircle(const ArmDirectionOf<T>& direction) const noexcept {
  const auto [sine, cosine] = SineAndCosineOf(direction.elevation_rad);
  const auto [across, along] = SineAndCosineOf(T(direction.plane_rad - T(centre_plane_rad_)));
  const T right = sine * across;
  const T up = kCentreCosine * (sine * along) - kCentreSine * cosine;
  const auto bearing = SineAndCosineOf(Atan2(up, right));
  // The foot: x along `right`, y toward hanging, z on the centre's meridian.
  const T x = kRadiusSine * bearing.cosine;
  const T rise = kRadiusSine * bearing.sine;
  const T z = T(kRadiusCosine * kCentreSine) + kCentreCosine * rise;
  const T down = T(kRadiusCosine * kCentreCosine) - kCentreSine * rise;
  return {Atan2(Sqrt(T(x * x + z * z)), down), T(centre_plane_rad_) + Atan2(x, z)};
}

ArmReach::Piece ArmReach::NearestPieceTo(const ArmDirectionOf<double>& direction) const noexcept {
  Piece nearest = Piece::kInFront;
  double distance_rad = AngleBetween(direction, FootOn(nearest, direction));
  for (const Piece piece : {Piece::kBehind, Piece::kBelow, Piece::kCircle, Piece::kAbove}) {
    const ArmDirectionOf<double> foot = FootOn(piece, direction);
    // Only the part of the circle in front of its centre is a limit, up to where it touches.
    const bool is_limit = piece != Piece::kCircle ||
                          (foot.plane_rad >= std::max(kFirstPlane_rad, centre_plane_rad_) &&
                           foot.elevation_rad <= touch_elevation_rad_);
    const double other_rad = AngleBetween(direction, foot);
    if (is_limit && other_rad < distance_rad) {
      nearest = piece;
      distance_rad = other_rad;
    }
  }
  return nearest;
}

template <typename T>
ArmDirectionOf<T> ArmReach::FootOn(Piece piece, const ArmDirectionOf<T>& direction) const noexcept {
  switch (piece) {
    case Piece::kInFront:
      return NearestOnPlane(direction, kLastPlane_rad, 0, kPi);
    case Piece::kBehind:
      return NearestOnPlane(direction, kFirstPlane_rad, 0, corner_elevation_rad_);
    case Piece::kBelow: {
      // Behind the circle's centre, the circle's lowest elevation is the limit.
      const bool is_beside = ValueOf(direction.plane_rad) >= kFirstPlane_rad &&
                             ValueOf(direction.plane_rad) <= centre_plane_rad_;
      return {T(corner_elevation_rad_), is_beside ? direction.plane_rad : T(kFirstPlane_rad)};
    }
    case Piece::kAbove:
      return NearestOnPlane(direction, free_plane_rad_, touch_elevation_rad_, kPi);
    case Piece::kCircle:
      break;
  }
  return OnCircle(direction);
}

// Straight up, every plane is the same direction, and the humerus rotates with the plane. The
// answer passes from one limit to the other where both are equally near.
template <typename T>
T ArmReach::PlaneStraightUp(const T& plane_rad) const noexcept {
  // With little room between the limits, AnswerTo gives the plane of this function no weight.
  constexpr double kLeastWidth_rad = 1 * kRadiansPerDegree;
  const double width_rad = std::max(kPi - (kLastPlane_rad - free_plane_rad_), kLeastWidth_rad);
  const T from_rad = T(OppositeAbove_rad() - width_rad / 2);
  return T(free_plane_rad_) + (kLastPlane_rad - free_plane_rad_) *
                                  Bump(T((1 / width_rad) * (Turned(plane_rad) - from_rad)));
}

template <typename T>
ArmDirectionOf<T> ArmReach::AnswerTo(const ArmDirectionOf<T>& direction) const noexcept {
  const T& theta = direction.elevation_rad;
  const T& psi = direction.plane_rad;
  // |s| / 0.25
  const T s = (1 / (kWedgeShare * kHalfWedge_rad)) * (ValueOf(psi) > kMiddlePlane_rad
                                                          ? T(kMiddlePlane_rad + kPi) - psi
                                                          : psi - T(kMiddlePlane_rad - kPi));
  const T low = Bump(T((1 / kWedgeFading_rad) * (theta - T(kWedgeUpTo_rad))));
  T beside_wedge = T(1.0) - Bump(s) * low;
  if (free_plane_rad_ < kFreePlane_rad) {
    const double half_rad = kPi - (kLastPlane_rad - free_plane_rad_) / 2;
    const T from_opposite = Turned(psi) - T(OppositeAbove_rad());
    // |t| / 0.25
    const T t = (1 / (kWedgeShare * half_rad)) *
                (ValueOf(from_opposite) < 0 ? T(0.0) - from_opposite : from_opposite);
    beside_wedge = beside_wedge * (T(1.0) - Bump(t) * (T(1.0) - low));
  }
  const ArmDirectionOf<double> values = ValuesOf(direction);
  const Piece piece = NearestPieceTo(values);
  const double distance_rad = AngleBetween(values, FootOn(piece, values));
  const T middle_elevation =
      theta * (T(1.0) - (1 - std::cos(kHalfWedge_rad)) * Bump(T((2 / kPi) * (theta - T(kPi / 2)))));
  const ArmDirectionOf<T> middle = {middle_elevation, T(kMiddlePlane_rad)};
  if (distance_rad >= kNearestUpTo_rad + kNearestFading_rad) {
    return middle;
  }
  ArmDirectionOf<T> nearest = FootOn(piece, direction);
  T share = beside_wedge;
  if (distance_rad > kNearestUpTo_rad) {
    share = share * Bump(T((1 / kNearestFading_rad) *
                           (AngleBetween(direction, nearest) - T(kNearestUpTo_rad))));
  }
  if (ValueOf(nearest.elevation_rad) == kPi) {
    nearest.plane_rad = PlaneStraightUp(psi);
  }
  return {middle.elevation_rad + share * (nearest.elevation_rad - middle.elevation_rad),
          middle.plane_rad + share * (nearest.plane_rad - middle.plane_rad)};
}

template ArmDirectionOf<double> ArmReach::AnswerTo(const ArmDirectionOf<double>&) const noexcept;
template ArmDirectionOf<Jet<double, 1>> ArmReach::AnswerTo(
    const ArmDirectionOf<Jet<double, 1>>&) const noexcept;
template ArmDirectionOf<Jet<double, 2>> ArmReach::AnswerTo(
    const ArmDirectionOf<Jet<double, 2>>&) const noexcept;

}  // namespace girdle
