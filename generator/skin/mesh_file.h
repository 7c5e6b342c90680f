// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Reads meshes of users, and finds the reason why a mesh cannot be a skin.
#pragma once

#include <optional>
#include <string>

#include "anatomy/triangle_mesh.h"

namespace girdle {

/// The largest mesh that is accepted. The bones' shares in it take some seconds to compute. A
/// closed surface has about twice as many triangles as vertices.
inline constexpr std::size_t kMostMeshVertices = 200'000;
inline constexpr std::size_t kMostMeshTriangles = 2 * kMostMeshVertices;

/// Reads the triangles of a glTF (`.glb`, `.gltf`) or Wavefront (`.obj`) file, in the file's own
/// frame. The transforms of nodes are applied; a rig is not. Faces with more corners are split into
/// triangles. Vertices at the same place become one, ordered by their first use in a triangle.
/// Materials, lines and points are ignored. Throws InputError if the file cannot be read, if it has
/// no triangles, if a coordinate is not finite, or if it has more than kMostMeshVertices or
/// kMostMeshTriangles. It stops at the first one too many; a part that is used several times counts
/// each time.
///
/// The file and those that it names must be regular files. They are read in a child process with
/// little memory and time (child_process.h), because the library that reads them crashes on some
/// damaged files. Call this only while this process has one thread.
[[nodiscard]] TriangleMesh ReadMeshFile(const std::string& path);

/// Returns the reason why a mesh in metres cannot be the skin of a person, with the fix, or nothing
/// if it can. Reasons are: a face without area, a flipped face, an edge with a face on one side
/// only, all faces inside out, a size that no person has. Faces and vertices are counted from 0.
[[nodiscard]] std::optional<std::string> FlawOfSkin(const TriangleMesh& mesh);

}  // namespace girdle
