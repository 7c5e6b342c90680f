// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/skin_measures.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "kinematics/one_sided_difference.h"
#include "skin/surface_depth.h"

namespace girdle {
namespace {

std::vector<SkinBone> BonesNamed(const std::vector<BoundBone>& bones) {
  const std::vector<SkinBone> known = SkinBonesOf({Side::kRight, Side::kLeft});
  std::vector<SkinBone> named;
  for (const BoundBone& bone : bones) {
    const auto found = std::find_if(known.begin(), known.end(), [&bone](const SkinBone& candidate) {
      return candidate.name() == bone.body;
    });
    if (found == known.end()) {
      throw std::invalid_argument("the skin hangs on \"" + bone.body +
                                  "\", which is no bone of a shoulder");
    }
    named.push_back(*found);
  }
  return named;
}

// Returns the velocities [m/rad] at a command, on the side in the direction of the step.
SkinLandmarkPlaces OneSidedVelocities(const LandmarkFunction& landmarks, Direction direction,
                                      const ArmCommand& command, const SkinLandmarkPlaces& origin_m,
                                      const SkinDifference& difference) {
  SkinLandmarkPlaces velocities;
  velocities.fill({0, 0, 0});
  for (std::size_t i = 0; i < difference.weights.size(); ++i) {
    const SkinLandmarkPlaces there_m =
        landmarks(MovedAlong(direction, command, static_cast<double>(i + 1) * difference.step_rad));
    for (std::size_t k = 0; k < kSkinLandmarkCount; ++k) {
      velocities[k] += difference.weights[i] / difference.step_rad * (there_m[k] - origin_m[k]);
    }
  }
  return velocities;
}

double Area_m2(const std::vector<Vector3>& vertices_m, const Triangle& triangle) {
  const auto at = [&](std::size_t corner) {
    return vertices_m[static_cast<std::size_t>(triangle[corner])];
  };
  return glm::length(glm::cross(at(1) - at(0), at(2) - at(0))) / 2;
}

}  // namespace

SkinOnBones::SkinOnBones(BoundSkin skin, const Anatomy& anatomy)
    : skin_(std::move(skin)), bones_(BonesNamed(skin_.bones)), anatomy_(anatomy) {}

ShoulderPose SkinOnBones::BindPose(Side side) const {
  for (const SkinBone& bone : SkinBonesOf({side})) {
    if (!BindOf(skin_, bone)) {
      throw std::invalid_argument("the skin does not hang on \"" + bone.name() + "\"");
    }
  }
  return girdle::BindPose(skin_, side).value();
}

double SkinOnBones::MisplacedBones_m(Side side) const {
  const ShoulderPose pose = BindPose(side);
  double largest_m = 0;
  for (std::size_t i = 0; i < bones_.size(); ++i) {
    if (bones_[i].segment == Segment::kThorax || bones_[i].side == side) {
      const BoneFrame wanted = FrameInThorax(anatomy_, pose, bones_[i]);
      largest_m = WorseOf(largest_m, glm::distance(skin_.bones[i].bind.p_TB_m, wanted.p_TB_m));
    }
  }
  return largest_m;
}

std::vector<Vector3> SkinOnBones::VerticesIn_m(const ShoulderPose& pose) const {
  std::vector<BoneFrame> frames;
  frames.reserve(bones_.size());
  for (const SkinBone& bone : bones_) {
    frames.push_back(FrameInThorax(anatomy_, pose, bone));
  }
  return BlendedVertices_m(skin_, frames);
}

SkinOnBones SkinOnBones::PartOf(const std::vector<int>& vertices) const {
  BoundSkin part;
  for (const int vertex : vertices) {
    part.surface.vertices_m.push_back(skin_.surface.vertices_m[static_cast<std::size_t>(vertex)]);
  }
  for (const BoundBone& bone : skin_.bones) {
    part.bones.push_back({bone.body, bone.bind, {}});
    for (const VertexWeight& share : bone.weights) {
      for (std::size_t i = 0; i < vertices.size(); ++i) {
        if (vertices[i] == share.vertex) {
          part.bones.back().weights.push_back({static_cast<int>(i), share.weight});
        }
      }
    }
  }
  return {std::move(part), anatomy_};
}

LandmarkSkin::LandmarkSkin(const SkinOnBones& skin, const SkinLandmarkVertices& vertices)
    : part_(skin.PartOf([&] {
        std::vector<int> all;
        for (const std::vector<int>& some : vertices) {
          all.insert(all.end(), some.begin(), some.end());
        }
        return all;
      }())) {
  std::transform(vertices.begin(), vertices.end(), counts_.begin(),
                 [](const std::vector<int>& some) { return some.size(); });
}

SkinLandmarkPlaces LandmarkSkin::In_m(const ShoulderPose& pose) const {
  const std::vector<Vector3> vertices_m = part_.VerticesIn_m(pose);
  SkinLandmarkPlaces places;
  auto next = vertices_m.begin();
  for (std::size_t k = 0; k < kSkinLandmarkCount; ++k) {
    const auto end = next + static_cast<std::ptrdiff_t>(counts_[k]);
    places[k] = std::accumulate(next, end, Vector3{0, 0, 0}) / static_cast<double>(counts_[k]);
    next = end;
  }
  return places;
}

Vector3 AcromionIn_m(const Anatomy& anatomy, const ShoulderPose& pose, Side side) {
  return OnSideInThorax_m(anatomy, pose, side, Segment::kScapula, AcromionTip_m(anatomy));
}

std::vector<std::size_t> TrianglesNear(const TriangleMesh& surface, const Vector3& point_m,
                                       double radius_m) {
  std::vector<std::size_t> near;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    Vector3 middle_m{0, 0, 0};
    for (const int corner : surface.triangles[i]) {
      middle_m += surface.vertices_m[static_cast<std::size_t>(corner)] / 3.0;
    }
    if (!(glm::distance(middle_m, point_m) > radius_m)) {
      near.push_back(i);
    }
  }
  return near;
}

