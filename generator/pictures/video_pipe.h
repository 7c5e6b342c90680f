// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Pictures to a video by way of the program ffmpeg.
#pragma once

#include <filesystem>
#include <memory>

#include "pictures/picture.h"

namespace girdle {

class ChildProgram;
struct ChildEnd;

/// Returns where PATH has ffmpeg, or an empty path.
[[nodiscard]] std::filesystem::path FindFfmpeg();

/// A running ffmpeg that takes frames and writes an MP4 file: H.264 where it has libx264, else
/// MPEG-4, with colours as every player takes them (yuv420p, which needs an even width and height)
/// and the index in front, so that a browser can play it while it loads. It is ended with this
/// object.
class VideoPipe {
 public:
  /// Starts ffmpeg, which writes to the open file `output` from its beginning; what is in it before
  /// Finish is no video yet. Throws InputError if there is no ffmpeg, with what to install, if it
  /// cannot encode MP4, or if the size is odd or the rate is not within the limits of
  /// view.h.
  VideoPipe(int output, const PictureSize& size, int frames_per_s);
  VideoPipe(const VideoPipe&) = delete;
  VideoPipe& operator=(const VideoPipe&) = delete;
  ~VideoPipe();

  /// Hands a frame on. Throws InputError with ffmpeg's own words if it has ended, and if it reads
  /// no frames any more but does not end, which ends it.
  void Write(const Picture& frame);

  /// Says that there are no more frames and waits for the file. Throws InputError with ffmpeg's own
  /// words if it fails.
  void Finish();

 private:
  /// Throws InputError with what it wrote, or else how it ended.
  [[noreturn]] void Fail(const ChildEnd& end) const;
  /// Throws InputError about an ffmpeg that reads no frames any more: waits for its end, or brings
  /// it about.
  [[noreturn]] void FailAtItsEnd();

  PictureSize size_;
  std::unique_ptr<ChildProgram> ffmpeg_;
};

}  // namespace girdle
