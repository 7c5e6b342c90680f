// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/mesh_file.h"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cmath>
#include <filesystem>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <utility>

#include "skin/gltf_nodes.h"
#include "text/input_error.h"
#include "text/number_text.h"
#include "text/small_letters.h"
#include "text/text_file.h"

namespace girdle {
namespace {

// Limits of the size of a skin [m], which may be that of an arm and its shoulder only.
constexpr double kSmallestBody_m = 0.2;
constexpr double kLargestBody_m = 4;
// A triangle of less height than this has no area [m].
constexpr double kNoHeight_m = 1e-9;

// Collects triangles up to the limits. Vertices at one place become one vertex.
class Collector {
 public:
  explicit Collector(const std::string& path) : path_(path) {}

  // Recursion is limited, because FlawOfGltfNodes limits the depth of nodes.
  void AppendNode(const aiScene& scene, const aiNode& node, const aiMatrix4x4& parent) {
    const aiMatrix4x4 transform = parent * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      AppendMesh(*scene.mMeshes[node.mMeshes[i]], transform);
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) {
      AppendNode(scene, *node.mChildren[i], transform);
    }
  }

  TriangleMesh mesh;

 private:
  void AppendMesh(const aiMesh& part, const aiMatrix4x4& transform) {
    // A mirroring transform turns faces inside out.
    const bool is_mirrored = transform.Determinant() < 0;
    for (unsigned i = 0; i < part.mNumFaces; ++i) {
      const aiFace& face = part.mFaces[i];
      if (face.mNumIndices != 3) continue;
      if (mesh.triangles.size() == kMostMeshTriangles) FailTooLarge(kMostMeshTriangles, "faces");
      Triangle triangle{};
      for (unsigned corner = 0; corner < 3; ++corner) {
        triangle[corner] = VertexAt(transform * part.mVertices[face.mIndices[corner]]);
      }
      if (is_mirrored) std::swap(triangle[1], triangle[2]);
      mesh.triangles.push_back(triangle);
    }
  }

  int VertexAt(const aiVector3D& place) {
    if (!std::isfinite(place.x) || !std::isfinite(place.y) || !std::isfinite(place.z)) {
      throw InputError(path_ + ": a vertex of face " + std::to_string(mesh.triangles.size()) +
                       " has a coordinate that is not a finite number. Correct or remove it");
    }
    const auto [known, is_new] =
        numbers_.try_emplace({place.x, place.y, place.z}, static_cast<int>(numbers_.size()));
    if (is_new) {
      if (mesh.vertices_m.size() == kMostMeshVertices) FailTooLarge(kMostMeshVertices, "vertices");
      mesh.vertices_m.emplace_back(place.x, place.y, place.z);
    }
    return known->second;
  }

  [[noreturn]] void FailTooLarge(std::size_t most, const std::string& kind) const {
    throw InputError(path_ + ": has more than " + std::to_string(most) + " " + kind +
                     ". Give one with fewer, such as a decimated one");
  }

