// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Readers for the single files of the MakeHuman project's bodies.
///
/// Lengths in the files are decimetres. x points to the body's left, y up, z to the front.
#pragma once

#include <array>
#include <istream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/rotation.h"

namespace girdle {

/// Indices of a face's corners, from 0, counter-clockwise seen from outside.
using Quad = std::array<int, 4>;

/// A mesh with its faces in named groups: the body, its eyes, and cubes for its joints.
struct MakeHumanMesh {
  std::vector<Vector3> vertices_dm;
  std::map<std::string, std::vector<Quad>> groups;
};

/// Shares of an artist's bones in vertices, by the names of the bones.
using MakeHumanWeights = std::map<std::string, std::vector<std::pair<int, double>>>;

/// Reads a mesh of the project (`.obj`): `v`, `f` with four corners each, `g`. Texture and
/// smoothing (`vt`, `s`) are ignored. Throws InputError with file and line for any other line, for
/// an invalid number and for a corner without a vertex before it.
[[nodiscard]] MakeHumanMesh ReadMakeHumanMesh(std::istream& in, const std::string& name);

/// Moves vertices by `share` of a shape of the project (`.target`). Each line of the file has a
/// vertex and its displacement. Throws InputError with file and line for any other line and for a
/// vertex that does not exist.
void AddMakeHumanTarget(std::istream& in, const std::string& name, double share,
                        std::vector<Vector3>& vertices_dm);

/// Reads the weights of a rig of the project (`.json`). Throws InputError if the text is not such
/// JSON, if a share is not in [0, 1], or if a vertex is not below `vertex_count`.
[[nodiscard]] MakeHumanWeights ReadMakeHumanWeights(std::istream& in, const std::string& name,
                                                    std::size_t vertex_count);

}  // namespace girdle
