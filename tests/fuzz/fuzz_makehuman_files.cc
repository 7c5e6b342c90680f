// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

// Reads the files of MakeHuman's bodies.

#include <sstream>

#include "reading.h"
#include "skin/fitted_body.h"
#include "skin/makehuman_files.h"

namespace girdle::fuzz {
namespace {

// Vertices of the mesh that shapes and weights are for.
constexpr std::size_t kVertices = 8;

void ExpectCorners(const MakeHumanMesh& mesh) {
  for (const auto& [name, faces] : mesh.groups) {
    for (const Quad& face : faces) {
      for (const int corner : face) {
        Expect(corner >= 0 && static_cast<std::size_t>(corner) < mesh.vertices_dm.size(),
               "a corner is a vertex");
      }
    }
  }
}

void ExpectShares(const MakeHumanWeights& weights) {
  for (const auto& [bone, shares] : weights) {
    for (const auto& [vertex, share] : shares) {
      Expect(
          vertex >= 0 && static_cast<std::size_t>(vertex) < kVertices && share >= 0 && share <= 1,
          "a share is one of a vertex");
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string text = TextOf(bytes, size);
  std::istringstream mesh_in(text);
  if (const auto mesh = ResultOf([&] { return ReadMakeHumanMesh(mesh_in, kName); })) {
    ExpectCorners(*mesh);
  }
  std::istringstream target_in(text);
  std::vector<Vector3> vertices_dm(kVertices);
  static_cast<void>(ResultOf([&] {
    AddMakeHumanTarget(target_in, kName, 1, vertices_dm);
    return true;
  }));
  std::istringstream weights_in(text);
  if (const auto weights =
          ResultOf([&] { return ReadMakeHumanWeights(weights_in, kName, kVertices); })) {
    ExpectShares(*weights);
  }
  std::istringstream fit_in(text);
  static_cast<void>(ResultOf([&] { return ReadMakeHumanFit(fit_in, kName); }));
  return 0;
}

}  // namespace girdle::fuzz
