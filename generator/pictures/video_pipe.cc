// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "pictures/video_pipe.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "text/input_error.h"

namespace girdle {
namespace {

// In ffmpeg, the file that it writes.
constexpr int kOutput = 3;

// A descriptor that is closed with its scope.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) {
      close(number_);
    }
  }

  [[nodiscard]] int get() const noexcept { return number_; }
  int Release() noexcept { return std::exchange(number_, -1); }

 private:
  int number_;
};

[[noreturn]] void FailStarting(int error) {
  throw InputError("cannot start ffmpeg: " + std::string(std::strerror(error)));
}

// A file in memory.
int MemoryFile() {
  const int file = memfd_create("ffmpeg", MFD_CLOEXEC);
  if (file < 0) {
    FailStarting(errno);
  }
  return file;
}

std::string ContentOf(int file) {
  std::string text;
  std::array<char, 4096> buffer{};
  for (off_t at = 0;;) {
    const ssize_t size = pread(file, buffer.data(), buffer.size(), at);
    if (size <= 0) {
      return text;
    }
    text.append(buffer.data(), static_cast<std::size_t>(size));
    at += size;
  }
}

// Which descriptors a child has as its input, output, errors and kOutput; -1 for /dev/null, and for
// kOutput for none.
struct ChildFiles {
  int input = -1;
  int output = -1;
  int errors = -1;
  int video = -1;
};

// Returns a copy of an open file's descriptor, above kOutput; of -1, none.
Descriptor CopyAboveTargets(int file) {
  const int copy = file < 0 ? -1 : fcntl(file, F_DUPFD_CLOEXEC, kOutput + 1);
  if (copy < 0 && file >= 0) {
    FailStarting(errno);
  }
  return Descriptor(copy);
}

// A process that was started to ignore the ends of its children is never told how they ended.
void HearHowChildrenEnd() noexcept {
  struct sigaction action {};
  if (sigaction(SIGCHLD, nullptr, &action) == 0 && action.sa_handler == SIG_IGN) {
    std::signal(SIGCHLD, SIG_DFL);
  }
}

pid_t Start(const std::filesystem::path& program, std::vector<std::string> words,
            const ChildFiles& files) {
  HearHowChildrenEnd();
  // Copies above all targets, so that none is overwritten before it is in place. The child's own
  // are closed as it starts.
  const std::array<Descriptor, 4> sources = {
      CopyAboveTargets(files.input), CopyAboveTargets(files.output), CopyAboveTargets(files.errors),
      CopyAboveTargets(files.video)};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (int target = 0; target <= kOutput; ++target) {
    const int source = sources[static_cast<std::size_t>(target)].get();
    if (source >= 0) {
      posix_spawn_file_actions_adddup2(&actions, source, target);
    } else if (target != kOutput) {
      posix_spawn_file_actions_addopen(&actions, target, "/dev/null", O_RDWR, 0);
    }
  }
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);
  pid_t child = -1;
  const int error =
      posix_spawn(&child, program.c_str(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) {
    FailStarting(error);
  }
  return child;
}

int WaitFor(pid_t child) noexcept {
  constexpr int kUnknown = 127 << 8;  // of a child that somebody else has waited for
  int status = 0;
  pid_t ended = -1;
  do {
    ended = waitpid(child, &status, 0);
  } while (ended < 0 && errno == EINTR);
  return ended == child ? status : kUnknown;
}

// How it ended, or nothing if it has not after some time.
std::optional<int> WaitForAWhile(pid_t child, std::chrono::milliseconds longest) {
  constexpr std::chrono::milliseconds kStep(10);
  for (std::chrono::milliseconds waited(0);; waited += kStep) {
    int status = 0;
    const pid_t ended = waitpid(child, &status, WNOHANG);
    if (ended == child) {
      return status;
    }
    if ((ended < 0 && errno != EINTR) || waited >= longest) {
      return std::nullopt;
    }
    std::this_thread::sleep_for(kStep);
  }
}

// Its list of encoders has a line ` V....D libx264  ...` for each.
bool HasEncoder(const std::filesystem::path& ffmpeg, const std::string& name) {
  const Descriptor list(MemoryFile());
  const ChildFiles files{.output = list.get()};
  const int status =
      WaitFor(Start(ffmpeg, {"ffmpeg", "-hide_banner", "-loglevel", "error", "-encoders"}, files));
  return status == 0 && ContentOf(list.get()).find(" " + name + " ") != std::string::npos;
}

