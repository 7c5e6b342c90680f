// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/makehuman_files.h"

#include <gtest/gtest.h>

#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "text/csv_text.h"
#include "text/input_error.h"
#include "text/shown_text.h"

namespace girdle::makehuman_files_test {
namespace {

constexpr const char* kMesh =
    "# a mesh\n"
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.5\n"
    "vt 0 0\n"
    "g body\ns off\n"
    "f 1/1 2/1 3/1 4/1\n"
    "g joint-l-eye\n"
    "f 4 3 2 1\n";

MakeHumanMesh ReadMesh(const std::string& text) {
  std::istringstream in(text);
  return ReadMakeHumanMesh(in, "m.obj");
}

void AddTarget(const std::string& text, std::vector<Vector3>& vertices_dm) {
  std::istringstream in(text);
  AddMakeHumanTarget(in, "m.target", 0.5, vertices_dm);
}

MakeHumanWeights ReadWeights(const std::string& text) {
  std::istringstream in(text);
  return ReadMakeHumanWeights(in, "w.json", 4);
}

TEST(ReadMakeHumanMesh, ReadsVerticesAndTheFacesOfGroups) {
  const MakeHumanMesh mesh = ReadMesh(kMesh);
  EXPECT_EQ(mesh.vertices_dm, (std::vector<Vector3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.5}}));
  ASSERT_EQ(mesh.groups.size(), 2U);
  EXPECT_EQ(mesh.groups.at("body"), (std::vector<Quad>{{0, 1, 2, 3}}));
  EXPECT_EQ(mesh.groups.at("joint-l-eye"), (std::vector<Quad>{{3, 2, 1, 0}}));
}

TEST(ReadMakeHumanMesh, GoesOnWithAGroupThatIsNamedAgain) {
  EXPECT_EQ(ReadMesh(std::string(kMesh) + "g body\nf 1 2 3 4\n").groups.at("body").size(), 2U);
}

// A line more at the end of a valid file, and what has to be said about it.
struct MeshFlaw {
  const char* line;
  const char* message;
};
void PrintTo(const MeshFlaw& flaw, std::ostream* out) { *out << flaw.line; }

class FlawedMesh : public testing::TestWithParam<MeshFlaw> {};

TEST_P(FlawedMesh, IsRefusedWithItsLine) {
  const std::string text = std::string(kMesh) + GetParam().line + "\n";
  EXPECT_EQ(MessageOf<InputError>([&] { static_cast<void>(ReadMesh(text)); }),
            std::string("m.obj:12: ") + GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Lines, FlawedMesh,
    testing::Values(MeshFlaw{"v 1 2", "expected 'v x y z'"},
                    MeshFlaw{"v 1 2 x", "'x' is not a finite number"},
                    MeshFlaw{"v 1 2 nan", "'nan' is not a finite number"},
                    MeshFlaw{"f 1 2 3", "expected a face of four corners, 'f 1/1 2/2 3/3 4/4'"},
                    MeshFlaw{"f 1 2 3 5", "'5' is none of the 4 vertices"},
                    MeshFlaw{"f 0 2 3 4", "'0' is none of the 4 vertices"},
                    MeshFlaw{"f 1 2 3 4.5", "'4.5' is none of the 4 vertices"},
                    MeshFlaw{"vn 1 0 0", "'vn' is not known, expected v, vt, f, g or s"}));

TEST(ReadMakeHumanMesh, RefusesAFaceInNoGroup) {
  EXPECT_EQ(MessageOf<InputError>([] { static_cast<void>(ReadMesh("v 0 0 0\nf 1 1 1 1\n")); }),
            "m.obj:2: a face that is in no group. Begin one above, 'g body'");
}

TEST(AddMakeHumanTarget, MovesVerticesByItsShare) {
  std::vector<Vector3> vertices_dm = {{0, 0, 0}, {1, 1, 1}};
  AddTarget("# a target\n1 .5 -1 2\n", vertices_dm);
  EXPECT_EQ(vertices_dm, (std::vector<Vector3>{{0, 0, 0}, {1.25, 0.5, 2}}));
}

TEST(AddMakeHumanTarget, RefusesAVertexThatIsNotThere) {
  std::vector<Vector3> vertices_dm = {{0, 0, 0}, {1, 1, 1}};
  EXPECT_EQ(MessageOf<InputError>([&] { AddTarget("1 0 0 0\n2 0 0 0\n", vertices_dm); }),
            "m.target:2: '2' is none of the 2 vertices");
}

TEST(ReadMakeHumanMesh, ShowsTheBeginningOfALongWord) {
  const std::string word(5000, 'w');
  EXPECT_EQ(MessageOf<InputError>([&] { static_cast<void>(ReadMesh(word)); }),
            "m.obj:1: '" + ShortText(word) + "' is not known, expected v, vt, f, g or s");
}

TEST(AddMakeHumanTarget, RefusesALineThatIsNoDisplacement) {
  std::vector<Vector3> vertices_dm = {{0, 0, 0}};
  EXPECT_EQ(MessageOf<InputError>([&] { AddTarget("0 0 0\n", vertices_dm); }),
            "m.target:1: expected a vertex and how far it moves, '0 x y z'");
}

TEST(ReadMakeHumanWeights, ReadsTheSharesOfBones) {
  const MakeHumanWeights weights =
      ReadWeights(R"({"version": 1, "weights": {"neck": [[0, 0.25], [3, 1]], "root": []}})");
  EXPECT_EQ(weights, (MakeHumanWeights{{"neck", {{0, 0.25}, {3, 1.0}}}}));
}

TEST(ReadMakeHumanWeights, RefusesAVertexThatIsNotThere) {
  EXPECT_EQ(MessageOf<InputError>(
                [] { static_cast<void>(ReadWeights(R"({"weights": {"neck": [[4, 1]]}})")); }),
            "w.json: bone 'neck' has vertex 4, which is none of the 4");
}

TEST(ReadMakeHumanWeights, RefusesAShareAboveOne) {
  EXPECT_EQ(MessageOf<InputError>(
                [] { static_cast<void>(ReadWeights(R"({"weights": {"neck": [[1, 1.5]]}})")); }),
            "w.json: bone 'neck' has a share of 1.5 in vertex 1, expected 0 to 1");
}

TEST(ReadMakeHumanWeights, RefusesAVertexThatIsNoWholeNumber) {
  for (const std::string vertex : {"1.5", "1e+300"}) {
    EXPECT_EQ(MessageOf<InputError>([&] {
                static_cast<void>(ReadWeights(R"({"weights": {"neck": [[)" + vertex + ", 1]]}}"));
              }),
              "w.json: bone 'neck' has vertex " + vertex + ", which is no whole number");
  }
}

TEST(ReadMakeHumanWeights, RefusesTextThatIsCutOff) {
  EXPECT_EQ(MessageOf<InputError>([] { static_cast<void>(ReadWeights(R"({"weights": {)")); }),
            "w.json: not the weights of a rig: no JSON at byte 14");
}

TEST(ReadMakeHumanWeights, SaysBrieflyWhatIsNoJson) {
  constexpr std::size_t kLong = 1'000'000;
  EXPECT_EQ(MessageOf<InputError>([] {
              static_cast<void>(ReadWeights("{\"weights\": \"" + std::string(kLong, 'a')));
            }),
            "w.json: not the weights of a rig: no JSON at byte 1000014");
  EXPECT_EQ(MessageOf<InputError>([] { static_cast<void>(ReadWeights(std::string(kLong, '9'))); }),
            "w.json: not the weights of a rig: a number is too large");
}

}  // namespace
}  // namespace girdle::makehuman_files_test
