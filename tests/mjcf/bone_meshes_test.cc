// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "mjcf/bone_meshes.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <numeric>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "anatomy/body_size.h"
#include "anatomy/built_in_anatomy.h"
#include "kinematics/random_rotations.h"

namespace girdle::bone_meshes_test {
namespace {

struct Bone {
  const char* name;
  TriangleMesh (*draw)(const Anatomy&);
};

void PrintTo(const Bone& bone, std::ostream* out) { *out << bone.name; }

constexpr Bone kBones[] = {{"rib cage", RibcageMesh},
                           {"clavicle", ClavicleMesh},
                           {"scapula", ScapulaMesh},
                           {"humerus", HumerusMesh}};

double Area(const TriangleMesh& mesh, const std::array<int, 3>& triangle) {
  const Vector3& a = mesh.vertices_m.at(static_cast<std::size_t>(triangle[0]));
  const Vector3& b = mesh.vertices_m.at(static_cast<std::size_t>(triangle[1]));
  const Vector3& c = mesh.vertices_m.at(static_cast<std::size_t>(triangle[2]));
  return glm::length(glm::cross(b - a, c - a)) / 2;
}

// How often each edge is run through, from its first to its second vertex.
std::map<std::pair<int, int>, int> EdgeCounts(const TriangleMesh& mesh) {
  std::map<std::pair<int, int>, int> counts;
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++counts[{triangle[i], triangle[(i + 1) % 3]}];
  }
  return counts;
}

// Every edge is run through once in each direction: two triangles share it and turn alike.
bool IsClosed(const TriangleMesh& mesh) {
  const auto counts = EdgeCounts(mesh);
  return std::all_of(counts.begin(), counts.end(), [&](const auto& edge) {
    const auto reverse = counts.find({edge.first.second, edge.first.first});
    return edge.second == 1 && reverse != counts.end() && reverse->second == 1;
  });
}

// Volume of each piece: positive if its triangles run counter-clockwise seen from outside.
std::vector<double> PieceVolumes_m3(const TriangleMesh& mesh) {
  std::vector<int> root(mesh.vertices_m.size());
  std::iota(root.begin(), root.end(), 0);
  const auto piece = [&root](int vertex) {
    while (root[static_cast<std::size_t>(vertex)] != vertex) {
      vertex = root[static_cast<std::size_t>(vertex)];
    }
    return vertex;
  };
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    for (const int vertex : {triangle[1], triangle[2]}) {
      root[static_cast<std::size_t>(piece(vertex))] = piece(triangle[0]);
    }
  }
  std::map<int, double> volumes;
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    const Vector3& a = mesh.vertices_m.at(static_cast<std::size_t>(triangle[0]));
    const Vector3& b = mesh.vertices_m.at(static_cast<std::size_t>(triangle[1]));
    const Vector3& c = mesh.vertices_m.at(static_cast<std::size_t>(triangle[2]));
    volumes[piece(triangle[0])] += glm::dot(a, glm::cross(b, c)) / 6;
  }
  std::vector<double> list;
  list.reserve(volumes.size());
  for (const auto& entry : volumes) list.push_back(entry.second);
  return list;
}

// Distance of a point from the triangle a, b, c (Ericson, Real-Time Collision Detection, 5.1.5).
double DistanceFromTriangle(const Vector3& p, const Vector3& a, const Vector3& b,
                            const Vector3& c) {
  const auto from_segment = [&p](const Vector3& from, const Vector3& to) {
    const Vector3 along = to - from;
    const double t = std::clamp(glm::dot(p - from, along) / glm::dot(along, along), 0.0, 1.0);
    return glm::length(p - from - t * along);
  };
  const Vector3 normal = glm::normalize(glm::cross(b - a, c - a));
  const auto is_inside = [&](const Vector3& from, const Vector3& to) {
    return glm::dot(glm::cross(to - from, p - from), normal) >= 0;
  };
  if (is_inside(a, b) && is_inside(b, c) && is_inside(c, a)) {
    return std::abs(glm::dot(p - a, normal));
  }
  return std::min({from_segment(a, b), from_segment(b, c), from_segment(c, a)});
}

