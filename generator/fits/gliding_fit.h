// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The surface that the scapula glides on: an ellipsoid fitted to measured positions of TS and AI.
///
/// The axes of the ellipsoid are parallel to the thorax's. Its centre c and radii r minimize
///
///     sum d_k(c, r)^2 + w^2 (|c - c_0|^2 + |r - r_0|^2)
///
/// d_k are the signed distances of the points from the surface. c_0 and r_0 are those of the
/// ribcage, where the iteration (Levenberg-Marquardt) starts.
///
/// Two points that sweep a patch of some centimeters do not determine a whole ellipsoid. c and r
/// can change in six directions, and some of these move the patch by only a hundredth of the
/// change. The second term therefore pulls the fit towards the ribcage. Its weight is as small as
/// the known difference between both surfaces allows: w = 4 mm / 70 mm. 4 mm is the scatter of the
/// points about their surface. 70 mm is the rms difference of the six numbers between two published
/// ellipsoids under a scapula (Klein Breteler et al. 1999; Seth et al. 2016). The second term does
/// not change a number that the points determine. A number that they do not determine stays at the
/// ribcage's value.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "anatomy/anatomy.h"
#include "kinematics/rhythm_table.h"

namespace girdle {

/// An ellipsoid fitted to points.
struct EllipsoidFit {
  Ellipsoid ellipsoid;
  /// Standard deviations of the six numbers if the points scatter independently. The points of a
  /// sweep do not, so the true ones are at least these.
  Ellipsoid deviation;
};

/// Returns the ellipsoid that fits `points_m` [m], pulled towards `ribcage` by the sum at the top
/// of this header. Throws std::invalid_argument if there are fewer points than numbers to find, or
/// if no ellipsoid of a body's size fits: the centre or a radius is beyond 1 m.
[[nodiscard]] EllipsoidFit FitEllipsoid(std::span<const Vector3> points_m,
                                        const Ellipsoid& ribcage);

/// Returns the ellipsoid, in the thorax frame, that fits TS and AI of an anatomy's scapula. The
/// positions are those of a table with measured SC and AC. Throws like FitEllipsoid.
[[nodiscard]] EllipsoidFit FitGlidingEllipsoid(const Anatomy& anatomy, const RhythmTable& table);

/// Distance of one landmark from a surface over the measured positions of a table.
struct GlidingDistance {
  Landmark landmark;
  double rms_m;
  double worst_m;  ///< signed, positive outside
  double elevation_rad;
  double plane_rad;  ///< elevation and plane of the worst distance
};

/// Returns the distances of kGlidingLandmarks, in their order. Precondition: at least one position
/// of the table was measured.
[[nodiscard]] std::array<GlidingDistance, kGlidingLandmarks.size()> MeasureGliding(
    const Ellipsoid& ellipsoid, const Anatomy& anatomy, const RhythmTable& table);

/// Returns the number of positions of a table with measured SC and AC.
[[nodiscard]] std::size_t MeasuredPositionCount(const RhythmTable& table) noexcept;

}  // namespace girdle
