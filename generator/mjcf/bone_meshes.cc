// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "mjcf/bone_meshes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <iterator>
#include <utility>

namespace girdle {
namespace {

// The shapes below are tables in millimetres of the drawn bone. A bone of another length is scaled
// as a whole. Each drawn length is that of the landmarks in data/.
constexpr double kDrawnScapula_mm = 129.1;   // TS to PAC
constexpr double kDrawnSternum_mm = 136.8;   // IJ to PX
constexpr double kDrawnClavicle_mm = 157.5;  // SC to PAC
constexpr double kDrawnHumerus_mm = 287.1;   // GH to the elbow's midpoint
constexpr double kDrawnElbow_mm = 68.214;    // EM to EL

constexpr Vector3 kForward{1, 0, 0};
constexpr Vector3 kUp{0, 1, 0};
constexpr Vector3 kRight{0, 0, 1};

// Closed line of points; the rings of one loft have the same number of points.
using Ring = std::vector<Vector3>;

// One elliptic section of a tube. The half axis `wide` is given; the other one is perpendicular to
// it and to the tube.
struct Station {
  Vector3 center_m{0, 0, 0};
  Vector3 wide_m{0, 0, 0};
  double half_thickness_m = 0;
};

Vector3 Mix(const Vector3& from, const Vector3& to, double t) { return from + t * (to - from); }

Vector3 Centroid(const Ring& ring) {
  Vector3 sum{0, 0, 0};
  for (const Vector3& point : ring) sum += point;
  return sum / static_cast<double>(ring.size());
}

// Volume [m^3] of the triangles from `first` on, positive if they face outward.
double SignedVolume(const TriangleMesh& mesh, std::size_t first) {
  double volume = 0;
  for (std::size_t i = first; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    volume += glm::dot(mesh.vertices_m[a], glm::cross(mesh.vertices_m[b], mesh.vertices_m[c])) / 6;
  }
  return volume;
}

// Adds the closed skin over `rings`; the first and the last are filled in with a fan.
void AppendLoft(const std::vector<Ring>& rings, TriangleMesh& mesh) {
  const int size = static_cast<int>(rings.front().size());
  const int base = static_cast<int>(mesh.vertices_m.size());
  const int last = base + size * (static_cast<int>(rings.size()) - 1);
  const std::size_t first_triangle = mesh.triangles.size();
  for (const Ring& ring : rings) {
    mesh.vertices_m.insert(mesh.vertices_m.end(), ring.begin(), ring.end());
  }
  mesh.vertices_m.push_back(Centroid(rings.front()));
  mesh.vertices_m.push_back(Centroid(rings.back()));
  for (int i = 0; i < size; ++i) {
    const int next = (i + 1) % size;
    mesh.triangles.push_back({last + size, base + next, base + i});
    for (int row = base; row < last; row += size) {
      mesh.triangles.push_back({row + i, row + next, row + size + i});
      mesh.triangles.push_back({row + next, row + size + next, row + size + i});
    }
    mesh.triangles.push_back({last + size + 1, last + i, last + next});
  }
  if (SignedVolume(mesh, first_triangle) > 0) return;
  for (std::size_t i = first_triangle; i < mesh.triangles.size(); ++i) {
    std::swap(mesh.triangles[i][1], mesh.triangles[i][2]);
  }
}

// Returns the ring of an ellipse with half axes `wide` and `thin`, starting at the end of `wide`.
Ring Ellipse(const Vector3& center, const Vector3& wide, const Vector3& thin, int size) {
  Ring ring;
  for (int i = 0; i < size; ++i) {
    const double angle = 2 * kPi * i / size;
    ring.push_back(center + std::cos(angle) * wide + std::sin(angle) * thin);
  }
  return ring;
}

// Adds a tube through `stations`, `size` points around, closed flat at both ends.
void AppendTube(const std::vector<Station>& stations, int size, TriangleMesh& mesh) {
  std::vector<Ring> rings;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const Station& station = stations[i];
    const Vector3 along = stations[std::min(i + 1, stations.size() - 1)].center_m -
                          stations[i == 0 ? 0 : i - 1].center_m;
    const Vector3 thin = glm::normalize(glm::cross(along, station.wide_m));
    rings.push_back(
        Ellipse(station.center_m, station.wide_m, station.half_thickness_m * thin, size));
  }
  AppendLoft(rings, mesh);
}

// Returns `stations` with a smaller one beyond either end, so that the tube ends round.
std::vector<Station> Rounded(std::vector<Station> stations) {
  constexpr double kSize = 0.6;    // share of the last station's half axes
  constexpr double kLength = 0.5;  // distance beyond it, as a share of its half thickness
  const auto beyond = [](const Station& end, const Station& neighbor) {
    const Vector3 outward = glm::normalize(end.center_m - neighbor.center_m);
    return Station{end.center_m + kLength * end.half_thickness_m * outward, kSize * end.wide_m,
                   kSize * end.half_thickness_m};
  };
  const Station first = beyond(stations[0], stations[1]);
  const Station last = beyond(stations.back(), stations[stations.size() - 2]);
  stations.insert(stations.begin(), first);
  stations.push_back(last);
  return stations;
}

// Returns `stations` with one more between each two, on the cubic through its four neighbours.
std::vector<Station> Smoothed(const std::vector<Station>& stations) {
  std::vector<Station> smooth;
  const std::size_t last = stations.size() - 1;
  for (std::size_t i = 0; i < last; ++i) {
    const Station& before = stations[i == 0 ? 0 : i - 1];
    const Station& from = stations[i];
    const Station& to = stations[i + 1];
    const Station& after = stations[std::min(i + 2, last)];
    const auto midway = [](const auto& a, const auto& b, const auto& c, const auto& d) {
      return (9.0 * (b + c) - (a + d)) / 16.0;
    };
    smooth.push_back(from);
    smooth.push_back({midway(before.center_m, from.center_m, to.center_m, after.center_m),
                      midway(before.wide_m, from.wide_m, to.wide_m, after.wide_m),
                      midway(before.half_thickness_m, from.half_thickness_m, to.half_thickness_m,
                             after.half_thickness_m)});
  }
  smooth.push_back(stations.back());
  return smooth;
}

// The plane of the blade through TS, AI and GC. A place in it is given as shares of the vectors
// TS-AI and TS-GC: TS is (0, 0), the inferior angle is (1, 0) and the glenoid's centre is (0, 1).
struct BladePlane {
  Vector3 ts_m;
  Vector3 down_m;
  Vector3 lateral_m;
  Vector3 forward;  // unit normal

