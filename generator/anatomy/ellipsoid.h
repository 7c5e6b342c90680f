// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Points and the surface of an ellipsoid, such as the one that the scapula glides on.
#pragma once

#include "anatomy/anatomy.h"

namespace girdle {

/// The point of a surface that is nearest to another point.
struct SurfacePoint {
  Vector3 position_m;  ///< in the ellipsoid's frame
  Vector3 normal;      ///< of length 1, outward
  double distance_m;   ///< of the other point, positive outside
};

/// Returns the nearest point of the surface, exact to rounding for any point; where several are as
/// near, deep inside, one of them. Radii must be positive.
[[nodiscard]] SurfacePoint NearestOnEllipsoid(const Ellipsoid& ellipsoid,
                                              const Vector3& point_m) noexcept;

/// Returns the signed distance [m] of a point from an ellipsoid's surface, positive outside.
[[nodiscard]] double DistanceFromEllipsoid(const Ellipsoid& ellipsoid,
                                           const Vector3& point_m) noexcept;

}  // namespace girdle
