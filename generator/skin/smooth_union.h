// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Solids that flow into each other, as a function of the place that is negative inside.
#pragma once

#include <vector>

#include "kinematics/rotation.h"

namespace girdle {

/// Two balls and all that lies between them: a rod whose thickness changes.
struct RoundCone {
  Vector3 from_m{0, 0, 0};
  double from_radius_m = 0;
  Vector3 to_m{0, 0, 0};
  double to_radius_m = 0;
};

/// An ellipsoid, turned: its axes are those of B in A, the frame of all places.
struct TurnedEllipsoid {
  Vector3 center_m{0, 0, 0};
  Vector3 radii_m{0, 0, 0};
  Quaternion q_AB{1, 0, 0, 0};
};

/// What lies on the side of a plane that its normal points away from.
struct HalfSpace {
  Vector3 point_m{0, 0, 0};
  Vector3 outward{0, 1, 0};  ///< of length 1
};

/// Returns the signed distance [m] of a point, exact for a cone, nearly so for an ellipsoid that is
/// no needle and for points near it (Quilez: k0 (k0 - 1) / k1, k0 = |p/r|, k1 = |p/r^2|).
[[nodiscard]] double SignedDistance_m(const RoundCone& cone, const Vector3& point_m) noexcept;
[[nodiscard]] double SignedDistance_m(const TurnedEllipsoid& ellipsoid,
                                      const Vector3& point_m) noexcept;

/// Solids whose seams are filled, cut by planes.
///
///     d = -k log sum_i exp(-d_i / k),      d_cut = k_c log(exp(d / k_c) + sum_j exp(h_j / k_c))
///
/// k the blend, k_c the rounding of the cuts' edges [m]. The order of the solids does not matter.
struct SmoothUnion {
  std::vector<RoundCone> cones;
  std::vector<TurnedEllipsoid> ellipsoids;
  std::vector<SmoothUnion> parts;  ///< solids that are unions themselves, each with cuts of its own
  std::vector<HalfSpace> cuts;     ///< what is kept
  double blend_m = 0.01;
  double rounding_m = 0.003;

  /// Returns the value [m] at a point: negative inside, about the distance near the surface.
  [[nodiscard]] double operator()(const Vector3& point_m) const noexcept;
};

}  // namespace girdle