double DistanceFromMesh_mm(const TriangleMesh& mesh, const Vector3& p) {
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    nearest_m =
        std::min(nearest_m,
                 DistanceFromTriangle(p, mesh.vertices_m.at(static_cast<std::size_t>(triangle[0])),
                                      mesh.vertices_m.at(static_cast<std::size_t>(triangle[1])),
                                      mesh.vertices_m.at(static_cast<std::size_t>(triangle[2]))));
  }
  return 1000 * nearest_m;
}

// All lengths of a person `size` times as large.
Anatomy Scaled(Anatomy anatomy, double size) {
  for (Vector3& landmark_m : anatomy.landmarks_m) landmark_m *= size;
  for (Ellipsoid* ellipsoid : {&anatomy.ribcage, &anatomy.gliding}) {
    ellipsoid->center_m *= size;
    ellipsoid->radii_m *= size;
  }
  return anatomy;
}

// Another person: of another size, every landmark off by up to a centimetre.
Anatomy AnyAnatomy() {
  Anatomy anatomy = Scaled(BuiltInAnatomy(), *NumberWithin(0.8, 1.25));
  constexpr double kOff_m = 0.01;
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    // IJ is the thorax's origin.
    if (i != static_cast<std::size_t>(Landmark::kIJ)) {
      anatomy.landmarks_m[i] += *VectorWithin(-kOff_m, kOff_m) / std::sqrt(3.0);
    }
  }
  return anatomy;
}

class BoneMesh : public testing::TestWithParam<Bone> {
 protected:
  static TriangleMesh Draw() { return GetParam().draw(BuiltInAnatomy()); }
};

INSTANTIATE_TEST_SUITE_P(Bones, BoneMesh, testing::ValuesIn(kBones));

TEST_P(BoneMesh, HasTrianglesOfItsOwnVertices) {
  const TriangleMesh mesh = Draw();
  ASSERT_FALSE(mesh.triangles.empty());
  std::vector<bool> used(mesh.vertices_m.size());
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    for (const int vertex : triangle) {
      ASSERT_GE(vertex, 0);
      ASSERT_LT(static_cast<std::size_t>(vertex), mesh.vertices_m.size());
      used[static_cast<std::size_t>(vertex)] = true;
    }
  }
  EXPECT_EQ(std::count(used.begin(), used.end(), false), 0) << "vertices of no triangle";
}

TEST_P(BoneMesh, IsFinite) {
  for (const Vector3& vertex : Draw().vertices_m) {
    EXPECT_TRUE(std::isfinite(vertex.x) && std::isfinite(vertex.y) && std::isfinite(vertex.z));
  }
}

TEST_P(BoneMesh, IsClosed) {
  const auto counts = EdgeCounts(Draw());
  for (const auto& [edge, count] : counts) {
    EXPECT_EQ(count, 1) << "edge " << edge.first << " to " << edge.second;
    EXPECT_EQ(counts.count({edge.second, edge.first}), 1U)
        << "edge " << edge.first << " to " << edge.second << " has one triangle";
  }
}

TEST_P(BoneMesh, FacesOutward) {
  for (const double volume_m3 : PieceVolumes_m3(Draw())) EXPECT_GT(volume_m3, 0);
}

// Models hold vertices to a tenth of a millimetre.
TEST_P(BoneMesh, HasNoTriangleThatRoundingCouldFold) {
  constexpr double kSmallest_mm2 = 0.05;
  const TriangleMesh mesh = Draw();
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    EXPECT_GT(1e6 * Area(mesh, triangle), kSmallest_mm2)
        << triangle[0] << ", " << triangle[1] << ", " << triangle[2];
  }
}

