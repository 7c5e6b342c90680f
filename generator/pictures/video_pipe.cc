// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "pictures/video_pipe.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>
#include <vector>

#include "child_programs/child_program.h"
#include "child_programs/memory_file.h"
#include "child_programs/program_search.h"
#include "text/input_error.h"

namespace girdle {
namespace {

// Whether ffmpeg's list of encoders has this one, in a line such as ` V....D libx264  ...`.
bool HasEncoder(const std::filesystem::path& ffmpeg, const std::string& name) {
  const MemoryFile list("encoders");
  ChildProgram encoder_list(ffmpeg, {"-hide_banner", "-loglevel", "error", "-encoders"},
                            {.output = list.descriptor()});
  encoder_list.EndInput();
  return encoder_list.Wait().is_fine() &&
         list.Content().find(" " + name + " ") != std::string::npos;
}

// Returns the encoder with its options. The video cannot be told from the frames by eye.
std::vector<std::string> EncoderOptions(const std::filesystem::path& ffmpeg) {
  if (HasEncoder(ffmpeg, "libx264")) {
    return {"-c:v", "libx264", "-crf", "18", "-preset", "medium"};
  }
  if (HasEncoder(ffmpeg, "mpeg4")) {
    return {"-c:v", "mpeg4", "-q:v", "2"};
  }
  throw InputError(ffmpeg.string() +
                   ": has neither libx264 nor mpeg4 to encode a video with. Install another one: "
                   "apt-get install ffmpeg");
}

// Returns the last lines on one line.
std::string LastWords(const std::string& messages) {
  constexpr std::size_t kMost = 300;
  std::string words = messages.substr(messages.size() - std::min(messages.size(), kMost));
  std::replace(words.begin(), words.end(), '\n', ' ');
  return words.substr(0, words.find_last_not_of(' ') + 1);
}

// Returns ffmpeg's arguments. Frames come from standard input; the video goes to kExtraDescriptor.
std::vector<std::string> Arguments(const std::filesystem::path& ffmpeg, const PictureSize& size,
                                   int frames_per_s) {
  std::vector<std::string> words = {"-hide_banner",
                                    "-loglevel",
                                    "error",
                                    "-nostdin",
                                    "-y",
                                    "-f",
                                    "rawvideo",
                                    "-pixel_format",
                                    "rgb24",
                                    "-video_size",
                                    std::to_string(size.width) + "x" + std::to_string(size.height),
                                    "-framerate",
                                    std::to_string(frames_per_s),
                                    "-i",
                                    "pipe:0",
                                    "-an"};
  for (std::string& word : EncoderOptions(ffmpeg)) {
    words.push_back(std::move(word));
  }
  // Encoders share a frame out among their threads, by default one or more for each processor. A
  // fixed number gives equal frames equal bytes on any machine.
  words.insert(words.end(), {"-threads", "4"});
  // The output is named in /dev/fd, because a second pass opens it again to move the index to the
  // front. The encoder's version is left out, so that it does not change the bytes either.
  for (const char* word : {"-pix_fmt", "yuv420p", "-movflags", "+faststart", "-fflags", "+bitexact",
                           "-flags:v", "+bitexact", "-f", "mp4"}) {
    words.emplace_back(word);
  }
  words.push_back("/dev/fd/" + std::to_string(kExtraDescriptor));
  return words;
}

// Starts ffmpeg, which writes to `output`.
std::unique_ptr<ChildProgram> Started(int output, const PictureSize& size, int frames_per_s) {
  if (size.width % 2 != 0 || size.height % 2 != 0) {
    throw InputError("a video of " + std::to_string(size.width) + "x" +
                     std::to_string(size.height) +
                     " pixels: width and height have to be even, such as 640x480");
  }
  if (frames_per_s < kSlowestVideo_per_s || frames_per_s > kFastestVideo_per_s) {
    throw InputError("a video of " + std::to_string(frames_per_s) + " frames a second: expected " +
                     std::to_string(kSlowestVideo_per_s) + " to " +
                     std::to_string(kFastestVideo_per_s));
  }
  const std::filesystem::path ffmpeg = FindFfmpeg();
  if (ffmpeg.empty()) {
    throw InputError("cannot make a video: no ffmpeg in PATH. Install it: apt-get install ffmpeg");
  }
  return std::make_unique<ChildProgram>(ffmpeg, Arguments(ffmpeg, size, frames_per_s),
                                        ProgramFiles{.extra = output});
}

}  // namespace

std::filesystem::path FindFfmpeg() { return FindProgram("ffmpeg"); }

VideoPipe::VideoPipe(int output, const PictureSize& size, int frames_per_s)
    : size_(size), ffmpeg_(Started(output, size, frames_per_s)) {}

VideoPipe::~VideoPipe() = default;

void VideoPipe::Fail(const ChildEnd& end) const {
  const std::string words = LastWords(ffmpeg_->Errors());
  throw InputError("ffmpeg cannot make the video: " + (words.empty() ? "it " + end.text() : words) +
                   ". See whether there is room on the disk, or install another one: apt-get "
                   "install ffmpeg");
}

void VideoPipe::FailAtItsEnd() {
  // Time for ffmpeg to write its last messages.
  constexpr std::chrono::seconds kTimeToEnd(2);
  if (const std::optional<ChildEnd> end = ffmpeg_->Wait(kTimeToEnd)) {
    Fail(*end);
  }
  ffmpeg_->End();
  throw InputError(
      "ffmpeg cannot make the video: it reads no frames any more and does not end. Install another "
      "one: apt-get install ffmpeg");
}

void VideoPipe::Write(const Picture& frame) {
  if (!(frame.size == size_)) {
    throw InputError("a frame of another size than the video");
  }
  if (!ffmpeg_->Write(frame.rgb)) {
    FailAtItsEnd();
  }
}

void VideoPipe::Finish() {
  ffmpeg_->EndInput();
  const ChildEnd end = ffmpeg_->Wait();
  if (!end.is_fine()) {
    Fail(end);
  }
}

}  // namespace girdle
