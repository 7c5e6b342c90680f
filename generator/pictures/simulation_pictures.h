// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The pictures that a simulation draws while it runs: a video in real time, and the last instant.
#pragma once

#include <optional>

#include "pictures/frame_renderer.h"
#include "pictures/picture.h"
#include "pictures/picture_request.h"
#include "pictures/video_pipe.h"
#include "simulation/shoulder_simulation.h"

namespace girdle {

/// Frame k of the video is the first state at or after k / frames_per_s seconds, so that the video
/// lasts as long as the simulated time. A state is shown more than once if states are farther apart
/// than frames.
class SimulationPictures {
 public:
  /// Starts the renderer and ffmpeg if they are needed. Throws InputError as FrameRenderer and
  /// VideoPipe do. Simulation and request must outlive this.
  SimulationPictures(ShoulderSimulation& simulation, const PictureRequest& request);

  /// Draws the state that the simulation derived last, at `time_s`: once for each frame that is
  /// due, and for the picture if `is_last`.
  void Add(double time_s, bool is_last);

  /// Waits until the video is complete. Returns the number of its frames.
  long Finish();

 private:
  ShoulderSimulation& simulation_;
  const PictureRequest& request_;
  std::optional<FrameRenderer> renderer_;
  std::optional<VideoPipe> video_;
  long frames_ = 0;
};

}  // namespace girdle