TEST_P(BoneMesh, IsTheSameEveryTime) {
  const TriangleMesh once = Draw();
  const TriangleMesh again = Draw();
  EXPECT_EQ(once.vertices_m, again.vertices_m);
  EXPECT_EQ(once.triangles, again.triangles);
}

TEST_P(BoneMesh, GrowsWithThePerson) {
  constexpr double kSize = 1.25;
  constexpr double kRounding_m = 1e-12;
  const TriangleMesh mesh = Draw();
  const TriangleMesh larger = GetParam().draw(Scaled(BuiltInAnatomy(), kSize));
  ASSERT_EQ(larger.triangles, mesh.triangles);
  for (std::size_t i = 0; i < mesh.vertices_m.size(); ++i) {
    EXPECT_LT(glm::length(larger.vertices_m[i] - kSize * mesh.vertices_m[i]), kRounding_m);
  }
}

RC_GTEST_PROP(BoneMeshOfAnyone, IsClosedOutwardAndNowhereFlat, ()) {
  const Anatomy anatomy = AnyAnatomy();
  for (const Bone& bone : kBones) {
    const TriangleMesh mesh = bone.draw(anatomy);
    RC_LOG() << bone.name;
    RC_ASSERT(IsClosed(mesh));
    for (const double volume_m3 : PieceVolumes_m3(mesh)) RC_ASSERT(volume_m3 > 0);
    for (const std::array<int, 3>& triangle : mesh.triangles) RC_ASSERT(Area(mesh, triangle) > 0);
  }
}

// Where a landmark lies on its bone, and how near the drawing comes.
struct LandmarkOnBone {
  const char* name;
  TriangleMesh (*draw)(const Anatomy&);
  Landmark landmark;
  double within_mm;
};

void PrintTo(const LandmarkOnBone& landmark, std::ostream* out) { *out << landmark.name; }

class LandmarkOfTheMesh : public testing::TestWithParam<LandmarkOnBone> {
 protected:
  // In the median plane for the rib cage, on which both shoulders hang.
  static double Distance_mm(const Anatomy& anatomy) {
    Vector3 landmark_m = anatomy.landmark_m(GetParam().landmark);
    if (GetParam().draw == RibcageMesh) landmark_m.z = 0;
    return DistanceFromMesh_mm(GetParam().draw(anatomy), landmark_m);
  }
};

TEST_P(LandmarkOfTheMesh, LiesOnIt) {
  EXPECT_LT(Distance_mm(BuiltInAnatomy()), GetParam().within_mm);
}

TEST_P(LandmarkOfTheMesh, TakesItAlongWhenItMoves) {
  constexpr double kOff_m = 0.008;  // more than would be near enough without
  for (int axis = 0; axis < 3; ++axis) {
    Anatomy anatomy = BuiltInAnatomy();
    anatomy.landmarks_m[static_cast<std::size_t>(GetParam().landmark)][axis] += kOff_m;
    EXPECT_LT(Distance_mm(anatomy), GetParam().within_mm) << "moved along axis " << axis;
  }
}

// A landmark is a point of the skin over an edge that is drawn some millimetres thick.
constexpr double kOnAnEdge_mm = 6;

INSTANTIATE_TEST_SUITE_P(
    Promised, LandmarkOfTheMesh,
    testing::Values(LandmarkOnBone{"TS", ScapulaMesh, Landmark::kTS, kOnAnEdge_mm},
                    LandmarkOnBone{"AI", ScapulaMesh, Landmark::kAI, kOnAnEdge_mm},
                    LandmarkOnBone{"AA", ScapulaMesh, Landmark::kAA, kOnAnEdge_mm},
                    LandmarkOnBone{"PC", ScapulaMesh, Landmark::kPC, kOnAnEdge_mm},
                    LandmarkOnBone{"GC", ScapulaMesh, Landmark::kGC, kOnAnEdge_mm},
                    LandmarkOnBone{"PAC", ClavicleMesh, Landmark::kPAC, kOnAnEdge_mm},
                    LandmarkOnBone{"PX", RibcageMesh, Landmark::kPX, kOnAnEdge_mm},
                    LandmarkOnBone{"C7", RibcageMesh, Landmark::kC7, kOnAnEdge_mm},
                    LandmarkOnBone{"T8", RibcageMesh, Landmark::kT8, kOnAnEdge_mm},
                    LandmarkOnBone{"EM", HumerusMesh, Landmark::kEM, kOnAnEdge_mm},
                    LandmarkOnBone{"EL", HumerusMesh, Landmark::kEL, kOnAnEdge_mm}));

