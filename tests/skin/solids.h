// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Surfaces that tests cut, bind and measure.
#pragma once

#include <glm/geometric.hpp>

#include "anatomy/triangle_mesh.h"
#include "skin/surface_nets.h"

namespace girdle {

/// A ball about the origin.
inline TriangleMesh Ball(double radius_m, double cell_m) {
  const double reach_m = radius_m + 3 * cell_m;
  return SurfaceNets([radius_m](const Vector3& p) { return glm::length(p) - radius_m; },
                     {{-reach_m, -reach_m, -reach_m}, {reach_m, reach_m, reach_m}}, cell_m);
}

}  // namespace girdle
