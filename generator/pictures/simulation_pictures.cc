// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "pictures/simulation_pictures.h"

#include "pictures/png_file.h"

namespace girdle {
namespace {

// Rounding of times, which are sums of steps.
constexpr double kRounding_s = 1e-9;

}  // namespace

SimulationPictures::SimulationPictures(ShoulderSimulation& simulation,
                                       const PictureRequest& request)
    : simulation_(simulation), request_(request) {
  if (request.png || request.video >= 0) {
    renderer_.emplace(simulation.model(), simulation.name(), request.view);
  }
  if (request.video >= 0) {
    video_.emplace(request.video, request.view.size, request.frames_per_s);
  }
}

void SimulationPictures::Add(double time_s, bool is_last) {
  const auto is_due = [&] {
    return video_ && static_cast<double>(frames_) / request_.frames_per_s <= time_s + kRounding_s;
  };
  const bool wants_png = is_last && request_.png;
  if (!is_due() && !wants_png) {
    return;
  }
  const Picture picture = renderer_->Draw(simulation_.data());
  for (; is_due(); ++frames_) {
    video_->Write(picture);
  }
  if (wants_png) {
    request_.png(PngBytes(picture));
  }
}

long SimulationPictures::Finish() {
  if (video_) {
    video_->Finish();
  }
  return frames_;
}

}  // namespace girdle