TEST(RibcageMesh, BeginsAtTheJugularNotch) {
  EXPECT_LT(DistanceFromMesh_mm(RibcageMesh(BuiltInAnatomy()), {0, 0, 0}), kOnAnEdge_mm);
}

TEST(ClavicleMesh, BeginsAtTheSternum) {
  // The end of the bone is a knob of about 20 mm, whose middle is the joint.
  constexpr double kRadiusOfTheKnob_mm = 11;
  EXPECT_LT(DistanceFromMesh_mm(ClavicleMesh(BuiltInAnatomy()), {0, 0, 0}), kRadiusOfTheKnob_mm);
}

TEST(ScapulaMesh, ReachesTheAcJoint) {
  // PAC is the most dorsal point of the joint, at the edge of the acromion.
  EXPECT_LT(DistanceFromMesh_mm(ScapulaMesh(BuiltInAnatomy()), {0, 0, 0}), kOnAnEdge_mm);
}

// The glenoid opens from its centre towards GH: the way there is free, the other way is bone.
TEST(ScapulaMesh, OpensTheGlenoidTowardsTheHumerus) {
  const Anatomy anatomy = BuiltInAnatomy();
  const TriangleMesh mesh = ScapulaMesh(anatomy);
  const Vector3 gc_m = anatomy.landmark_m(Landmark::kGC);
  const Vector3 gh_m = anatomy.landmark_m(Landmark::kGH);
  const double free_mm = DistanceFromMesh_mm(mesh, gh_m);
  EXPECT_GT(free_mm, 0.8 * 1000 * glm::length(gh_m - gc_m));
}

TEST(RibcageMesh, IsSymmetric) {
  const TriangleMesh mesh = RibcageMesh(BuiltInAnatomy());
  const auto sorted = [](const std::vector<Vector3>& points, double side) {
    std::vector<std::array<long, 3>> micrometers;
    micrometers.reserve(points.size());
    for (const Vector3& point : points) {
      micrometers.push_back({std::lround(1e6 * point.x), std::lround(1e6 * point.y),
                             std::lround(1e6 * side * point.z)});
    }
    std::sort(micrometers.begin(), micrometers.end());
    return micrometers;
  };
  EXPECT_EQ(sorted(mesh.vertices_m, 1), sorted(mesh.vertices_m, -1));
}

TEST(RibcageMesh, HasTenPairsOfRibsASternumAndASpine) {
  constexpr std::size_t kRibs = 20;
  constexpr std::size_t kSternum = 1;
  constexpr std::size_t kColumn = 1;
  constexpr std::size_t kSpinousProcesses = 14;  // C7 to L1
  EXPECT_EQ(PieceVolumes_m3(RibcageMesh(BuiltInAnatomy())).size(),
            kRibs + kSternum + kColumn + kSpinousProcesses);
}