// The encoder with its options: pictures that one cannot tell from the frames.
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

std::string HowItEnded(int status) {
  return WIFSIGNALED(status) ? "it was ended: " + std::string(strsignal(WTERMSIG(status)))
                             : "it ended with status " + std::to_string(WEXITSTATUS(status));
}

// The last lines, on one.
std::string LastWords(const std::string& messages) {
  constexpr std::size_t kMost = 300;
  std::string words = messages.substr(messages.size() - std::min(messages.size(), kMost));
  std::replace(words.begin(), words.end(), '\n', ' ');
  return words.substr(0, words.find_last_not_of(' ') + 1);
}

}  // namespace

std::filesystem::path FindFfmpeg() {
  const char* const path = std::getenv("PATH");
  std::string folders = path == nullptr ? "" : path;
  while (!folders.empty()) {
    const std::size_t end = std::min(folders.find(':'), folders.size());
    std::filesystem::path file = std::filesystem::path(folders.substr(0, end)) / "ffmpeg";
    folders.erase(0, end + 1);
    std::error_code error;
    if (file.is_absolute() && std::filesystem::is_regular_file(file, error) &&
        access(file.c_str(), X_OK) == 0) {
      return file;
    }
  }
  return {};
}

VideoPipe::VideoPipe(int output, const PictureSize& size, int frames_per_s) : size_(size) {
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
  std::vector<std::string> words = {"ffmpeg",
                                    "-hide_banner",
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
  // By its name in /dev/fd, because the index goes to the front in a second pass that opens it
  // again. Without the encoder's version, so that the same frames give the same bytes.
  for (const char* word : {"-pix_fmt", "yuv420p", "-movflags", "+faststart", "-fflags", "+bitexact",
                           "-flags:v", "+bitexact", "-f", "mp4"}) {
    words.emplace_back(word);
  }
  words.push_back("/dev/fd/" + std::to_string(kOutput));

  Descriptor messages(MemoryFile());
  // A socket in place of a pipe: writing to one whose reader is gone can be told not to raise
  // SIGPIPE.
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    FailStarting(errno);
  }
  Descriptor ours(ends[0]);
  const Descriptor theirs(ends[1]);
  child_ = Start(ffmpeg, std::move(words),
                 {.input = theirs.get(), .errors = messages.get(), .video = output});
  frames_ = ours.Release();
  messages_ = messages.Release();
}

VideoPipe::~VideoPipe() {
  if (frames_ >= 0) {
    close(frames_);
  }
  if (child_ >= 0) {
    kill(child_, SIGKILL);
    Wait();
  }
  close(messages_);
}

int VideoPipe::Wait() noexcept { return WaitFor(std::exchange(child_, -1)); }

void VideoPipe::Fail(int status) const {
  const std::string words = LastWords(ContentOf(messages_));
  throw InputError("ffmpeg cannot make the video: " + (words.empty() ? HowItEnded(status) : words) +
                   ". See whether there is room on the disk, or install another one: apt-get "
                   "install ffmpeg");
}

void VideoPipe::FailAtItsEnd() {
  // For its last words.
  constexpr std::chrono::seconds kTimeToEnd(2);
  const std::optional<int> status = WaitForAWhile(child_, kTimeToEnd);
  if (status) {
    child_ = -1;
    Fail(*status);
  }
  kill(child_, SIGKILL);
  Wait();
  throw InputError(
      "ffmpeg cannot make the video: it reads no frames any more and does not end. Install another "
      "one: apt-get install ffmpeg");
}

void VideoPipe::Write(const Picture& frame) {
  if (!(frame.size == size_)) {
    throw InputError("a frame of another size than the video");
  }
  const std::uint8_t* at = frame.rgb.data();
  std::size_t left = frame.rgb.size();
  while (left > 0) {
    const ssize_t sent = send(frames_, at, left, MSG_NOSIGNAL);
    if (sent < 0 && errno != EINTR) {
      FailAtItsEnd();
    }
    at += sent < 0 ? 0 : sent;
    left -= sent < 0 ? 0 : static_cast<std::size_t>(sent);
  }
}

void VideoPipe::Finish() {
  close(std::exchange(frames_, -1));
  const int status = Wait();
  if (status != 0) {
    Fail(status);
  }
}

}  // namespace girdle
