// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Looks for flaws of a mesh that has been read: the input is its coordinates and its corners.

#include "input_values.h"
#include "reading.h"
#include "skin/mesh_file.h"

namespace girdle::fuzz {
namespace {

TriangleMesh MeshOf(InputValues values) {
  constexpr std::size_t kMostVertices = 50;
  constexpr std::size_t kMostTriangles = 100;
  TriangleMesh mesh;
  const std::size_t vertices = 1 + values.TakeBelow(kMostVertices);
  const std::size_t triangles = 1 + values.TakeBelow(kMostTriangles);
  for (std::size_t i = 0; i < vertices; ++i) {
    const float x = values.TakeFloat();
    const float y = values.TakeFloat();
    const float z = values.TakeFloat();
    mesh.vertices_m.emplace_back(x, y, z);
  }
  for (std::size_t i = 0; i < triangles; ++i) {
    for (int& corner : mesh.triangles.emplace_back()) {
      corner = static_cast<int>(values.TakeBelow(vertices));
    }
  }
  return mesh;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string text = BytesOf(bytes, size);
  const std::optional<std::string> flaw = FlawOfSkin(MeshOf(InputValues(text)));
  Expect(!flaw || (!flaw->empty() && flaw->size() <= kLongestMessage), "a flaw is short");
  return 0;
}

}  // namespace girdle::fuzz
