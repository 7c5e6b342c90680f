// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// What a moving girdle does to the skin over it.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "kinematics/knot_crossings.h"
#include "kinematics/pose_function.h"
#include "kinematics/shoulder_rhythm.h"
#include "kinematics/worst_case.h"
#include "skin/bound_skin.h"
#include "skin/skin_landmarks.h"

namespace girdle {

/// A skin on the bones of an anatomy. Everything is in the thorax frame (metres); both shoulders
/// are in the same pose, the left one in its mirror image.
class SkinOnBones {
 public:
  /// `skin` is given in the frame of its thorax. Throws std::invalid_argument that names the bone
  /// if one of the skin's is none of SkinBonesOf.
  SkinOnBones(BoundSkin skin, const Anatomy& anatomy);

  [[nodiscard]] const BoundSkin& bound() const noexcept { return skin_; }
  [[nodiscard]] const Anatomy& anatomy() const noexcept { return anatomy_; }

  /// Returns the pose in which the skin was bound to one side's bones. Throws std::invalid_argument
  /// that names the bone if it is not bound to one of them.
  [[nodiscard]] ShoulderPose BindPose(Side side) const;

  /// Returns how far [m] a side's bones were, when the skin was bound to them, from where the
  /// anatomy has them in that pose; the largest. Throws as BindPose.
  [[nodiscard]] double MisplacedBones_m(Side side) const;

  /// Returns the vertices [m] with the shoulders in a pose.
  [[nodiscard]] std::vector<Vector3> VerticesIn_m(const ShoulderPose& pose) const;

  /// Returns the skin of some vertices alone, in their order, without triangles.
  [[nodiscard]] SkinOnBones PartOf(const std::vector<int>& vertices) const;

 private:
  BoundSkin skin_;
  std::vector<SkinBone> bones_;  ///< of skin_.bones
  Anatomy anatomy_;
};

/// Places [m] of the skin's landmarks in the order of kSkinLandmarkNames, thorax frame.
using SkinLandmarkPlaces = std::array<Vector3, kSkinLandmarkCount>;

/// Returns whether a landmark, counted as in kSkinLandmarkNames, is of the skin over the AC joint:
/// that over its centre and that over the acromion's tip.
[[nodiscard]] constexpr bool IsAcSkin(std::size_t landmark) noexcept {
  return kSkinLandmarkNames[landmark] == kSkinAcName ||
         kSkinLandmarkNames[landmark] == kSkinAcromionName;
}

/// The landmarks of one side's skin, without the rest of it.
class LandmarkSkin {
 public:
  /// Precondition: the vertices are of the skin, one or more for each landmark.
  LandmarkSkin(const SkinOnBones& skin, const SkinLandmarkVertices& vertices);

  /// Returns where they are in a pose: each the mean of its vertices.
  [[nodiscard]] SkinLandmarkPlaces In_m(const ShoulderPose& pose) const;

 private:
  SkinOnBones part_;
  std::array<std::size_t, kSkinLandmarkCount> counts_{};  ///< of vertices of each, in their order
};

/// Returns where the tip of a side's acromion, the bone, is in a pose [m].
[[nodiscard]] Vector3 AcromionIn_m(const Anatomy& anatomy, const ShoulderPose& pose, Side side);

/// Returns the numbers of the triangles whose middle is within a distance [m] of a point, or is not
/// known because a corner is no number.
[[nodiscard]] std::vector<std::size_t> TrianglesNear(const TriangleMesh& surface,
                                                     const Vector3& point_m, double radius_m);

/// What became of triangles' areas; shares of their area at first, which weighs them.
struct AreaChange {
  double kept = 0;              ///< area now
  double below_half = 0;        ///< what is now less than half as large
  double fifth_percentile = 0;  ///< of area now over area at first
};

/// Returns the change of some triangles of a surface whose vertices are elsewhere now; NaN if the
/// area of one of them is no number. Throws std::invalid_argument if they have no area.
[[nodiscard]] AreaChange ChangeOfAreas(const TriangleMesh& surface,
                                       const std::vector<Vector3>& vertices_now_m,
                                       const std::vector<std::size_t>& triangles);

/// Each landmark's largest value, and the command where it is.
using LandmarkLargest = std::array<WorstCase<ArmCommand>, kSkinLandmarkCount>;

/// Returns how far [m] landmarks move at most while the elevation rises by a degree, in the planes
/// given, within the table's elevations.
[[nodiscard]] LandmarkLargest LargestSteps_m(const LandmarkSkin& landmarks,
                                             const PoseFunction& pose, const RhythmTable& table,
                                             const std::vector<double>& planes_rad);

/// Where the landmarks are for a command.
using LandmarkFunction = std::function<SkinLandmarkPlaces(const ArmCommand& command)>;

/// How velocities on one side of a place are taken: from so many values, a step apart
/// (kinematics/one_sided_difference.h).
struct SkinDifference {
  std::span<const double> weights;
  double step_rad;
};

/// Returns by how much [m/rad] landmarks' velocities, with respect to what is moved along the
/// direction, jump at most over some places.
[[nodiscard]] LandmarkLargest LargestJumps_m_per_rad(const LandmarkFunction& landmarks,
                                                     Direction direction,
                                                     const std::vector<ArmCommand>& places,
                                                     const SkinDifference& difference);

/// Returns by how much [m/rad] landmarks' velocities, with respect to what is moved along the
/// direction, jump at most over the table's inner knot lines: one-sided differences before and
/// behind (kinematics/one_sided_difference.h).
[[nodiscard]] LandmarkLargest LargestJumps_m_per_rad(const LandmarkSkin& landmarks,
                                                     const PoseFunction& pose,
                                                     const RhythmTable& table, Direction direction);

/// How deep a side's bony landmarks lie under a surface [m], in the order of Landmark.
using LandmarkDepths = std::array<double, kLandmarkCount>;

/// Returns the depths with the skin's vertices and the bones in a pose. Those of the thorax lie in
/// the median plane if the skin covers both shoulders. Where skin runs through itself, an elbow in
/// the belly or one arm in the other, the nearest sheet counts although it is no outside: a bone is
/// then deeper than this says.
[[nodiscard]] LandmarkDepths LandmarkDepths_m(const SkinOnBones& skin, const ShoulderPose& pose,
                                              Side side);

}  // namespace girdle
