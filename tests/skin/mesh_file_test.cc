// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/mesh_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <utility>

#include "skin/solids.h"
#include "text/csv_text.h"
#include "text/input_error.h"

namespace girdle::mesh_file_test {
namespace {

// A file that is gone when the test is over.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& name, const std::string& text)
      : path_(testing::TempDir() + "/girdle_" + name) {
    std::ofstream(path_) << text;
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() { std::filesystem::remove(path_); }

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

std::string RefusalOf(const std::string& path) {
  return MessageOf<InputError>([&] { static_cast<void>(ReadMeshFile(path)); });
}

constexpr const char* kTetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";

TEST(ReadMeshFile, GivesVerticesInTheOrderOfTheTriangles) {
  const TemporaryFile file("tetrahedron.obj", kTetrahedron);
  const TriangleMesh mesh = ReadMeshFile(file.path());
  EXPECT_EQ(mesh.vertices_m, (std::vector<Vector3>{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}}));
  EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}, {2, 1, 3}, {0, 3, 1}}));
}

TEST(ReadMeshFile, JoinsVerticesAtTheSamePlace) {
  const TemporaryFile file("seam.obj",
                           "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                           "f 1 2 3\nf 4 5 6\n");
  EXPECT_EQ(ReadMeshFile(file.path()).vertices_m.size(), 4U);
}

TEST(ReadMeshFile, CutsFacesOfMoreCorners) {
  const TemporaryFile file("quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
  EXPECT_EQ(ReadMeshFile(file.path()).triangles.size(), 2U);
}

TEST(ReadMeshFile, RefusesAFileThatIsNotThere) {
  EXPECT_NE(RefusalOf("nowhere.obj").find("nowhere.obj: cannot be opened"), std::string::npos);
}

TEST(ReadMeshFile, RefusesAFileThatIsNoMesh) {
  const TemporaryFile file("letter.glb", "Dear all,\n");
  EXPECT_NE(RefusalOf(file.path()).find("letter.glb: cannot be read as a mesh"), std::string::npos);
}

TEST(ReadMeshFile, SaysThatAFileMayBeCutShort) {
  const TemporaryFile file("half.glb", "glTF");
  EXPECT_EQ(RefusalOf(file.path()),
            file.path() +
                ": cannot be read as a mesh: it is no glTF of version 2, or is cut short. Export "
                "it again as .glb or .obj");
}

TEST(ReadMeshFile, ReadsAGltfFileInText) {
  const TemporaryFile file("triangle.gltf",
                           R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
          "nodes": [{"children": [1]}, {"mesh": 0}],
          "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
          "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                         "min": [0, 0, 0], "max": [1, 1, 0]}],
          "bufferViews": [{"buffer": 0, "byteLength": 36}],
          "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,)"
                           R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})");
  EXPECT_EQ(ReadMeshFile(file.path()).vertices_m,
            (std::vector<Vector3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
}

TEST(ReadMeshFile, RefusesAVertexThatIsNowhere) {
  const TemporaryFile file("nowhere.obj", "v 0 0 0\nv 1 0 0\nv 0 nan 0\nf 1 2 3\n");
  EXPECT_EQ(RefusalOf(file.path()),
            file.path() +
                ": a vertex of face 0 has a coordinate that is not a finite number. "
                "Correct or remove it");
}

TEST(ReadMeshFile, RefusesAFileWithoutTriangles) {
  const TemporaryFile file("line.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n");
  EXPECT_NE(RefusalOf(file.path()).find("has no triangles"), std::string::npos);
}

TEST(FlawOfSkin, IsNoneOfAClosedSurfaceOfABodysSize) {
  EXPECT_EQ(FlawOfSkin(Ball(0.3, 0.05)), std::nullopt);
}

// One change of that surface, and what has to be said about it.
struct SkinFlaw {
  const char* name;
  std::function<void(TriangleMesh&)> change;
  const char* message;
};
void PrintTo(const SkinFlaw& flaw, std::ostream* out) { *out << flaw.name; }

class FlawedSkin : public testing::TestWithParam<SkinFlaw> {};

TEST_P(FlawedSkin, IsSaidToBeSo) {
  TriangleMesh mesh = Ball(0.3, 0.05);
  GetParam().change(mesh);
  const std::optional<std::string> flaw = FlawOfSkin(mesh);
  ASSERT_TRUE(flaw);
  EXPECT_NE(flaw->find(GetParam().message), std::string::npos) << *flaw;
}

INSTANTIATE_TEST_SUITE_P(
    Skins, FlawedSkin,
    testing::Values(
        SkinFlaw{"open", [](TriangleMesh& m) { m.triangles.erase(m.triangles.begin() + 7); },
                 "is open: face"},
        SkinFlaw{"flipped",
                 [](TriangleMesh& m) { std::swap(m.triangles[7][0], m.triangles[7][1]); },
                 "do not look the same way"},
        SkinFlaw{"without an area",
                 [](TriangleMesh& m) {
                   m.vertices_m[static_cast<std::size_t>(m.triangles[7][0])] =
                       m.vertices_m[static_cast<std::size_t>(m.triangles[7][1])];
                 },
                 "has no area. Merge its corners"},
        SkinFlaw{"inside out",
                 [](TriangleMesh& m) {
                   for (Triangle& triangle : m.triangles) std::swap(triangle[0], triangle[1]);
                 },
                 "is inside out. Flip its normals"},
        SkinFlaw{"in millimetres",
                 [](TriangleMesh& m) {
                   for (Vector3& vertex : m.vertices_m) vertex *= 3000;
                 },
                 "It seems to be in millimeters. Scale it to meters"},
        SkinFlaw{"in centimetres",
                 [](TriangleMesh& m) {
                   for (Vector3& vertex : m.vertices_m) vertex *= 300;
                 },
                 "It seems to be in centimeters. Scale it to meters"},
        SkinFlaw{"of a mouse",
                 [](TriangleMesh& m) {
                   for (Vector3& vertex : m.vertices_m) vertex *= 0.1;
                 },
                 "measures 0.0596 m, which no person does"}),
    [](const auto& tested) {
      std::string name = tested.param.name;
      std::replace(name.begin(), name.end(), ' ', '_');
      return name;
    });

}  // namespace
}  // namespace girdle::mesh_file_test
