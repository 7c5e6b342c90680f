// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Reads a mesh of the user's: OBJ, or glTF as text or in binary form.

#include <cmath>

#include "children.h"
#include "input_file.h"
#include "reading.h"
#include "skin/mesh_file.h"

namespace girdle::fuzz {
namespace {

const InputFile& FileFor(const std::string& bytes) {
  static const InputFile kObj(".obj");
  static const InputFile kGlb(".glb");
  static const InputFile kGltf(".gltf");
  if (bytes.starts_with("glTF")) {
    return kGlb;
  }
  return bytes.starts_with("{") ? kGltf : kObj;
}

void ExpectWhole(const TriangleMesh& mesh) {
  for (const Vector3& vertex : mesh.vertices_m) {
    Expect(std::isfinite(vertex.x) && std::isfinite(vertex.y) && std::isfinite(vertex.z),
           "a mesh has finite coordinates");
  }
  for (const Triangle& triangle : mesh.triangles) {
    for (const int corner : triangle) {
      Expect(corner >= 0 && static_cast<std::size_t>(corner) < mesh.vertices_m.size(),
             "a corner is a vertex");
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* /*count*/, char*** /*words*/) {
  LetChildrenCrash();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string text = BytesOf(bytes, size);
  const std::string& path = FileFor(text).With(text);
  if (const auto mesh = ResultOf([&] { return ReadMeshFile(path); })) {
    ExpectWhole(*mesh);
    static_cast<void>(FlawOfSkin(*mesh));
  }
  return 0;
}

}  // namespace girdle::fuzz
