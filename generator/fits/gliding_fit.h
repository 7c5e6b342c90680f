// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The surface that the scapula glides on: an ellipsoid fitted to where TS and AI were measured.
///
/// Centre c and radii r, axes parallel to the thorax's, are those that make
///
///     sum d_k(c, r)^2 + w^2 (|c - c_0|^2 + |r - r_0|^2)
///
/// least, d_k the signed distances of the points from the surface and c_0, r_0 the ribcage
/// (Levenberg-Marquardt, from the ribcage on).
///
/// Two points that sweep a patch of some centimeters say little of a whole ellipsoid: of the six
/// directions in which c and r can change, some move the patch by a hundredth of themselves. So the
/// fit is pulled towards the ribcage, as weakly as it is known that the two are alike:
/// w = 4 mm / 70 mm, the scatter of the points about their surface over what two published
/// ellipsoids under a scapula differ by, rms of the six numbers (Klein Breteler et al. 1999; Seth
/// et al. 2016). What the points determine, this does not touch; what they do not, stays at the
/// ribcage's.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "anatomy/anatomy.h"
#include "kinematics/rhythm_table.h"

namespace girdle {

/// An ellipsoid through points.
struct EllipsoidFit {
  Ellipsoid ellipsoid;
  /// Standard deviations of the six numbers, if the points scatter independently; those of a sweep
  /// do not, so take them for the least.
  Ellipsoid deviation;
};

/// Returns the ellipsoid that fits `points_m` [m], pulled towards `ribcage` as above. Throws
/// std::invalid_argument if there are fewer points than numbers to find, or if none of a body's
/// size fits: centre or a radius beyond 1 m.
[[nodiscard]] EllipsoidFit FitEllipsoid(std::span<const Vector3> points_m,
                                        const Ellipsoid& ribcage);

/// Returns the ellipsoid, in the thorax frame, that fits TS and AI of an anatomy's scapula in the
/// positions of a table whose SC and AC were measured. Throws as FitEllipsoid.
[[nodiscard]] EllipsoidFit FitGlidingEllipsoid(const Anatomy& anatomy, const RhythmTable& table);

/// How far one landmark is from a surface over the measured positions of a table.
struct GlidingDistance {
  Landmark landmark;
  double rms_m;
  double worst_m;  ///< signed, positive outside
  double elevation_rad;
  double plane_rad;  ///< where it is worst
};

/// Returns the distances of kGlidingLandmarks, in their order. Precondition: a position of the
/// table was measured.
[[nodiscard]] std::array<GlidingDistance, kGlidingLandmarks.size()> MeasureGliding(
    const Ellipsoid& ellipsoid, const Anatomy& anatomy, const RhythmTable& table);

/// Returns how many positions of a table have a measured SC and AC.
[[nodiscard]] std::size_t MeasuredPositionCount(const RhythmTable& table) noexcept;

}  // namespace girdle
