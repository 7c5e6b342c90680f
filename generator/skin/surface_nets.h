// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// A surface of triangles where a function of position changes its sign.
#pragma once

#include <functional>
#include <limits>

#include "anatomy/triangle_mesh.h"

namespace girdle {

/// The box that is searched. The surface must lie within it. Metres.
struct Box {
  Vector3 lowest_m{0, 0, 0};
  Vector3 highest_m{0, 0, 0};
};

/// Returns the surface value(p) = 0 by naive surface nets (Gibson 1998). Every cubic cell that the
/// surface crosses has one vertex. It starts at the mean of the crossings of the cell's edges and
/// is then moved onto the surface. Every edge of the grid whose ends differ in sign has one
/// quadrilateral across it, split along its shorter diagonal. There are no slivers, as marching
/// cubes has them.
///
/// Triangles are counter-clockwise seen from where the value is positive. Every edge inside the box
/// is shared by exactly two triangles: where the surface would touch itself along an edge, a gap
/// narrower than a cell is closed. Only the part of the surface within the box is found, up to one
/// cell from its faces. Throws std::invalid_argument if cell size and box make no grid, or a grid
/// of more than 50 million points.
///
/// `steepest` is an upper bound of the function's slope: where the value is v, the surface is at
/// least |v| / steepest away. With a bound, a block of the grid that the surface cannot reach needs
/// one value only. The mesh is the same, and takes a fraction of the time.
[[nodiscard]] TriangleMesh SurfaceNets(const std::function<double(const Vector3&)>& value_m,
                                       const Box& box, double cell_m,
                                       double steepest = std::numeric_limits<double>::infinity());

}  // namespace girdle