  explicit BladePlane(const Anatomy& anatomy)
      : ts_m(anatomy.landmark_m(Landmark::kTS)),
        down_m(anatomy.landmark_m(Landmark::kAI) - ts_m),
        lateral_m(anatomy.landmark_m(Landmark::kGC) - ts_m),
        forward(glm::normalize(glm::cross(lateral_m, down_m))) {}

  [[nodiscard]] Vector3 At(double towards_ai, double towards_gc, double forward_m) const {
    return ts_m + towards_ai * down_m + towards_gc * lateral_m + forward_m * forward;
  }
};

// Points of the blade's rim, once around.
struct RimPoint {
  double towards_ai;
  double towards_gc;
  double forward_mm;
  double half_thickness_mm;
};
constexpr RimPoint kBladeRim[] = {
    // Medial border, downward, a little convex.
    {-0.16, 0.02, 1, 2.6},
    {0.00, -0.01, 0, 2.8},
    {0.17, -0.03, 0, 2.4},
    {0.34, -0.04, 0, 2.2},
    {0.51, -0.04, 0, 2.2},
    {0.68, -0.03, 0, 2.4},
    {0.84, -0.02, 0, 2.8},
    // Inferior angle.
    {0.95, -0.01, 0, 3.4},
    {1.00, 0.02, 0, 3.8},
    {0.99, 0.09, 0, 4.0},
    {0.91, 0.17, 0, 4.2},
    // Lateral border, upward, a little concave and thick.
    {0.81, 0.25, 0, 4.0},
    {0.71, 0.34, 0, 4.0},
    {0.61, 0.44, 0, 4.2},
    {0.51, 0.55, 0, 4.5},
    {0.41, 0.67, 0, 4.8},
    {0.30, 0.79, 0, 5.2},
    {0.18, 0.87, 0, 5.8},
    // Neck, behind the glenoid.
    {0.07, 0.90, 0, 6.0},
    {-0.06, 0.90, 0, 6.0},
    // Upper border: root of the coracoid process, notch, superior angle.
    {-0.16, 0.84, 1, 4.5},
    {-0.16, 0.73, 1, 2.6},
    {-0.20, 0.62, 1, 2.2},
    {-0.25, 0.49, 2, 2.0},
    {-0.30, 0.36, 4, 2.0},
    {-0.35, 0.23, 6, 2.2},
    {-0.37, 0.14, 7, 2.6},
    {-0.34, 0.07, 6, 2.8},
    {-0.26, 0.04, 3, 2.6},
};
// The blade's inner rings, from the middle to the rim: shares of the rim's size and thickness.
struct BladeRing {
  double size;
  double thickness;
};
constexpr BladeRing kBladeRings[] = {{0.42, 0.5}, {0.80, 0.55}, {0.94, 1.0}};
// The point to which the rings shrink, and its distance behind the rim. It has no thickness.
constexpr RimPoint kBladeMiddle = {0.25, 0.38, -9, 0};

void AppendBlade(const BladePlane& plane, double mm, TriangleMesh& mesh) {
  const Vector3 middle = plane.At(kBladeMiddle.towards_ai, kBladeMiddle.towards_gc, 0);
  const auto ring_on = [&](double side, const BladeRing& shape) {
    Ring ring;
    const double bow_m = kBladeMiddle.forward_mm * mm * (1 - shape.size * shape.size);
    for (const RimPoint& point : kBladeRim) {
      const Vector3 rim = plane.At(point.towards_ai, point.towards_gc, point.forward_mm * mm);
      const double half_thickness_m = point.half_thickness_mm * mm * shape.thickness;
      ring.push_back(Mix(middle, rim, shape.size) +
                     (side * half_thickness_m + bow_m) * plane.forward);
    }
    return ring;
  };
  // From the middle of the front out to the rim, and on the back inward again.
  std::vector<Ring> rings;
  for (const BladeRing& shape : kBladeRings) rings.push_back(ring_on(1, shape));
  rings.push_back(ring_on(0, {1, 0}));
  for (std::size_t i = std::size(kBladeRings); i-- > 0;) {
    rings.push_back(ring_on(-1, kBladeRings[i]));
  }
  AppendLoft(rings, mesh);
}

// The scapular spine is a plate between its root on the blade and its crest, which rises from TS to
// AA. At AA the root has left the blade, and the plate continues as the acromion.
struct SpineStation {
  double root_towards_ai;
  double root_towards_gc;
  double root_forward_mm;  // off the blade's plane
  double crest;            // share of the way TS-AA
  double half_thickness_mm;
};
constexpr SpineStation kSpine[] = {
    {0.03, -0.01, 0, 0.00, 4.0},   {0.00, 0.13, -2, 0.18, 3.6},  {-0.03, 0.30, -4, 0.36, 3.2},
    {-0.05, 0.48, -6, 0.54, 3.2},  {-0.07, 0.66, -6, 0.72, 3.6}, {-0.09, 0.80, -8, 0.87, 4.2},
    {-0.21, 0.96, -19, 1.00, 4.6},
};
// The acromion from AA over the humeral head to its tip in front of the AC joint, relative to PAC.
struct PlateStation {
  Vector3 inner_mm;
  Vector3 outer_mm;
  double half_thickness_mm;
};
constexpr PlateStation kAcromion[] = {
    {{-11, -9, -14}, {-29, -15, 5}, 4.6},
    {{-5, -5, -4}, {-15, -11, 17}, 4.4},
    {{3, -4, -1}, {0, -10, 19}, 4.2},
    {{9, -6, 2}, {10, -10, 14}, 3.6},
};

void AppendSpineAndAcromion(const Anatomy& anatomy, const BladePlane& plane, double mm,
                            TriangleMesh& mesh) {
  constexpr int kPointsAround = 8;
  std::vector<Station> stations;
  const auto add = [&](const Vector3& inner, const Vector3& outer, double half_thickness_mm) {
    stations.push_back({(inner + outer) / 2.0, (outer - inner) / 2.0, half_thickness_mm * mm});
  };
  for (const SpineStation& spine : kSpine) {
    add(plane.At(spine.root_towards_ai, spine.root_towards_gc, spine.root_forward_mm * mm),
        Mix(plane.ts_m, anatomy.landmark_m(Landmark::kAA), spine.crest), spine.half_thickness_mm);
  }
  for (const PlateStation& acromion : kAcromion) {
    add(acromion.inner_mm * mm, acromion.outer_mm * mm, acromion.half_thickness_mm);
  }
  AppendTube(Rounded(Smoothed(stations)), kPointsAround, mesh);
}

// The coracoid process: from the blade's upper border forward, and hooked to PC.
struct HookStation {
  double towards_pc;   // share of the way from the root to PC
  double above_mm;     // off that way, along the scapula's y
  double medially_mm;  // off that way, against the scapula's z
  double half_width_mm;
  double half_thickness_mm;
};
constexpr HookStation kCoracoid[] = {
    {-0.10, -3, 0, 11, 7.5}, {0.15, 5, 4, 9.5, 6.5}, {0.38, 10, 8, 8, 6},
    {0.62, 9.5, 8, 7.5, 5},  {0.84, 5, 4, 6.5, 4.5}, {0.98, 1, 0, 5, 4},
};
constexpr RimPoint kCoracoidRoot = {-0.14, 0.87, 3, 0};  // on the blade; no thickness

void AppendCoracoid(const Anatomy& anatomy, const BladePlane& plane, double mm,
                    TriangleMesh& mesh) {
  constexpr int kPointsAround = 8;
  const Vector3 root =
      plane.At(kCoracoidRoot.towards_ai, kCoracoidRoot.towards_gc, kCoracoidRoot.forward_mm * mm);
  const Vector3& tip = anatomy.landmark_m(Landmark::kPC);
  // The process is flat as seen from above: it is wide across the forward direction.
  const Vector3 across = glm::normalize(glm::cross(tip - root, kUp));
  std::vector<Station> stations;
  for (const HookStation& hook : kCoracoid) {
    stations.push_back({Mix(root, tip, hook.towards_pc) + hook.above_mm * mm * kUp -
                            hook.medially_mm * mm * kRight,
                        hook.half_width_mm * mm * across, hook.half_thickness_mm * mm});
  }
  AppendTube(Rounded(stations), kPointsAround, mesh);
}

// The glenoid from its neck to its hollow: half axes of a pear.
struct CupRing {
  double towards_gh_mm;  // from GC
  double half_height_mm;
  double half_width_mm;
  bool hollow;  // whether it is on the hollow face; otherwise flat
};
constexpr CupRing kGlenoid[] = {
    {-24, 13, 5.5, false}, {-9, 15, 9, false}, {-2, 18, 12.5, false},
    {0, 18.5, 13, true},   {0, 13, 9, true},   {0, 6, 4, true},
};
constexpr double kGlenoidNarrowing = 0.22;  // share by which the pear is narrower at its top
constexpr double kGlenoidFlatness = 1.3;    // radius of the hollow over the distance GC-GH

void AppendGlenoid(const Anatomy& anatomy, double mm, TriangleMesh& mesh) {
  constexpr int kPointsAround = 14;
  const Vector3& gc = anatomy.landmark_m(Landmark::kGC);
  const Vector3 to_gh = anatomy.landmark_m(Landmark::kGH) - gc;
  const Vector3 axis = glm::normalize(to_gh);
  const Vector3 forward = glm::normalize(glm::cross(kUp, axis));
  const Vector3 up = glm::cross(axis, forward);
  const double hollow_radius_m = kGlenoidFlatness * glm::length(to_gh);
  std::vector<Ring> rings;
  for (const CupRing& cup : kGlenoid) {
    Ring ring;
    for (int i = 0; i < kPointsAround; ++i) {
      const double angle = 2 * kPi * i / kPointsAround;
      const double height_m = cup.half_height_mm * mm * std::sin(angle);
      const double width_m =
          cup.half_width_mm * mm * std::cos(angle) * (1 - kGlenoidNarrowing * std::sin(angle));
      // A sphere near its pole rises by r^2 / 2R.
      const double rise_m =
          cup.hollow ? (height_m * height_m + width_m * width_m) / (2 * hollow_radius_m) : 0;
      ring.push_back(gc + height_m * up + width_m * forward +
                     (cup.towards_gh_mm * mm + rise_m) * axis);
    }
    rings.push_back(ring);
  }
  AppendLoft(rings, mesh);
}

// The vertebrae, counted from C7.
constexpr int kT8 = 8;
constexpr int kLowestVertebra = 13;  // L1
// Distance by which the line of spinous processes bulges backward between C7 and T8. Below T8 the
// line turns forward.
constexpr double kKyphosis_mm = 10;
// The middle of a vertebral body, relative to the tip of its spinous process.
constexpr Vector3 kVertebraFromTip_mm{40, 12, 0};
constexpr double kVertebraHalfWidth_mm = 16;
constexpr double kVertebraHalfDepth_mm = 13;
constexpr double kDiscSize = 0.75;  // share of the vertebra's half axes
constexpr double kSpinousRootHalfHeight_mm = 7;
constexpr double kSpinousTipHalfHeight_mm = 4;
constexpr double kSpinousHalfWidth_mm = 3.5;

// Returns the tip of a spinous process in the median plane.
Vector3 SpinousTip(const Anatomy& anatomy, double vertebra, double mm) {
  const double t = vertebra / kT8;
  Vector3 tip = Mix(anatomy.landmark_m(Landmark::kC7), anatomy.landmark_m(Landmark::kT8), t);
  tip.x -= 4 * t * (1 - t) * kKyphosis_mm * mm;
  tip.z = 0;
  return tip;
}

Vector3 VertebraCenter(const Anatomy& anatomy, double vertebra, double mm) {
  return SpinousTip(anatomy, vertebra, mm) + kVertebraFromTip_mm * mm;
}

void AppendSpine(const Anatomy& anatomy, double mm, TriangleMesh& mesh) {
  constexpr int kPointsAround = 6;
  constexpr int kPointsAroundProcess = 4;
  std::vector<Station> column;
  const auto add = [&](double where, double size) {
    column.push_back({VertebraCenter(anatomy, where, mm),
                      size * kVertebraHalfWidth_mm * mm * kRight,
                      size * kVertebraHalfDepth_mm * mm});
  };
  for (int vertebra = 0; vertebra <= kLowestVertebra; ++vertebra) {
    add(vertebra - 0.5, kDiscSize);
    add(vertebra, 1);
    AppendTube({{VertebraCenter(anatomy, vertebra, mm), kSpinousRootHalfHeight_mm * mm * kUp,
                 kSpinousHalfWidth_mm * mm},
                {SpinousTip(anatomy, vertebra, mm), kSpinousTipHalfHeight_mm * mm * kUp,
                 kSpinousHalfWidth_mm * mm}},
               kPointsAroundProcess, mesh);
  }
  AppendTube(Rounded(column), kPointsAround, mesh);
}

// Stations of the sternum along IJ-PX: manubrium, sternal angle, body, xiphoid process.
struct SternumStation {
  double along;
  double half_width_mm;
  double half_thickness_mm;
};
constexpr SternumStation kSternum[] = {
    {0.02, 22, 6},   {0.12, 28, 6}, {0.25, 18, 5.5}, {0.33, 15.5, 5},
    {0.60, 18.5, 5}, {0.78, 17, 5}, {0.84, 9, 4},    {0.98, 5, 3},
};
constexpr double kSternumBehind_mm = 6;  // its middle, from the line IJ-PX on its front

Vector3 SternumCenter(const Anatomy& anatomy, double along, double mm) {
  Vector3 center = Mix(anatomy.landmark_m(Landmark::kIJ), anatomy.landmark_m(Landmark::kPX), along);
  center.x -= kSternumBehind_mm * mm;
  center.z = 0;
  return center;
}

void AppendSternum(const Anatomy& anatomy, double mm, TriangleMesh& mesh) {
  constexpr int kPointsAround = 8;
  std::vector<Station> stations;
  for (const SternumStation& part : kSternum) {
    stations.push_back({SternumCenter(anatomy, part.along, mm), part.half_width_mm * mm * kRight,
                        part.half_thickness_mm * mm});
  }
  AppendTube(Rounded(stations), kPointsAround, mesh);
}

// The pairs of ribs from the first downward. A false rib ends on the rib above it.
struct Rib {
  double on_sternum;  // share of the way IJ-PX; negative for a false rib
  double sag_mm;      // depth below the straight line from its root to its front end
  double width;       // share of the ellipsoid's
};
constexpr Rib kRibs[] = {
    {0.12, 4, 0.66},  {0.25, 20, 0.86}, {0.40, 36, 0.94}, {0.53, 52, 0.97}, {0.63, 68, 1.00},
    {0.71, 84, 1.00}, {0.78, 98, 1.00}, {-1, 76, 1.00},   {-1, 58, 1.00},   {-1, 42, 0.97},
};
constexpr int kRibIntervals = 10;    // along a rib
constexpr int kLeaningInterval = 8;  // where the rib below ends on this rib
constexpr double kRibHalfHeight_mm = 5.5;
constexpr double kRibHalfThickness_mm = 3;
constexpr double kSagExponent = 1.4;  // above 1, so that the lowest point is in the front half
constexpr double kFreeShare = 0.3;    // of a rib at either end, where it may leave the ellipsoid
constexpr Vector3 kRibRoot_mm{-6, 0, 9};   // from the middle of the vertebra
constexpr Vector3 kRibFront_mm{0, 0, 10};  // from the middle of the sternum

// Returns the middle line of a rib on the right, from its root at the spine to its front end.
std::vector<Vector3> RibLine(const Ellipsoid& cage, const Rib& rib, const Vector3& root,
                             const Vector3& front, double mm) {
  // Angle about the ellipsoid's vertical axis, from the back through the right.
  const auto angle = [&](const Vector3& point) {
    return std::atan2((point.z - cage.center_m.z) / cage.radii_m.z,
                      (cage.center_m.x - point.x) / cage.radii_m.x);
  };
  const auto on_ellipsoid = [&](double t) {
    const double turn = angle(root) + t * (angle(front) - angle(root));
    const double height_m =
        Mix(root, front, t).y - rib.sag_mm * mm * std::sin(kPi * std::pow(t, kSagExponent));
    const double sine = std::clamp((height_m - cage.center_m.y) / cage.radii_m.y, -1.0, 1.0);
    const double size = std::sqrt(1 - sine * sine);
    return Vector3{cage.center_m.x - size * cage.radii_m.x * std::cos(turn), height_m,
                   cage.center_m.z + rib.width * size * cage.radii_m.z * std::sin(turn)};
  };
  const auto freedom = [](double from_end) {
    const double rest = std::max(0.0, 1 - from_end / kFreeShare);
    return rest * rest;
  };
  std::vector<Vector3> line;
  for (int i = 0; i <= kRibIntervals; ++i) {
    const double t = static_cast<double>(i) / kRibIntervals;
    line.push_back(on_ellipsoid(t) + freedom(t) * (root - on_ellipsoid(0)) +
                   freedom(1 - t) * (front - on_ellipsoid(1)));
  }
  return line;
}

void AppendRibs(const Anatomy& anatomy, double mm, TriangleMesh& mesh) {
  constexpr int kPointsAround = 4;
  std::vector<Vector3> line;
  int vertebra = 0;
  for (const Rib& rib : kRibs) {
    ++vertebra;
    const Vector3 root = VertebraCenter(anatomy, vertebra, mm) + kRibRoot_mm * mm;
    const Vector3 front = rib.on_sternum < 0
                              ? line[kLeaningInterval]
                              : SternumCenter(anatomy, rib.on_sternum, mm) + kRibFront_mm * mm;
    line = RibLine(anatomy.ribcage, rib, root, front, mm);
    for (const double side : {1.0, -1.0}) {
      std::vector<Station> stations;
      stations.reserve(line.size());
      for (const Vector3& point : line) {
        stations.push_back({{point.x, point.y, side * point.z},
                            kRibHalfHeight_mm * mm * kUp,
                            kRibHalfThickness_mm * mm});
      }
      AppendTube(stations, kPointsAround, mesh);
    }
  }
}

// Sections of the clavicle from the sternum outward.
struct ClavicleStation {
  double along;  // share of the way SC-PAC
  double forward_mm;
  double up_mm;
  double half_width_mm;  // forward and backward
  double half_height_mm;
};
constexpr ClavicleStation kClavicle[] = {
    {0.02, 1, -1, 11, 11},   {0.07, 4, -1, 10.5, 10}, {0.16, 9, 0, 8, 8},
    {0.30, 15, 0, 6.5, 6.5}, {0.44, 14, 0, 6, 6},     {0.58, 6, 0, 6, 6},
    {0.70, -2, 0, 7, 5.5},   {0.82, -6, -1, 9, 5},    {0.92, -2, -2, 10.5, 4.6},
    {0.99, 3, -3, 9.5, 4.4},
};

// Sections of the humerus from the line between the epicondyles up to the greater tubercle.
struct HumerusStation {
  double up;  // share of the way from the elbow's midpoint to GH
  double forward_mm;
  double lateral_mm;
  double half_width_mm;  // along EM-EL
  double half_depth_mm;
};
constexpr HumerusStation kHumerus[] = {
    {0.000, 0, 0, 33, 6},    {0.030, 0, -1, 30, 6.5},   {0.070, 0, 0, 23, 7},
    {0.130, 0, 0, 16, 8},    {0.220, 0, 0, 11.5, 9.5},  {0.380, 0, 1, 10.5, 10.5},
    {0.560, 0, 2, 11.5, 11}, {0.720, 0, 3, 12, 12},     {0.820, 0, 5, 14, 13.5},
    {0.890, 1, 6, 18.5, 17}, {0.950, 0, 8.5, 19, 18.5}, {1.000, -1, 12, 15.5, 17.5},
    {1.030, -2, 14, 12, 15},
};
// A round section of a small part.
struct SpoolStation {
  double along_mm;
  double radius_mm;
};
// The spool of the elbow joint along EM-EL, from the lip of the trochlea to the capitulum.
constexpr SpoolStation kElbowSpool[] = {{-24, 11.5}, {-20, 12},  {-11, 8.5}, {-3, 9.5},
                                        {2, 8.5},    {12, 10.5}, {21, 8.5}};
constexpr Vector3 kElbowSpool_mm{4, -3, 0};  // its middle, relative to that of the epicondyles
// The lesser tubercle, upward.
constexpr SpoolStation kLesserTubercle[] = {{-22, 3}, {-10, 7}, {0, 8.5}, {7, 6}};
constexpr Vector3 kLesserTubercle_mm{14, -5, 10};  // from GH
// Up to this value of `up`, the bone is as broad as the elbow. The shaft begins above.
constexpr double kEndOfElbow = 0.22;
// Radius of the head as a share of the distance GC-GH, which leaves a gap for cartilage.
constexpr double kHeadRadius = 0.98196;

}  // namespace

