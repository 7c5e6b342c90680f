// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The skin of a MuJoCo model: how it is bound, and where MuJoCo has its vertices.
#pragma once

#include <mujoco/mujoco.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "names/model_names.h"
#include "skin/bound_skin.h"
#include "skin/skin_landmarks.h"

namespace girdle {

/// Whether a model has a skin of the name kSkinName. One of another name is none of ours.
[[nodiscard]] bool HasSkin(const mjModel& model);

/// Returns the pose in which the skin named kSkinName is bound to one side's shoulder, as that of a
/// right one; nothing if the model has no such skin or the skin leaves one of its bones out.
[[nodiscard]] std::optional<ShoulderPose> BindPose(const mjModel& model, Side side);

/// The skin named kSkinName of a model, which must outlive it.
class ModelSkin {
 public:
  /// `model_name` stands in messages for the model. Throws InputError if the model has no such
  /// skin, or if it does not hang on the thorax.
  ModelSkin(const mjModel& model, std::string model_name);

  /// As it was bound, in the frame of the thorax then [m]. Bones have their bodies' names.
  [[nodiscard]] const BoundSkin& bound() const noexcept { return bound_; }

  /// Returns the vertices of one side's landmarks. Throws InputError that names the `<numeric>` if
  /// it is missing or holds a number of no vertex.
  [[nodiscard]] SkinLandmarkVertices Landmarks(Side side) const;

  /// Returns the frames in the world of the bodies that the skin hangs on, in the order of
  /// bound().bones: `data` holds derived positions.
  [[nodiscard]] std::vector<BoneFrame> BonesInWorld(const mjData& data) const;

  /// Returns the vertices in the world [m] as MuJoCo draws them, from the same positions. Needs no
  /// OpenGL. MuJoCo's function does not take `data` as constant; nothing of it changes.
  [[nodiscard]] std::vector<Vector3> VerticesInWorld_m(mjData& data) const;

 private:
  struct SceneDeleter {
    void operator()(mjvScene* scene) const noexcept;
  };

  const mjModel& model_;
  std::string model_name_;
  std::vector<int> bodies_;  ///< ids, of bound_.bones
  BoundSkin bound_;
  /// What MuJoCo writes the vertices to.
  std::unique_ptr<mjvScene, SceneDeleter> scene_;
};

}  // namespace girdle
