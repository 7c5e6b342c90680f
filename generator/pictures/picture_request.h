// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The picture and the video of a simulation.
#pragma once

#include "pictures/view.h"
#include "text/sinks.h"

namespace girdle {

/// Pictures that a simulation draws.
struct PictureRequest {
  View view;
  TextSink png;    ///< receives a PNG file of the last instant; null for none
  int video = -1;  ///< open file that receives a video in real time, an MP4; -1 for none
  int frames_per_s = 30;
};

}  // namespace girdle
