// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "mjcf/model_sections.h"

#include <array>
#include <string>
#include <utility>

#include "anatomy/triangle_mesh.h"
#include "kinematics/lengths.h"
#include "mjcf/bone_meshes.h"
#include "text/number_text.h"

namespace girdle {
namespace {

constexpr double kLandmarkRadius_m = 0.004;
constexpr double kLigamentRadius_m = 0.002;

TriangleMesh MeshOnSide(Side side, TriangleMesh mesh) {
  if (side == Side::kLeft) {
    for (Vector3& vertex : mesh.vertices_m) {
      vertex = Mirrored(vertex);
    }
    for (std::array<int, 3>& triangle : mesh.triangles) {
      std::swap(triangle[1], triangle[2]);
    }
  }
  return mesh;
}

void WriteMesh(XmlElement asset, const std::string& name, const TriangleMesh& mesh) {
  std::string vertices;
  for (const Vector3& vertex : mesh.vertices_m) {
    for (const double coordinate : {vertex.x, vertex.y, vertex.z}) {
      vertices += (vertices.empty() ? "" : " ") + RoundedText(coordinate, kLengthDecimals);
    }
  }
  std::string faces;
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    for (const int vertex : triangle) {
      faces += (faces.empty() ? "" : " ") + std::to_string(vertex);
    }
  }
  asset.Add("mesh").Set("name", name).Set("vertex", vertices).Set("face", faces);
}

}  // namespace

void WriteDefaults(const ModelPlan& /*plan*/, XmlElement root) {
  XmlElement girdle = root.Add("default").Add("default").Set("class", "girdle");
  // Bones are drawn; they neither collide nor weigh.
  girdle.Add("geom")
      .Set("contype", 0)
      .Set("conaffinity", 0)
      .Set("group", 1)
      .Set("mass", 0)
      .Set("material", "bone");
  girdle.Add("site")
      .Set("size", kLandmarkRadius_m)
      .Set("group", 3)
      .Set("rgba", std::array{0.85, 0.25, 0.1, 1.0});
  girdle.Add("tendon")
      .Set("width", kLigamentRadius_m)
      .Set("group", 2)
      .Set("rgba", std::array{0.93, 0.93, 0.88, 1.0});
}

void WriteAssets(const ModelPlan& plan, XmlElement root) {
  XmlElement asset = root.Add("asset");
  asset.Add("material").Set("name", "bone").Set("rgba", std::array{0.89, 0.85, 0.76, 1.0});
  asset.Add("material").Set("name", "rib").Set("rgba", std::array{0.75, 0.77, 0.8, 1.0});
  WriteMesh(asset, "ribcage", RibcageMesh(plan.anatomy));
  for (const Side side : plan.sides) {
    WriteMesh(asset, SidedName("clavicle", side), MeshOnSide(side, ClavicleMesh(plan.anatomy)));
    WriteMesh(asset, SidedName("scapula", side), MeshOnSide(side, ScapulaMesh(plan.anatomy)));
    WriteMesh(asset, SidedName("humerus", side), MeshOnSide(side, HumerusMesh(plan.anatomy)));
  }
}

}  // namespace girdle
