// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The files that the MakeHuman project's bodies are made of, each by itself.
///
/// Lengths in them are decimetres; x points to the body's left, y up, z to the front.
#pragma once

#include <array>
#include <istream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/rotation.h"

namespace girdle {

/// Corners of a face, counted from 0; counter-clockwise seen from outside.
using Quad = std::array<int, 4>;

/// A mesh whose faces stand in named groups: the body, its eyes, and cubes where its joints are.
struct MakeHumanMesh {
  std::vector<Vector3> vertices_dm;
  std::map<std::string, std::vector<Quad>> groups;
};

/// Shares of an artist's bones in vertices, by the bones' names.
using MakeHumanWeights = std::map<std::string, std::vector<std::pair<int, double>>>;

/// Reads a mesh of the project (`.obj`): `v`, `f` of four corners each, `g`; texture and smoothing
/// (`vt`, `s`) are passed over. Throws InputError with file and line for anything else, for a
/// number that is none and for a corner that is no vertex above.
[[nodiscard]] MakeHumanMesh ReadMakeHumanMesh(std::istream& in, const std::string& name);

/// Moves vertices by `share` of what a shape of the project (`.target`) says: a vertex and its
/// displacement a line. Throws InputError with file and line for anything else and for a vertex
/// that is not there.
void AddMakeHumanTarget(std::istream& in, const std::string& name, double share,
                        std::vector<Vector3>& vertices_dm);

/// Reads the weights of a rig of the project (`.json`). Throws InputError for text that is no such
/// JSON, for a share that is not within 0 and 1 and for a vertex of `vertex_count` that is not
/// there.
[[nodiscard]] MakeHumanWeights ReadMakeHumanWeights(std::istream& in, const std::string& name,
                                                    std::size_t vertex_count);

}  // namespace girdle
