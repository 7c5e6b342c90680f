// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The skin of a MuJoCo model: its bind pose, and its vertices as MuJoCo computes them.
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

/// Returns whether a model has a skin with the name kSkinName. Skins with other names are not
/// Girdle's.
[[nodiscard]] bool HasSkin(const mjModel& model);

/// Returns the pose in which the skin named kSkinName is bound to the shoulder of one side, as that
/// of a right shoulder. Returns nothing if the model has no such skin or if the skin does not use
/// all bones of that shoulder.
[[nodiscard]] std::optional<ShoulderPose> BindPose(const mjModel& model, Side side);

/// The skin named kSkinName of a model. The model must outlive this object.
class ModelSkin {
 public:
  /// `model_name` is the model's name in messages. Throws InputError if the model has no such skin
  /// or if the skin is not bound to the thorax.
  ModelSkin(const mjModel& model, std::string model_name);

  /// The skin as it was bound [m], in the frame that the thorax had then. Bones have the names of
  /// their bodies.
  [[nodiscard]] const BoundSkin& bound() const noexcept { return bound_; }

  /// Returns the vertices of one side's landmarks. Throws InputError with the name of the
  /// `<numeric>` if it is missing or contains an index without a vertex.
  [[nodiscard]] SkinLandmarkVertices Landmarks(Side side) const;

  /// Returns the frames in the world of the bodies that the skin is bound to, in the order of
  /// bound().bones. Precondition: `data` has derived positions.
  [[nodiscard]] std::vector<BoneFrame> BonesInWorld(const mjData& data) const;

  /// Returns the vertices in the world [m] as MuJoCo draws them. Precondition: `data` has derived
  /// positions. Needs no OpenGL. MuJoCo's function takes `data` as not constant, but does not
  /// change it.
  [[nodiscard]] std::vector<Vector3> VerticesInWorld_m(mjData& data) const;

 private:
  struct SceneDeleter {
    void operator()(mjvScene* scene) const noexcept;
  };

  const mjModel& model_;
  std::string model_name_;
  std::vector<int> bodies_;  ///< ids of the bodies of bound_.bones
  BoundSkin bound_;
  /// The scene into which MuJoCo writes the vertices.
  std::unique_ptr<mjvScene, SceneDeleter> scene_;
};

}  // namespace girdle
