// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// A body's surface and the bones in it, from which a skin is made.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "anatomy/anatomy.h"
#include "anatomy/triangle_mesh.h"
#include "kinematics/shoulder_pose.h"
#include "names/model_names.h"

namespace girdle {

/// A person standing still. Surface and bones are in the thorax frame (ISB: origin IJ, x anterior,
/// y up, z right; metres). The right shoulder is in `pose`. The left shoulder is its mirror image
/// in the plane z = 0.
struct PosedBody {
  TriangleMesh surface;
  Anatomy anatomy;
  ShoulderPose pose;
};

/// A bone that skin can be bound to. The thorax has no side.
struct SkinBone {
  Segment segment = Segment::kThorax;
  Side side = Side::kRight;  ///< no meaning for the thorax

  /// Name of the bone's body in emitted models: `thorax`, `scapula_r`.
  [[nodiscard]] std::string name() const;
};

/// Returns the bones of a model with shoulders on these sides: the thorax, then clavicle, scapula
/// and humerus of each side.
[[nodiscard]] std::vector<SkinBone> SkinBonesOf(const std::vector<Side>& sides);

/// The frame B of a bone in the thorax.
struct BoneFrame {
  Quaternion q_TB{1, 0, 0, 0};
  Vector3 p_TB_m{0, 0, 0};
};

/// Returns a bone's frame if the shoulder of its side is in `pose`. A left shoulder is in the
/// mirror image of the pose.
[[nodiscard]] BoneFrame FrameInThorax(const Anatomy& anatomy, const ShoulderPose& pose,
                                      const SkinBone& bone) noexcept;

/// Returns a point [m] in the thorax frame. `point_m` is in the frame of a right shoulder's
/// segment; for the left side the result is mirrored.
[[nodiscard]] Vector3 OnSideInThorax_m(const Anatomy& anatomy, const ShoulderPose& pose, Side side,
                                       Segment segment, const Vector3& point_m) noexcept;
/// Returns a landmark of the shoulder of `side` in the thorax frame [m].
[[nodiscard]] Vector3 OnSideInThorax_m(const Anatomy& anatomy, const ShoulderPose& pose, Side side,
                                       Landmark landmark) noexcept;

/// Returns the tip of the acromion [m], scapula frame. It is the front outer corner of the
/// acromion, lateral and anterior to the AC joint's centre, above the head of the humerus. The ISB
/// has no such landmark. It is placed an acromion's length, some 5 cm, from the acromial angle
/// (AA), after textbook figures. It is scaled with the scapula.
[[nodiscard]] Vector3 AcromionTip_m(const Anatomy& anatomy) noexcept;

}  // namespace girdle
