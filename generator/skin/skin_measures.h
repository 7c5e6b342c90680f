// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Measures of the effect that a moving girdle has on the skin over it.
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

/// A skin on the bones of an anatomy. Everything is in the thorax frame (metres). Both shoulders
/// are in the same pose, the left one in its mirror image.
class SkinOnBones {
 public:
  /// `skin` is in the frame of its thorax. Throws std::invalid_argument with the bone's name if a
  /// bone of the skin is not one of SkinBonesOf.
  SkinOnBones(BoundSkin skin, const Anatomy& anatomy);

  [[nodiscard]] const BoundSkin& bound() const noexcept { return skin_; }
  [[nodiscard]] const Anatomy& anatomy() const noexcept { return anatomy_; }

  /// Returns the pose in which the skin was bound to one side's bones. Throws std::invalid_argument
  /// with the bone's name if the skin is not bound to one of them.
  [[nodiscard]] ShoulderPose BindPose(Side side) const;

  /// Returns the largest distance [m] between a bone of one side when the skin was bound to it and
  /// the anatomy's bone in that pose. Throws like BindPose.
  [[nodiscard]] double MisplacedBones_m(Side side) const;

  /// Returns the vertices [m] if the shoulders are in a pose.
  [[nodiscard]] std::vector<Vector3> VerticesIn_m(const ShoulderPose& pose) const;

  /// Returns the skin of some vertices only, in their order, without triangles.
  [[nodiscard]] SkinOnBones PartOf(const std::vector<int>& vertices) const;

 private:
  BoundSkin skin_;
  std::vector<SkinBone> bones_;  ///< of skin_.bones
  Anatomy anatomy_;
};

/// Positions [m] of the skin's landmarks in the thorax frame, in the order of kSkinLandmarkNames.
using SkinLandmarkPlaces = std::array<Vector3, kSkinLandmarkCount>;

/// Returns whether a landmark belongs to the skin over the AC joint: over its centre or over the
/// acromion's tip. `landmark` is an index into kSkinLandmarkNames.
[[nodiscard]] constexpr bool IsAcSkin(std::size_t landmark) noexcept {
  return kSkinLandmarkNames[landmark] == kSkinAcName ||
         kSkinLandmarkNames[landmark] == kSkinAcromionName;
}

/// The landmarks of one side's skin, without the rest of it.
class LandmarkSkin {
 public:
  /// Precondition: `vertices` are vertices of the skin, at least one for each landmark.
  LandmarkSkin(const SkinOnBones& skin, const SkinLandmarkVertices& vertices);

  /// Returns the landmarks' positions in a pose. Each is the mean of its vertices.
  [[nodiscard]] SkinLandmarkPlaces In_m(const ShoulderPose& pose) const;

 private:
  SkinOnBones part_;
  std::array<std::size_t, kSkinLandmarkCount> counts_{};  ///< number of vertices of each landmark
};

/// Returns the position [m] of the tip of one side's acromion, the bone, in a pose.
[[nodiscard]] Vector3 AcromionIn_m(const Anatomy& anatomy, const ShoulderPose& pose, Side side);

/// Returns the indices of triangles whose middle is within `radius_m` of a point. A triangle with a
/// corner that is NaN is included.
[[nodiscard]] std::vector<std::size_t> TrianglesNear(const TriangleMesh& surface,
                                                     const Vector3& point_m, double radius_m);

/// How the areas of triangles changed. Shares are relative to the original area, by which triangles
/// are weighted.
struct AreaChange {
  double kept = 0;              ///< present area
  double below_half = 0;        ///< share of triangles with less than half their original area
  double fifth_percentile = 0;  ///< of present area over original area
};

/// Returns the change of some triangles of a surface whose vertices have moved. NaN if the area of
/// one of them is NaN. Throws std::invalid_argument if they have no area.
[[nodiscard]] AreaChange ChangeOfAreas(const TriangleMesh& surface,
                                       const std::vector<Vector3>& vertices_now_m,
                                       const std::vector<std::size_t>& triangles);

/// The largest value of each landmark, and the command where it occurs.
using LandmarkLargest = std::array<WorstCase<ArmCommand>, kSkinLandmarkCount>;

/// Returns the largest movement [m] of landmarks while the elevation rises by a degree, in the
/// given planes, within the table's elevations.
[[nodiscard]] LandmarkLargest LargestSteps_m(const LandmarkSkin& landmarks,
                                             const PoseFunction& pose, const RhythmTable& table,
                                             const std::vector<double>& planes_rad);

/// Returns the landmarks' positions for a command.
using LandmarkFunction = std::function<SkinLandmarkPlaces(const ArmCommand& command)>;

/// One-sided differences that give velocities on one side of a place
/// (kinematics/one_sided_difference.h): the weights of successive values, and the step between
/// these.
struct SkinDifference {
  std::span<const double> weights;
  double step_rad;
};

/// Returns the largest jumps [m/rad] of landmarks' velocities over some places. Velocities are
/// derivatives by the command along the direction.
[[nodiscard]] LandmarkLargest LargestJumps_m_per_rad(const LandmarkFunction& landmarks,
                                                     Direction direction,
                                                     const std::vector<ArmCommand>& places,
                                                     const SkinDifference& difference);

/// Returns the largest jumps [m/rad] of landmarks' velocities over the table's inner knot lines.
/// Velocities are derivatives by the command along the direction, from one-sided differences before
/// and behind a line (kinematics/one_sided_difference.h).
[[nodiscard]] LandmarkLargest LargestJumps_m_per_rad(const LandmarkSkin& landmarks,
                                                     const PoseFunction& pose,
                                                     const RhythmTable& table, Direction direction);

/// Depths [m] of one side's bony landmarks under a surface, in the order of Landmark.
using LandmarkDepths = std::array<double, kLandmarkCount>;

/// Returns the depths with the skin and the bones in a pose. If the skin covers both shoulders,
/// landmarks of the thorax are in the median plane. Where skin intersects itself (an elbow in the
/// belly, one arm in the other), the nearest sheet counts although it is not an outside. A bone is
/// then deeper than the result.
[[nodiscard]] LandmarkDepths LandmarkDepths_m(const SkinOnBones& skin, const ShoulderPose& pose,
                                              Side side);

}  // namespace girdle
