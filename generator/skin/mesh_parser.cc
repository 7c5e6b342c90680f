// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/mesh_parser.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <array>
#include <assimp/Importer.hpp>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <new>
#include <optional>
#include <system_error>
#include <utility>

#include "skin/gltf_nodes.h"
#include "skin/mesh_file.h"
#include "text/input_error.h"
#include "text/small_letters.h"
#include "text/text_file.h"

namespace girdle {
namespace {

// Largest mesh file, and largest file that it names [bytes].
constexpr std::uintmax_t kMostFileSize = 100'000'000;
// Most corners of a face. The time to cut a face into triangles grows with their square.
constexpr unsigned kMostCorners = 2000;

// Returns the reason why a file is not opened, or nothing. A file that is not there has none.
std::optional<std::string> FlawOfPlace(const std::string& path) {
  std::error_code unclear;
  const std::filesystem::file_status status = std::filesystem::status(path, unclear);
  if (!std::filesystem::exists(status)) return std::nullopt;
  if (!std::filesystem::is_regular_file(status)) return "is not a regular file";
  const std::uintmax_t size = std::filesystem::file_size(path, unclear);
  if (unclear || size <= kMostFileSize) return std::nullopt;
  return "has " + std::to_string(size) + " bytes, more than " + std::to_string(kMostFileSize);
}

// Finds and opens what a mesh file names if FlawOfPlace finds no flaw: a pipe, for one, would never
// end. Assimp opens a file to see whether it exists.
class CheckedFiles : public Assimp::DefaultIOSystem {
 public:
  // `flaw` is set to the first flaw of a file.
  CheckedFiles(std::filesystem::path folder, std::optional<std::string>& flaw)
      : folder_(std::move(folder)), flaw_(flaw) {}

  bool Exists(const char* file) const override {
    return IsFit(file) && DefaultIOSystem::Exists(file);
  }
  Assimp::IOStream* Open(const char* file, const char* mode) override {
    return IsFit(file) ? DefaultIOSystem::Open(file, mode) : nullptr;
  }

 private:
  bool IsFit(const char* file) const {
    const std::optional<std::string> flaw = FlawOfPlace(file);
    if (flaw && !flaw_) {
      flaw_ = "it names " + std::filesystem::path(file).lexically_proximate(folder_).string() +
              ", which " + *flaw;
    }
    return !flaw;
  }

  std::filesystem::path folder_;
  std::optional<std::string>& flaw_;
};

// Collects triangles up to the limits. Vertices at one place become one vertex.
class Collector {
 public:
  explicit Collector(const std::string& name) : name_(name) {}

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
      throw InputError(name_ + ": a vertex of face " + std::to_string(mesh.triangles.size()) +
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
    throw InputError(name_ + ": has more than " + std::to_string(most) + " " + kind +
                     ". Give one with fewer, such as a decimated one");
  }

  const std::string& name_;
  std::map<std::array<ai_real, 3>, int> numbers_;
};

// Whether a path ends in a suffix of glTF, in letters of either case, as Assimp accepts.
bool HasGltfSuffix(const std::string& path) {
  const std::string suffix = InSmallLetters(std::filesystem::path(path).extension().string());
  return suffix == ".glb" || suffix == ".gltf";
}

void ExpectFewCorners(const aiScene& scene, const std::string& name) {
  for (unsigned mesh = 0; mesh < scene.mNumMeshes; ++mesh) {
    const aiMesh& part = *scene.mMeshes[mesh];
    for (unsigned i = 0; i < part.mNumFaces; ++i) {
      if (part.mFaces[i].mNumIndices > kMostCorners) {
        throw InputError(name + ": a face has " + std::to_string(part.mFaces[i].mNumIndices) +
                         " corners, more than " + std::to_string(kMostCorners) +
                         ". Cut it into triangles");
      }
    }
  }
}

}  // namespace

void FailReadingMesh(const std::string& name, const std::string& reason) {
  throw InputError(name + ": cannot be read as a mesh: " + reason +
                   ". Export it again as .glb or .obj");
}

void ExpectMeshFile(const std::string& path) {
  if (!std::filesystem::is_directory(path)) {
    if (const std::optional<std::string> flaw = FlawOfPlace(path))
      FailReadingMesh(path, "it " + *flaw);
  }
  // Called for its messages: Assimp's message about a missing file is less clear.
  static_cast<void>(OpenTextFile(path));
}

TriangleMesh ParseMesh(const std::string& path, const std::string& name) {
  if (HasGltfSuffix(path)) {
    if (const std::optional<std::string> flaw = FlawOfGltfNodes(path)) FailReadingMesh(name, *flaw);
  }
  std::optional<std::string> flaw;
  Assimp::Importer importer;
  importer.SetIOHandler(new CheckedFiles(std::filesystem::path(path).parent_path(), flaw));
  const aiScene* scene = importer.ReadFile(path, 0);
  if (flaw) FailReadingMesh(name, *flaw);
  if (scene != nullptr) {
    ExpectFewCorners(*scene, name);
    scene = importer.ApplyPostProcessing(aiProcess_Triangulate);
  }
  if (scene == nullptr || scene->mRootNode == nullptr) {
    std::string reason = importer.GetErrorString();
    if (reason.find("bad_alloc") != std::string::npos) throw std::bad_alloc();
    reason.erase(reason.find_last_not_of(". \n") + 1);
    FailReadingMesh(name, reason + ", the file may be cut short");
  }
  Collector collector(name);
  collector.AppendNode(*scene, *scene->mRootNode, aiMatrix4x4());
  if (collector.mesh.triangles.empty()) {
    throw InputError(name + ": has no triangles. Export the body's faces");
  }
  return std::move(collector.mesh);
}

}  // namespace girdle
