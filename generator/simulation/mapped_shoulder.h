// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The bones of a shoulder in a foreign model, found by a mapping.
#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/rotation.h"
#include "simulation/model_mapping.h"

namespace girdle {

/// Bones in the thorax, as a right shoulder. A left one is mirrored in the sagittal plane.
struct MappedPose {
  Quaternion q_TS;
  Quaternion q_TH;
  /// Present only if the mapping gives a body for the clavicle. Landmarks cannot show its turn
  /// about its axis.
  std::optional<Quaternion> q_TC;
  /// Unit vector along the clavicle, to the side; empty if the clavicle is not mapped.
  std::optional<Vector3> clavicle_axis_T;
  /// TS and AI from IJ [m]; empty if one of the two landmarks is not mapped.
  std::array<std::optional<Vector3>, kGlidingLandmarks.size()> border_T_m;
  /// Distances [m] between the landmarks of each frame, always in the same order.
  std::vector<double> bone_lengths_m;
};

/// Finds the parts of a model that a mapping names, and reads the bones from its state.
class MappedShoulder {
 public:
  /// `model` and `mapping` must outlive this object. Throws InputError if the model lacks a body or
  /// site. The message has the mapping's file and line and similar names.
  MappedShoulder(const mjModel& model, const ModelMapping& mapping);

  /// Returns the bones at MuJoCo's positions of bodies and sites.
  [[nodiscard]] MappedPose Observe(const mjData& data) const;

  /// Throws InputError if the bones in this state cannot be those of a shoulder. Faults are:
  /// landmarks of a frame nearly on a line; landmarks of a frame that are not some centimetres
  /// apart, but closer or farther; a scapula that points to the middle of the body.
  void ExpectSound(const mjData& data) const;

 private:
  [[nodiscard]] Vector3 Position(const mjData& data, Landmark landmark) const;
  [[nodiscard]] std::array<Vector3, 3> Triangle(const mjData& data, Segment segment) const;
  [[nodiscard]] Quaternion Frame(const mjData& data, Segment segment) const;
  [[nodiscard]] bool IsByLandmarks(Segment segment) const;
  /// The line of the mapping that messages about a landmark name.
  [[nodiscard]] std::size_t LineOf(Landmark landmark) const;

  const ModelMapping& mapping_;
  std::array<int, kLandmarkCount> landmark_ids_{};  ///< of body or site, -1 if not mapped
  std::array<int, kSegmentCount> body_ids_{};       ///< -1 if not mapped
};

}  // namespace girdle
