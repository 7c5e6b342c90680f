// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Solids that blend into each other, as a function of position that is negative inside.
#pragma once

#include <vector>

#include "kinematics/rotation.h"

namespace girdle {

/// Two balls and everything between them: a rod of changing thickness.
struct RoundCone {
  Vector3 from_m{0, 0, 0};
  double from_radius_m = 0;
  Vector3 to_m{0, 0, 0};
  double to_radius_m = 0;
};

/// A rotated ellipsoid. Its axes are those of B in A, the frame of all positions.
struct TurnedEllipsoid {
  Vector3 center_m{0, 0, 0};
  Vector3 radii_m{0, 0, 0};
  Quaternion q_AB{1, 0, 0, 0};
};

/// The half space that the normal of a plane points away from.
struct HalfSpace {
  Vector3 point_m{0, 0, 0};
  Vector3 outward{0, 1, 0};  ///< normal of the plane, unit vector
};

/// Returns the signed distance [m] of a point. It is exact for a cone. For an ellipsoid it is
/// approximate, and good for points near one that is not as thin as a needle (Quilez:
/// k0 (k0 - 1) / k1, k0 = |p/r|, k1 = |p/r^2|).
[[nodiscard]] double SignedDistance_m(const RoundCone& cone, const Vector3& point_m) noexcept;
[[nodiscard]] double SignedDistance_m(const TurnedEllipsoid& ellipsoid,
                                      const Vector3& point_m) noexcept;

/// Solids with filled seams, cut by planes.
///
///     d = -k log sum_i exp(-d_i / k),      d_cut = k_c log(exp(d / k_c) + sum_j exp(h_j / k_c))
///
/// k is the blend, k_c the rounding of the cuts' edges [m]. The order of the solids does not
/// matter.
struct SmoothUnion {
  std::vector<RoundCone> cones;
  std::vector<TurnedEllipsoid> ellipsoids;
  std::vector<SmoothUnion> parts;  ///< solids that are unions themselves, with their own cuts
  std::vector<HalfSpace> cuts;     ///< half spaces that are kept
  double blend_m = 0.01;
  double rounding_m = 0.003;

  /// Returns the value [m] at a point. It is negative inside and nearly the distance near the
  /// surface.
  [[nodiscard]] double operator()(const Vector3& point_m) const noexcept;
};

}  // namespace girdle