// Radius of the sphere about the origin that most vertices lie on.
double RadiusOfTheHead_m(const TriangleMesh& mesh) {
  constexpr double kNanometersPerMeter = 1e9;
  std::map<long, int> counts;
  for (const Vector3& vertex : mesh.vertices_m) {
    ++counts[std::lround(kNanometersPerMeter * glm::length(vertex))];
  }
  const auto most =
      std::max_element(counts.begin(), counts.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  constexpr int kEnoughForASphere = 50;
  return most->second < kEnoughForASphere ? 0
                                          : static_cast<double>(most->first) / kNanometersPerMeter;
}

TEST(HumerusMesh, HasItsHeadAboutGh) {
  // Radii of anatomical heads.
  constexpr double kSmallest_m = 0.020;
  constexpr double kLargest_m = 0.027;
  const double radius_m = RadiusOfTheHead_m(HumerusMesh(BuiltInAnatomy()));
  EXPECT_GT(radius_m, kSmallest_m);
  EXPECT_LT(radius_m, kLargest_m);
}

TEST(HumerusMesh, LeavesRoomForCartilageBetweenHeadAndGlenoid) {
  const Anatomy anatomy = BuiltInAnatomy();
  EXPECT_LT(RadiusOfTheHead_m(HumerusMesh(anatomy)),
            glm::length(anatomy.landmark_m(Landmark::kGC) - anatomy.landmark_m(Landmark::kGH)));
}

// The head fits the glenoid that it turns in, whatever the length of the shaft.
TEST(HumerusMesh, LeavesRoomForCartilageWithALongShaft) {
  const Anatomy anatomy = ScaledAnatomy(BuiltInAnatomy(), {.humerus_length_m = 0.4});
  const double to_glenoid_m =
      glm::length(anatomy.landmark_m(Landmark::kGC) - anatomy.landmark_m(Landmark::kGH));
  const double radius_m = RadiusOfTheHead_m(HumerusMesh(anatomy));
  EXPECT_LT(radius_m, to_glenoid_m);
  EXPECT_GT(radius_m, 0.9 * to_glenoid_m);
}

// Extent of the vertices in the lowest tenth of the bone along EM-EL.
double ElbowWidth_m(const Anatomy& anatomy) {
  const Vector3 lateral =
      glm::normalize(anatomy.landmark_m(Landmark::kEL) - anatomy.landmark_m(Landmark::kEM));
  double lowest_m = 1;
  double highest_m = -1;
  for (const Vector3& vertex : HumerusMesh(anatomy).vertices_m) {
    if (vertex.y > 0.9 * anatomy.elbow_m().y) continue;
    lowest_m = std::min(lowest_m, glm::dot(vertex, lateral));
    highest_m = std::max(highest_m, glm::dot(vertex, lateral));
  }
  return highest_m - lowest_m;
}

TEST(HumerusMesh, IsAsBroadAsTheEpicondylesAreApart) {
  for (const double times : {0.8, 1.0, 1.25}) {
    Anatomy anatomy = BuiltInAnatomy();
    Vector3& em_m = anatomy.landmarks_m[static_cast<std::size_t>(Landmark::kEM)];
    Vector3& el_m = anatomy.landmarks_m[static_cast<std::size_t>(Landmark::kEL)];
    const Vector3 middle_m = anatomy.elbow_m();
    em_m = middle_m + times * (em_m - middle_m);
    el_m = middle_m + times * (el_m - middle_m);
    const double apart_m = glm::distance(em_m, el_m);
    EXPECT_NEAR(ElbowWidth_m(anatomy) / apart_m, 1, 0.05) << times;
  }
}

// Each bone is as long as its landmarks are apart.
TEST(ClavicleMesh, EndsWithItsLandmarks) {
  const TriangleMesh mesh = ClavicleMesh(BuiltInAnatomy());
  constexpr double kEnds_mm = 10;
  double lowest_m = 1;
  double highest_m = -1;
  for (const Vector3& vertex : mesh.vertices_m) {
    lowest_m = std::min(lowest_m, vertex.z);
    highest_m = std::max(highest_m, vertex.z);
  }
  EXPECT_NEAR(1000 * lowest_m, 0, kEnds_mm);
  EXPECT_NEAR(1000 * highest_m, 1000 * BuiltInAnatomy().landmark_m(Landmark::kPAC).z, kEnds_mm);
}

}  // namespace
}  // namespace girdle::bone_meshes_test
