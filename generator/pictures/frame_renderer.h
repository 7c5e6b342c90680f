// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Pictures of a model, drawn by MuJoCo without a screen.
#pragma once

#include <mujoco/mujoco.h>

#include <memory>
#include <string>
#include <vector>

#include "pictures/gl_context.h"
#include "pictures/picture.h"
#include "pictures/view.h"
#include "simulation/engine.h"

namespace girdle {

/// The cameras of a model by name, and the words of kCameraWords that it does not have itself.
[[nodiscard]] std::vector<std::string> CameraNames(const mjModel& model);

/// Draws states of one model from one place.
///
/// A word of kCameraWords is the model's own camera of that name, or else one that looks from there
/// at all bodies as they stand at the start and in the keyframes, skins included. Any number of
/// renderers may live at a time, in one thread: each draws in an OpenGL context of its own and
/// makes it current first, without which MuJoCo would return another's memory. An EngineWatch has
/// to live longer than this.
class FrameRenderer {
 public:
  /// `name` stands in messages for the model. Throws InputError if the view names a camera that
  /// there is not, wants a skin of a model that has none, is smaller or larger than view.h says, or
  /// if nothing here draws without a screen.
  FrameRenderer(const mjModel& model, std::string name, const View& view);
  FrameRenderer(const FrameRenderer&) = delete;
  FrameRenderer& operator=(const FrameRenderer&) = delete;
  ~FrameRenderer();

  /// Draws a state of the model, or of one with the same sizes, whose positions MuJoCo has derived
  /// (mj_fwdPosition or more). It is not changed. Throws InputError if MuJoCo or OpenGL fails, or
  /// if the picture is blank or noise.
  [[nodiscard]] Picture Draw(mjData& data);

 private:
  struct SceneDeleter {
    void operator()(mjvScene* scene) const noexcept;
  };
  struct RendererDeleter {
    void operator()(mjrContext* renderer) const noexcept;
  };

  void AimFrom(std::size_t direction);
  void UpdateScene(mjData& data);
  void HideBones();
  void KeepSkinBetweenClipPlanes();

  std::string name_;
  View view_;
  Show show_;
  ModelPointer model_;  ///< a copy, with buffers of the picture's size
  GlContext context_;
  mjvCamera camera_;
  mjvOption option_;
  std::unique_ptr<mjvScene, SceneDeleter> scene_;
  std::unique_ptr<mjrContext, RendererDeleter> renderer_;
};

}  // namespace girdle
