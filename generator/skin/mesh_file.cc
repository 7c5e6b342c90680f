// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/mesh_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <new>
#include <string_view>
#include <utility>
#include <vector>

#include "child_programs/child_process.h"
#include "skin/mesh_parser.h"
#include "text/input_error.h"
#include "text/number_text.h"

namespace girdle {
namespace {

// Limits of the size of a skin [m], which may be that of an arm and its shoulder only.
constexpr double kSmallestBody_m = 0.2;
constexpr double kLargestBody_m = 4;
// A triangle of less height than this has no area [m].
constexpr double kNoHeight_m = 1e-9;

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

// Kinds of the child's answer, its first byte.
constexpr char kMeshFollows = 'm';
constexpr char kErrorFollows = 'e';
constexpr char kNoMemory = 'n';

// Longest time to read the largest mesh [s], several times what it takes.
#ifdef __SANITIZE_ADDRESS__
constexpr int kLongestReading_s = 120;  // an address sanitizer reads more than ten times as long
#else
constexpr int kLongestReading_s = 10;
#endif
// Most memory of the process that reads. The largest mesh takes about half of it.
constexpr std::size_t kMostMemory = 300'000'000;

template <typename T>
void AppendBytes(const std::vector<T>& values, std::string& bytes) {
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

// Takes `count` values from the front of `bytes`, which has them.
template <typename T>
std::vector<T> TakeValues(std::size_t count, std::string_view& bytes) {
  std::vector<T> values(count);
  if (count > 0) {
    std::memcpy(values.data(), bytes.data(), count * sizeof(T));
    bytes.remove_prefix(count * sizeof(T));
  }
  return values;
}

// A mesh as the child writes it: the numbers of vertices and triangles, then both.
using MeshCounts = std::array<std::uint64_t, 2>;

std::string BytesOf(const TriangleMesh& mesh) {
  std::string bytes(1, kMeshFollows);
  AppendBytes(std::vector<std::uint64_t>{mesh.vertices_m.size(), mesh.triangles.size()}, bytes);
  AppendBytes(mesh.vertices_m, bytes);
  AppendBytes(mesh.triangles, bytes);
  return bytes;
}

// Returns the mesh of BytesOf without its first byte; nothing if the bytes are no mesh. The file
// may have made the child write anything.
std::optional<TriangleMesh> MeshFrom(std::string_view bytes) {
  MeshCounts counts{};
  if (bytes.size() < sizeof(counts)) return std::nullopt;
  std::memcpy(counts.data(), bytes.data(), sizeof(counts));
  bytes.remove_prefix(sizeof(counts));
  const auto [vertices, triangles] = counts;
  if (vertices > kMostMeshVertices || triangles > kMostMeshTriangles ||
      bytes.size() != vertices * sizeof(Vector3) + triangles * sizeof(Triangle)) {
    return std::nullopt;
  }
  TriangleMesh mesh{TakeValues<Vector3>(vertices, bytes), TakeValues<Triangle>(triangles, bytes)};
  const bool is_finite = std::ranges::all_of(mesh.vertices_m, [](const Vector3& p_m) {
    return std::isfinite(p_m.x) && std::isfinite(p_m.y) && std::isfinite(p_m.z);
  });
  const bool is_within = std::ranges::all_of(mesh.triangles, [&](const Triangle& triangle) {
    return std::ranges::all_of(triangle, [&](int vertex) {
      return vertex >= 0 && static_cast<std::size_t>(vertex) < mesh.vertices_m.size();
    });
  });
  return is_finite && is_within ? std::optional(std::move(mesh)) : std::nullopt;
}

// Returns the child's answer about a file. `place` is its whole path, because the child is in
// another folder.
std::string AnswerAbout(const std::string& place, const std::string& name) {
  try {
    return BytesOf(ParseMesh(place, name));
  } catch (const InputError& error) {
    return kErrorFollows + std::string(error.what());
  } catch (const std::bad_alloc&) {
    return {kNoMemory};
  }
}

}  // namespace

TriangleMesh ReadMeshFile(const std::string& path) {
  ExpectMeshFile(path);
  const std::string place = std::filesystem::absolute(path);
  constexpr std::size_t kMostOutput = 1 + sizeof(MeshCounts) + kMostMeshVertices * sizeof(Vector3) +
                                      kMostMeshTriangles * sizeof(Triangle);
  const ChildResult child = RunInChild(
      [&](const auto& write) { write(AnswerAbout(place, path)); },
      {.time_s = kLongestReading_s, .output_bytes = kMostOutput, .memory_bytes = kMostMemory});
  if (!child.failure.empty()) {
    FailReadingMesh(path, (child.is_late ? "it is too large or damaged: a process that read it "
                                         : "it is damaged: a process that read it ") +
                              child.failure);
  }
  const std::string_view answer = child.output;
  const char kind = answer.empty() ? kErrorFollows : answer.front();
  if (kind == kNoMemory) {
    FailReadingMesh(path,
                    "it is too large or damaged: reading it takes more than 300 MB of memory");
  }
  if (kind == kErrorFollows && answer.size() > 1) throw InputError(std::string(answer.substr(1)));
  std::optional<TriangleMesh> mesh =
      kind == kMeshFollows ? MeshFrom(answer.substr(1)) : std::nullopt;
  if (!mesh) FailReadingMesh(path, "it is damaged: a process that read it gave no mesh");
  return std::move(*mesh);
}

std::optional<std::string> FlawOfSkin(const TriangleMesh& mesh) {
  // The size is checked first, because the rest may be right if the body is in millimetres.
  const std::optional<std::string> flaw = FlawOfSize(mesh);
  return flaw ? flaw : FlawOfFaces(mesh);
}

}  // namespace girdle
