// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// A surface of triangles.
#pragma once

#include <array>
#include <vector>

#include "kinematics/rotation.h"

namespace girdle {

/// Indices of a triangle's corners, from 0, counter-clockwise seen from outside.
using Triangle = std::array<int, 3>;

/// A mesh of triangles. Vertices are in metres; whoever makes the mesh defines their frame.
struct TriangleMesh {
  std::vector<Vector3> vertices_m;
  std::vector<Triangle> triangles;
};

}  // namespace girdle
