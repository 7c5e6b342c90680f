// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Meshes that people bring: reading them, and what keeps one from being a skin.
#pragma once

#include <optional>
#include <string>

#include "anatomy/triangle_mesh.h"

namespace girdle {

/// The largest mesh that is taken: to find the shares of bones in it takes some seconds. A closed
/// surface has about twice as many triangles as vertices.
inline constexpr std::size_t kMostMeshVertices = 200'000;
inline constexpr std::size_t kMostMeshTriangles = 2 * kMostMeshVertices;

/// Reads the triangles of a glTF (`.glb`, `.gltf`) or Wavefront (`.obj`) file, in its own frame,
/// with the transforms of its nodes applied, as it stands without its own rig. Faces of more
/// corners are cut into triangles; vertices at the same place become one, in the order in which
/// they first stand in a triangle; materials, lines and points are passed over. Throws InputError
/// for a file that cannot be read, one without triangles, one with a vertex that is nowhere (not of
/// finite numbers), and one of more than kMostMeshVertices or kMostMeshTriangles, at the first that
/// is too many: parts that are used many times count as often.
[[nodiscard]] TriangleMesh ReadMeshFile(const std::string& path);

/// Returns what keeps a mesh in metres from being the skin of a person, with the fix: a face
/// without an area, one that is flipped, an edge with a face on one side only, all faces inside
/// out, the size of nobody. Nothing if it can be one. Faces and vertices are counted from 0.
[[nodiscard]] std::optional<std::string> FlawOfSkin(const TriangleMesh& mesh);

}  // namespace girdle
