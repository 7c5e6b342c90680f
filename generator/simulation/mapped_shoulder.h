// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The bones of a shoulder in a model that is not ours, seen through a mapping.
#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "kinematics/rotation.h"
#include "simulation/model_mapping.h"

namespace girdle {

/// Bones in the thorax, as of a right shoulder: a left one is mirrored in the sagittal plane.
struct MappedPose {
  Quaternion q_TS;
  Quaternion q_TH;
  /// Only of a clavicle that is given by its body: landmarks do not tell its turn about its axis.
  std::optional<Quaternion> q_TC;
  /// Unit vector along the clavicle, to the side; nothing if the clavicle is not mapped.
  std::optional<Vector3> clavicle_axis_T;
  /// TS and AI from IJ [m]; nothing where one of the two landmarks is not mapped.
  std::array<std::optional<Vector3>, kGlidingLandmarks.size()> border_T_m;
  /// Distances of the landmarks of one frame from each other [m], always in the same order.
  std::vector<double> bone_lengths_m;
};

/// Finds the parts that a mapping names in a model and reads the bones from its state.
class MappedShoulder {
 public:
  /// `model` and `mapping` must outlive this. Throws InputError, with the mapping's file and line
  /// and the names that are near, if the model lacks a body or site.
  MappedShoulder(const mjModel& model, const ModelMapping& mapping);

  /// Returns the bones where MuJoCo's positions of bodies and sites have them.
  [[nodiscard]] MappedPose Observe(const mjData& data) const;

  /// Throws InputError if the bones as they stand cannot be those of a shoulder: landmarks of a
  /// frame nearly on a line, or not some centimetres apart, or a scapula that points to the other
  /// side than the mapping says.
  void ExpectSound(const mjData& data) const;

 private:
  [[nodiscard]] Vector3 Position(const mjData& data, Landmark landmark) const;
  [[nodiscard]] std::array<Vector3, 3> Triangle(const mjData& data, Segment segment) const;
  [[nodiscard]] Quaternion Frame(const mjData& data, Segment segment) const;
  [[nodiscard]] bool IsByLandmarks(Segment segment) const;
  /// Before which line of the mapping something is said of a landmark.
  [[nodiscard]] std::size_t LineOf(Landmark landmark) const;

  const ModelMapping& mapping_;
  std::array<int, kLandmarkCount> landmark_ids_{};  ///< of body or site, -1 where not mapped
  std::array<int, kSegmentCount> body_ids_{};       ///< -1 where not mapped
};

}  // namespace girdle