  const std::string& path_;
  std::map<std::array<ai_real, 3>, int> numbers_;
};

std::string PlaceText(const Vector3& place_m) {
  return "(" + SignificantText(place_m.x, 4) + ", " + SignificantText(place_m.y, 4) + ", " +
         SignificantText(place_m.z, 4) + ")";
}

std::optional<std::string> FlawOfSize(const TriangleMesh& mesh) {
  Vector3 lowest = mesh.vertices_m.front();
  Vector3 highest = lowest;
  for (const Vector3& vertex : mesh.vertices_m) {
    lowest = glm::min(lowest, vertex);
    highest = glm::max(highest, vertex);
  }
  const Vector3 extent = highest - lowest;
  const double size_m = std::max({extent.x, extent.y, extent.z});
  if (size_m >= kSmallestBody_m && size_m <= kLargestBody_m) return std::nullopt;
  std::string fix = "Scale it to meters";
  for (const auto& [per_meter, unit] :
       {std::pair(1000, "millimeters"), std::pair(100, "centimeters"),
        std::pair(10, "decimeters")}) {
    const double scaled_m = size_m / per_meter;
    if (scaled_m >= 1 && scaled_m <= 2.5) {
      fix = std::string("It seems to be in ") + unit + ". " + fix;
      break;
    }
  }
  return "measures " + SignificantText(size_m, 3) + " m, which no person does. " + fix;
}

std::optional<std::string> FlawOfFaces(const TriangleMesh& mesh) {
  const auto at = [&mesh](int vertex) { return mesh.vertices_m[static_cast<std::size_t>(vertex)]; };
  std::map<std::pair<int, int>, std::size_t> faces;  // to the left of an edge
  double volume_m3 = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle& triangle = mesh.triangles[i];
    const Vector3 a = at(triangle[0]);
    const Vector3 b = at(triangle[1]);
    const Vector3 c = at(triangle[2]);
    const double longest_m = std::max({glm::length(b - a), glm::length(c - b), glm::length(a - c)});
    if (!(glm::length(glm::cross(b - a, c - a)) > kNoHeight_m * longest_m)) {
      return "face " + std::to_string(i) + " at " + PlaceText(a) +
             " has no area. Merge its corners, or dissolve it";
    }
    volume_m3 += glm::dot(a, glm::cross(b, c)) / 6;
    for (std::size_t corner = 0; corner < triangle.size(); ++corner) {
      const std::pair edge(triangle[corner], triangle[(corner + 1) % triangle.size()]);
      const auto [other, is_first] = faces.try_emplace(edge, i);
      if (!is_first) {
        return "faces " + std::to_string(other->second) + " and " + std::to_string(i) + " at " +
               PlaceText(at(edge.first)) +
               " do not look the same way, or more than two meet at an edge. Recalculate normals, "
               "so that all faces look outside, and remove faces inside";
      }
    }
  }
  for (const auto& [edge, face] : faces) {
    if (faces.count({edge.second, edge.first}) == 0) {
      return "is open: face " + std::to_string(face) + " at " + PlaceText(at(edge.first)) +
             " has no neighbour. Fill the holes, at waist and neck as well";
    }
  }
  if (volume_m3 < 0) return "is inside out. Flip its normals, so that all faces look outside";
  return std::nullopt;
}

// Whether a path ends in a suffix of glTF, in letters of either case, as Assimp accepts.
bool HasGltfSuffix(const std::string& path) {
  const std::string suffix = InSmallLetters(std::filesystem::path(path).extension().string());
  return suffix == ".glb" || suffix == ".gltf";
}

[[noreturn]] void FailReading(const std::string& path, const std::string& reason) {
  throw InputError(path + ": cannot be read as a mesh: " + reason +
                   ". Export it again as .glb or .obj");
}

}  // namespace

TriangleMesh ReadMeshFile(const std::string& path) {
  // Called for its messages: Assimp's message about a missing file is less clear.
  static_cast<void>(OpenTextFile(path));
  if (HasGltfSuffix(path)) {
    if (const std::optional<std::string> flaw = FlawOfGltfNodes(path)) FailReading(path, *flaw);
  }
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(path, aiProcess_Triangulate);
  if (scene == nullptr || scene->mRootNode == nullptr) {
    std::string reason = importer.GetErrorString();
    reason.erase(reason.find_last_not_of(". \n") + 1);
    FailReading(path, reason + ", the file may be cut short");
  }
  Collector collector(path);
  collector.AppendNode(*scene, *scene->mRootNode, aiMatrix4x4());
  if (collector.mesh.triangles.empty()) {
    throw InputError(path + ": has no triangles. Export the body's faces");
  }
  return std::move(collector.mesh);
}

std::optional<std::string> FlawOfSkin(const TriangleMesh& mesh) {
  // The size is checked first, because the rest may be right if the body is in millimetres.
  const std::optional<std::string> flaw = FlawOfSize(mesh);
  return flaw ? flaw : FlawOfFaces(mesh);
}

}  // namespace girdle