TriangleMesh ScapulaMesh(const Anatomy& anatomy) {
  const BladePlane plane(anatomy);
  const double mm = glm::length(plane.ts_m) / kDrawnScapula_mm;
  TriangleMesh mesh;
  AppendBlade(plane, mm, mesh);
  AppendSpineAndAcromion(anatomy, plane, mm, mesh);
  AppendCoracoid(anatomy, plane, mm, mesh);
  AppendGlenoid(anatomy, mm, mesh);
  return mesh;
}

TriangleMesh RibcageMesh(const Anatomy& anatomy) {
  const double mm = glm::length(anatomy.landmark_m(Landmark::kPX)) / kDrawnSternum_mm;
  TriangleMesh mesh;
  AppendRibs(anatomy, mm, mesh);
  AppendSternum(anatomy, mm, mesh);
  AppendSpine(anatomy, mm, mesh);
  return mesh;
}

TriangleMesh ClavicleMesh(const Anatomy& anatomy) {
  constexpr int kPointsAround = 8;
  const Vector3& end = anatomy.landmark_m(Landmark::kPAC);
  const double mm = glm::length(end) / kDrawnClavicle_mm;
  std::vector<Station> stations;
  for (const ClavicleStation& part : kClavicle) {
    stations.push_back({part.along * end + part.forward_mm * mm * kForward + part.up_mm * mm * kUp,
                        part.half_width_mm * mm * kForward, part.half_height_mm * mm});
  }
  TriangleMesh mesh;
  AppendTube(Rounded(Smoothed(stations)), kPointsAround, mesh);
  return mesh;
}

