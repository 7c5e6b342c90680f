// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/skin_landmarks.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>
#include <stdexcept>
#include <string>

namespace girdle {
namespace {

// A distance from the bone, in lengths of the upper arm, that is greater than that of any arm's
// skin. The vertex nearest to a point this far out is therefore on that side.
constexpr double kOutside = 0.28;

std::vector<int> NearestVertices(const TriangleMesh& surface, const Vector3& point_m,
                                 std::size_t count) {
  if (surface.vertices_m.size() < count) {
    throw std::invalid_argument("a surface of " + std::to_string(surface.vertices_m.size()) +
                                " vertices has no landmarks");
  }
  std::vector<int> order(surface.vertices_m.size());
  std::iota(order.begin(), order.end(), 0);
  const auto nearer = [&](int a, int b) {
    const double a_m = glm::length(surface.vertices_m[static_cast<std::size_t>(a)] - point_m);
    const double b_m = glm::length(surface.vertices_m[static_cast<std::size_t>(b)] - point_m);
    return a_m < b_m || (a_m == b_m && a < b);
  };
  const auto end = order.begin() + static_cast<std::ptrdiff_t>(count);
  std::partial_sort(order.begin(), end, order.end(), nearer);
  order.erase(end, order.end());
  return order;
}

}  // namespace

SkinLandmarkVertices FindSkinLandmarks(const PosedBody& body, Side side) {
  const Anatomy& anatomy = body.anatomy;
  const auto at = [&](Segment segment, const Vector3& point_m) {
    return OnSideInThorax_m(anatomy, body.pose, side, segment, point_m);
  };
  const Vector3& root = anatomy.landmark_m(Landmark::kTS);
  const Vector3& angle = anatomy.landmark_m(Landmark::kAA);
  const Vector3 shoulder = at(Segment::kHumerus, {0, 0, 0});
  const Vector3 elbow = at(Segment::kHumerus, anatomy.elbow_m());
  const Vector3 away = OnSide(side, Vector3(0, 0, 1));
  const Vector3 along = glm::normalize(elbow - shoulder);
  const Vector3 outward = glm::normalize(away - glm::dot(away, along) * along);

  const std::array<Vector3, kSkinLandmarkCount> points_m = {
      at(Segment::kScapula, anatomy.landmark_m(Landmark::kACJ)),
      at(Segment::kScapula, AcromionTip_m(anatomy)),
      at(Segment::kClavicle, anatomy.landmark_m(Landmark::kPAC) / 2.0),
      at(Segment::kScapula, (root + angle) / 2.0),
      shoulder + (elbow - shoulder) / 3.0 + outward * (kOutside * glm::length(elbow - shoulder)),
  };
  SkinLandmarkVertices vertices;
  for (std::size_t i = 0; i < kSkinLandmarkCount; ++i) {
    const std::size_t count = kSkinLandmarkNames[i] == kSkinAcromionName ? 3 : 1;
    vertices[i] = NearestVertices(body.surface, points_m[i], count);
  }
  return vertices;
}

}  // namespace girdle