AreaChange ChangeOfAreas(const TriangleMesh& surface, const std::vector<Vector3>& vertices_now_m,
                         const std::vector<std::size_t>& triangles) {
  struct Part {
    double ratio;
    double area_m2;  // before the movement
  };
  std::vector<Part> parts;
  double total_m2 = 0;
  double kept_m2 = 0;
  double squeezed_m2 = 0;
  for (const std::size_t i : triangles) {
    const Triangle& triangle = surface.triangles[i];
    const double first_m2 = Area_m2(surface.vertices_m, triangle);
    if (first_m2 == 0) {
      continue;
    }
    const double now_m2 = Area_m2(vertices_now_m, triangle);
    parts.push_back({now_m2 / first_m2, first_m2});
    total_m2 += first_m2;
    kept_m2 += now_m2;
    squeezed_m2 += now_m2 < first_m2 / 2 ? first_m2 : 0;
  }
  if (parts.empty()) {
    throw std::invalid_argument("no triangle with an area to look at");
  }
  if (std::isnan(kept_m2 / total_m2)) {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    return {kUnknown, kUnknown, kUnknown};
  }
  std::sort(parts.begin(), parts.end(),
            [](const Part& a, const Part& b) { return a.ratio < b.ratio; });
  constexpr double kFifth = 0.05;
  double below_m2 = 0;
  const auto fifth = std::find_if(parts.begin(), parts.end(), [&](const Part& part) {
    below_m2 += part.area_m2;
    return below_m2 >= kFifth * total_m2;
  });
  return {kept_m2 / total_m2, squeezed_m2 / total_m2, fifth->ratio};
}

LandmarkLargest LargestSteps_m(const LandmarkSkin& landmarks, const PoseFunction& pose,
                               const RhythmTable& table, const std::vector<double>& planes_rad) {
  const std::vector<double> elevations_rad =
      EvenSteps(table.elevations_rad().front(), table.elevations_rad().back());
  LandmarkLargest largest;
  for (const double plane_rad : planes_rad) {
    SkinLandmarkPlaces before_m = landmarks.In_m(pose({elevations_rad.front(), plane_rad}));
    for (std::size_t i = 1; i < elevations_rad.size(); ++i) {
      const ArmCommand command{elevations_rad[i], plane_rad};
      const SkinLandmarkPlaces now_m = landmarks.In_m(pose(command));
      for (std::size_t k = 0; k < kSkinLandmarkCount; ++k) {
        largest[k].Add(glm::distance(now_m[k], before_m[k]), command);
      }
      before_m = now_m;
    }
  }
  return largest;
}

LandmarkLargest LargestJumps_m_per_rad(const LandmarkFunction& landmarks, Direction direction,
                                       const std::vector<ArmCommand>& places,
                                       const SkinDifference& difference) {
  const SkinDifference backwards{difference.weights, -difference.step_rad};
  LandmarkLargest largest;
  for (const ArmCommand& place : places) {
    const SkinLandmarkPlaces origin_m = landmarks(place);
    const auto before = OneSidedVelocities(landmarks, direction, place, origin_m, backwards);
    const auto behind = OneSidedVelocities(landmarks, direction, place, origin_m, difference);
    for (std::size_t k = 0; k < kSkinLandmarkCount; ++k) {
      largest[k].Add(glm::distance(before[k], behind[k]), place);
    }
  }
  return largest;
}

LandmarkLargest LargestJumps_m_per_rad(const LandmarkSkin& landmarks, const PoseFunction& pose,
                                       const RhythmTable& table, Direction direction) {
  return LargestJumps_m_per_rad(
      [&](const ArmCommand& command) { return landmarks.In_m(pose(command)); }, direction,
      KnotCrossings(table, direction), {kOneSidedFirst, kOneSidedStep_rad});
}

LandmarkDepths LandmarkDepths_m(const SkinOnBones& skin, const ShoulderPose& pose, Side side) {
  const SurfaceDepth surface({skin.VerticesIn_m(pose), skin.bound().surface.triangles});
  const auto covers = [&skin](Side one) {
    return BindOf(skin.bound(), {Segment::kClavicle, one}).has_value();
  };
  const bool has_both = covers(Side::kRight) && covers(Side::kLeft);
  LandmarkDepths depths_m{};
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    const Vector3 point_m = OnSideInThorax_m(skin.anatomy(), pose, side, static_cast<Landmark>(i));
    depths_m[i] =
        surface.Depth_m(has_both && !kLandmarks[i].sided ? InMedianPlane(point_m) : point_m);
  }
  return depths_m;
}

}  // namespace girdle
