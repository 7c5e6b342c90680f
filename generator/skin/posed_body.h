// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// A body's surface and the bones that stand in it: what a skin is made of.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "anatomy/anatomy.h"
#include "anatomy/triangle_mesh.h"
#include "kinematics/shoulder_pose.h"
#include "names/model_names.h"

namespace girdle {

/// A person standing still. The surface is in the thorax frame (ISB: origin IJ, x anterior, y up, z
/// right; metres), and so are the bones: those of the right shoulder in `pose`, those of the left
/// one mirrored in the plane z = 0.
struct PosedBody {
  TriangleMesh surface;
  Anatomy anatomy;
  ShoulderPose pose;
};

/// A bone that skin can hang on. The thorax has no side.
struct SkinBone {
  Segment segment = Segment::kThorax;
  Side side = Side::kRight;  ///< no meaning for the thorax

  /// Of the body in emitted models: `thorax`, `scapula_r`.
  [[nodiscard]] std::string name() const;
};

/// Returns the bones of a model with these shoulders: the thorax, then clavicle, scapula and
/// humerus of each side.
[[nodiscard]] std::vector<SkinBone> SkinBonesOf(const std::vector<Side>& sides);

/// Where a bone's frame is in the thorax.
struct BoneFrame {
  Quaternion q_TB{1, 0, 0, 0};
  Vector3 p_TB_m{0, 0, 0};
};

/// Returns a bone's frame when the shoulder of its side is in `pose` (a left one in its mirror
/// image).
[[nodiscard]] BoneFrame FrameInThorax(const Anatomy& anatomy, const ShoulderPose& pose,
                                      const SkinBone& bone) noexcept;

/// Returns a point of a right shoulder's segment, given in the segment's frame, in the thorax frame
/// for the shoulder of `side` [m].
[[nodiscard]] Vector3 OnSideInThorax_m(const Anatomy& anatomy, const ShoulderPose& pose, Side side,
                                       Segment segment, const Vector3& point_m) noexcept;
/// Returns a landmark of the shoulder of `side` in the thorax frame [m].
[[nodiscard]] Vector3 OnSideInThorax_m(const Anatomy& anatomy, const ShoulderPose& pose, Side side,
                                       Landmark landmark) noexcept;

/// Returns the tip of the acromion, scapula frame [m]: its front outer corner, beside and before
/// the AC joint's centre, above the head of the humerus. No landmark of the ISB; put an acromion's
/// length, some 5 cm, from the acromial angle (AA), after textbook figures. It grows with the
/// scapula.
[[nodiscard]] Vector3 AcromionTip_m(const Anatomy& anatomy) noexcept;

}  // namespace girdle
