// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// A surface of triangles where a function of the place changes its sign.
#pragma once

#include <functional>
#include <limits>

#include "anatomy/triangle_mesh.h"

namespace girdle {

/// Of what is looked at; the surface must lie within. Metres.
struct Box {
  Vector3 lowest_m{0, 0, 0};
  Vector3 highest_m{0, 0, 0};
};

/// Returns the surface value(p) = 0 by naive surface nets (Gibson 1998): one vertex in every cubic
/// cell that the surface crosses, at the mean of the crossings of the cell's edges, then drawn to
/// the surface; one quadrilateral, cut along its shorter diagonal, across every edge of the grid
/// whose ends differ in sign. Triangles run counter-clockwise seen from where the value is
/// positive, and every edge inside the box is shared by exactly two: where the surface would touch
/// itself along one, a gap narrower than a cell is closed. No slivers as in marching cubes. Only
/// the part of the surface within the box is found, up to one cell from its faces. Throws
/// std::invalid_argument for a cell size or a box that make no grid, or one of more than 50 million
/// points.
///
/// `steepest` bounds how fast the value changes: where it is v, the surface is at least
/// |v| / steepest away. With a bound, blocks of the grid that the surface cannot reach are asked
/// for one value each. The mesh stays the same, and takes a fraction of the time.
[[nodiscard]] TriangleMesh SurfaceNets(const std::function<double(const Vector3&)>& value_m,
                                       const Box& box, double cell_m,
                                       double steepest = std::numeric_limits<double>::infinity());

}  // namespace girdle
