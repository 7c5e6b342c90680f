// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// GH, the centre of the humeral head, computed when it was not measured.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "kinematics/rotation.h"

namespace girdle {

/// Source of EstimatedGh_m: Meskers CGM, van der Helm FCT, Rozendaal LA, Rozing PM, J Biomech
/// 1998;31:93-96.
inline constexpr std::string_view kGhRegression = "Meskers et al. 1998";
/// Root mean square errors [m] of that regression on its own 36 cadaver scapulae: to the right, up
/// and forward. Palpation of landmarks through the skin adds its own errors.
inline constexpr std::array<double, 3> kGhRegressionError_m = {0.00232, 0.00269, 0.00304};

/// Returns GH [m] in the frame A of five landmarks of one scapula, right or left [m].
///
/// The regression uses millimetres and a frame with its origin in AC. x points along TS to AC, z is
/// perpendicular to the plane through AC, TS and AI and points backward, y points up. |a b| is the
/// distance of two landmarks:
///
///     x = 18.9743 + 0.2434 PC_x + 0.2341 AI_x + 0.1590 |AI AA| + 0.0558 PC_y
///     y = -3.8791 - 0.1002 |AC PC| + 0.1732 PC_y - 0.3940 |AC AA| + 0.1205 AI_x
///     z =  9.2629 - 0.2403 PC_y + 1.0255 PC_z + 0.1720 |TS PC|
///
/// A left scapula is the mirror image. A scapula is a left one if PC lies behind its plane in the
/// frame of a right one.
[[nodiscard]] Vector3 EstimatedGh_m(const Vector3& pc_m, const Vector3& ac_m, const Vector3& aa_m,
                                    const Vector3& ts_m, const Vector3& ai_m) noexcept;

/// A sphere fitted to points.
struct FittedSphere {
  Vector3 center_m{0, 0, 0};
  double radius_m = 0;
  double residual_m = 0;  ///< root mean square distance of the points from the surface
  /// Root mean square shift of the centre [m] if each point has an independent error of 1 m
  /// perpendicular to the surface. It tells how much errors of measuring are magnified.
  double magnification = 0;
};

/// Points determine no sphere if they are nearer to a plane than this share of their largest
/// distance.
inline constexpr double kNearlyInAPlane = 0.05;

/// Returns the distance [m] of the farthest point from the plane that fits all points best; 0 if
/// there are no points.
[[nodiscard]] double DistanceOffPlane_m(const std::vector<Vector3>& points_m);
/// Returns the largest distance [m] between two of the points.
[[nodiscard]] double LargestDistance_m(const std::vector<Vector3>& points_m) noexcept;

/// Returns the sphere with the least sum of squared distances between its surface and the points,
/// in the points' frame. Throws std::invalid_argument if there are fewer than four points or if
/// they lie nearly in a plane (kNearlyInAPlane).
[[nodiscard]] FittedSphere SphereThrough(const std::vector<Vector3>& points_m);

}  // namespace girdle
