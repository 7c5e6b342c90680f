// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The pictures that a simulation draws on its way: a video in real time and the last instant.
#pragma once

#include <optional>

#include "pictures/frame_renderer.h"
#include "pictures/picture.h"
#include "pictures/picture_request.h"
#include "pictures/video_pipe.h"
#include "simulation/shoulder_simulation.h"

namespace girdle {

/// Frame k of the video is the first state at or after k / frames_per_s seconds, so that it lasts
/// as long as what it shows; states farther apart than frames are shown more than once.
class SimulationPictures {
 public:
  /// Starts the renderer and ffmpeg, if they are needed. Throws InputError as they do. Simulation
  /// and request must outlive this.
  SimulationPictures(ShoulderSimulation& simulation, const PictureRequest& request);

  /// Draws the state that the simulation has derived last, at `time_s`, as often as a frame is due,
  /// and for the picture if it is the last one.
  void Add(double time_s, bool is_last);

  /// Waits for the video. Returns the number of its frames.
  long Finish();

 private:
  ShoulderSimulation& simulation_;
  const PictureRequest& request_;
  std::optional<FrameRenderer> renderer_;
  std::optional<VideoPipe> video_;
  long frames_ = 0;
};

}  // namespace girdle
