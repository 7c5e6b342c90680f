// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The nearest point and the distance of an ellipsoid's surface, for example that on which the
/// scapula glides.
#pragma once

#include "anatomy/anatomy.h"

namespace girdle {

/// The point of a surface that is nearest to a given point.
struct SurfacePoint {
  Vector3 position_m;  ///< in the ellipsoid's frame
  Vector3 normal;      ///< unit vector, outward
  double distance_m;   ///< of the given point from the surface, positive outside
};

/// Returns the nearest point of the surface, exact to rounding for any point. Deep inside, several
/// points may be equally near; the result is then one of them. Precondition: radii are positive.
[[nodiscard]] SurfacePoint NearestOnEllipsoid(const Ellipsoid& ellipsoid,
                                              const Vector3& point_m) noexcept;

/// Returns the signed distance [m] of a point from an ellipsoid's surface, positive outside.
[[nodiscard]] double DistanceFromEllipsoid(const Ellipsoid& ellipsoid,
                                           const Vector3& point_m) noexcept;

}  // namespace girdle
