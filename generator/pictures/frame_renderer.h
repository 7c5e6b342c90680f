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

/// Returns the names of a model's cameras, and the words of kCameraWords that none of them has.
[[nodiscard]] std::vector<std::string> CameraNames(const mjModel& model);

/// Draws states of one model as seen from one camera.
///
/// If the model has no camera named by a word of kCameraWords, a camera is made. It looks from that
/// side at all bodies, skins included, as they are at the start and in the keyframes.
///
/// Any number of renderers may exist at a time, in one thread. Each draws in its own OpenGL context
/// and makes it current first; otherwise MuJoCo would return another context's pixels. An
/// EngineWatch must outlive this object.
class FrameRenderer {
 public:
  /// `name` is the model's name in messages. Throws InputError if the view names an unknown camera,
  /// wants a skin of a model without one, or has a size outside the limits of view.h. Also throws
  /// if the model's <visual> has a number that cannot be drawn, or if this machine cannot draw it
  /// without a screen.
  FrameRenderer(const mjModel& model, std::string name, const View& view);
  FrameRenderer(const FrameRenderer&) = delete;
  FrameRenderer& operator=(const FrameRenderer&) = delete;
  ~FrameRenderer();

  /// Draws a state of the model, or of one with the same sizes. MuJoCo must have derived its
  /// positions (mj_fwdPosition or more). The state is not changed. Throws InputError if MuJoCo or
  /// OpenGL fails, or if the picture is blank or noise.
  [[nodiscard]] Picture Draw(mjData& data);

 private:
  struct SceneDeleter {
    void operator()(mjvScene* scene) const noexcept;
  };
  struct RendererDeleter {
    void operator()(mjrContext* renderer) const noexcept;
  };

  /// Throws InputError that OpenGL cannot draw the model for this reason.
  [[noreturn]] void FailDrawing(const std::string& reason) const;
  void AimFrom(std::size_t direction);
  void UpdateScene(mjData& data);
  void HideBones();
  void KeepSkinBetweenClipPlanes();

  std::string name_;
  View view_;
  Show show_;
  ModelPointer model_;  ///< a copy, with drawing buffers of the picture's size
  GlContext context_;
  mjvCamera camera_;
  mjvOption option_;
  std::unique_ptr<mjvScene, SceneDeleter> scene_;
  std::unique_ptr<mjrContext, RendererDeleter> renderer_;
};

}  // namespace girdle
