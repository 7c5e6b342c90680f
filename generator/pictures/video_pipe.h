// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Makes a video from pictures with the program ffmpeg.
#pragma once

#include <filesystem>
#include <memory>

#include "pictures/picture.h"

namespace girdle {

class ChildProgram;
struct ChildEnd;

/// Returns the path of ffmpeg in the folders of PATH; empty if there is none.
[[nodiscard]] std::filesystem::path FindFfmpeg();

/// A running ffmpeg that takes frames and writes an MP4 file.
///
/// The codec is H.264 if ffmpeg has libx264, else MPEG-4. Colours are yuv420p, which every player
/// takes and which needs an even width and height. The index is in front, so that a browser can
/// play the file while it loads. The destructor ends ffmpeg.
class VideoPipe {
 public:
  /// Starts ffmpeg, which writes to the open file `output` from its beginning. The file is not a
  /// complete video before Finish. Throws InputError if there is no ffmpeg, with the package to
  /// install, if it cannot encode MP4, if the size is odd, or if the rate is outside the limits of
  /// view.h.
  VideoPipe(int output, const PictureSize& size, int frames_per_s);
  VideoPipe(const VideoPipe&) = delete;
  VideoPipe& operator=(const VideoPipe&) = delete;
  ~VideoPipe();

  /// Passes a frame to ffmpeg. Throws InputError with ffmpeg's own words if ffmpeg has ended. If
  /// ffmpeg still runs but reads no more frames, it is ended and InputError is thrown.
  void Write(const Picture& frame);

  /// Ends the frames and waits until the file is complete. Throws InputError with ffmpeg's own
  /// words if ffmpeg fails.
  void Finish();

 private:
  /// Throws InputError with the text that ffmpeg wrote, or else with how it ended.
  [[noreturn]] void Fail(const ChildEnd& end) const;
  /// Throws InputError about an ffmpeg that reads no more frames. Waits for its end, and ends it if
  /// it does not end by itself.
  [[noreturn]] void FailAtItsEnd();

  PictureSize size_;
  std::unique_ptr<ChildProgram> ffmpeg_;
};

}  // namespace girdle