TriangleMesh HumerusMesh(const Anatomy& anatomy) {
  constexpr int kPointsAround = 12;
  constexpr int kPointsAroundSmallParts = 8;
  constexpr int kHeadRings = 7;
  const Vector3 elbow = anatomy.elbow_m();
  const Vector3 lateral =
      glm::normalize(anatomy.landmark_m(Landmark::kEL) - anatomy.landmark_m(Landmark::kEM));
  const double mm = glm::length(elbow) / kDrawnHumerus_mm;
  const double elbow_mm =
      glm::distance(anatomy.landmark_m(Landmark::kEL), anatomy.landmark_m(Landmark::kEM)) /
      kDrawnElbow_mm;
  TriangleMesh mesh;

  std::vector<Station> shaft;
  for (const HumerusStation& part : kHumerus) {
    const double width_mm = std::lerp(elbow_mm, mm, std::min(part.up / kEndOfElbow, 1.0));
    shaft.push_back({Mix(elbow, {0, 0, 0}, part.up) + part.forward_mm * mm * kForward +
                         part.lateral_mm * mm * kRight,
                     part.half_width_mm * width_mm * lateral, part.half_depth_mm * mm});
  }
  AppendTube(Rounded(shaft), kPointsAround, mesh);

  std::vector<Ring> head;
  const double radius_m = kHeadRadius * glm::distance(anatomy.landmark_m(Landmark::kGC),
                                                      anatomy.landmark_m(Landmark::kGH));
  for (int i = 1; i <= kHeadRings; ++i) {
    const double from_pole = kPi * i / (kHeadRings + 1);
    head.push_back(Ellipse(radius_m * std::cos(from_pole) * kUp,
                           radius_m * std::sin(from_pole) * kForward,
                           radius_m * std::sin(from_pole) * kRight, kPointsAround));
  }
  AppendLoft(head, mesh);

  std::vector<Station> spool;
  for (const SpoolStation& part : kElbowSpool) {
    spool.push_back({elbow + kElbowSpool_mm * mm + part.along_mm * elbow_mm * lateral,
                     part.radius_mm * mm * kForward, part.radius_mm * mm});
  }
  AppendTube(Rounded(spool), kPointsAroundSmallParts, mesh);

  std::vector<Station> tubercle;
  for (const SpoolStation& part : kLesserTubercle) {
    tubercle.push_back({kLesserTubercle_mm * mm + part.along_mm * mm * kUp,
                        part.radius_mm * mm * kForward, part.radius_mm * mm});
  }
  AppendTube(Rounded(tubercle), kPointsAroundSmallParts, mesh);
  return mesh;
}

}  // namespace girdle
