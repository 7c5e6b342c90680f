// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Parses meshes in this process. A hostile file may crash it, hang it or take all its memory:
/// mesh_file.h parses in a process of its own.
#pragma once

#include <string>

#include "anatomy/triangle_mesh.h"

namespace girdle {

/// Throws InputError unless `path` is a regular file that can be opened and has at most 100 MB.
void ExpectMeshFile(const std::string& path);

/// Parses the file at `path` as ReadMeshFile says. Messages call it `name`. Files that it names are
/// opened if they are regular files of at most 100 MB. Throws InputError for faults of the file,
/// and std::bad_alloc if there is not enough memory.
[[nodiscard]] TriangleMesh ParseMesh(const std::string& path, const std::string& name);

/// Throws InputError that the mesh `name` cannot be read for this reason, with the fix.
[[noreturn]] void FailReadingMesh(const std::string& name, const std::string& reason);

}  // namespace girdle
