// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// What becomes of ffmpeg's child process. What a real one makes is looked at in
/// tests/python/test_command_line_pictures.py.
#include "pictures/video_pipe.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>

#include "text/input_error.h"

namespace girdle::video_pipe_test {
namespace {

constexpr PictureSize kSize = {64, 48};

// With a program of the test's own as the ffmpeg in PATH.
class VideoPipeTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = testing::TempDir() + "girdle_video_XXXXXX";
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
    path_ = getenv("PATH");
    output_ = open((folder_ / "video").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    ASSERT_GE(output_, 0);
  }
  void TearDown() override {
    setenv("PATH", path_.c_str(), 1);
    close(output_);
    std::filesystem::remove_all(folder_);
  }

  // `encode` is what it does with the frames; asked for its encoders it names `encoder`.
  void MakeFfmpeg(const std::string& encode, const std::string& encoder = "libx264") {
    const std::filesystem::path file = folder_ / "ffmpeg";
    std::ofstream(file) << "#!/bin/sh\nPATH=" << path_
                        << "\ncase \"$*\" in\n  *-encoders) echo ' V....D " << encoder
                        << "  one' ;;\n  *) " << encode << " ;;\nesac\n";
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    setenv("PATH", folder_.c_str(), 1);
  }

  [[nodiscard]] std::string Written() const {
    std::ifstream in(folder_ / "video", std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  static Picture Frame(char value) {
    return {kSize,
            std::vector<std::uint8_t>(std::size_t{3} * 64 * 48, static_cast<std::uint8_t>(value))};
  }

  static std::string Refusal(const std::function<void()>& work) {
    try {
      work();
    } catch (const InputError& error) {
      return error.what();
    }
    return "(nothing was thrown)";
  }

  // Whether this process has no child left, also none that has ended.
  static bool HasNoChild() { return waitpid(-1, nullptr, WNOHANG) < 0 && errno == ECHILD; }

  std::filesystem::path folder_;
  std::string path_;
  int output_ = -1;
};

TEST_F(VideoPipeTest, HandsOnEveryByteOfEveryFrameInOrder) {
  MakeFfmpeg("cat > /dev/fd/3");
  VideoPipe pipe(output_, kSize, 30);
  for (const char value : {'a', 'b', 'c'}) {
    pipe.Write(Frame(value));
  }
  pipe.Finish();
  const std::size_t frame = std::size_t{3} * 64 * 48;
  EXPECT_EQ(Written(), std::string(frame, 'a') + std::string(frame, 'b') + std::string(frame, 'c'));
  EXPECT_TRUE(HasNoChild());
}

TEST_F(VideoPipeTest, SaysSizeRateAndFormat) {
  MakeFfmpeg("cat > /dev/null; echo \"$*\" > /dev/fd/3");
  VideoPipe pipe(output_, kSize, 25);
  pipe.Write(Frame('a'));
  pipe.Finish();
  for (const char* words : {"-pixel_format rgb24 -video_size 64x48 -framerate 25 -i pipe:0",
                            "-c:v libx264", "-pix_fmt yuv420p", "-movflags +faststart"}) {
    EXPECT_NE(Written().find(words), std::string::npos) << words;
  }
}

TEST_F(VideoPipeTest, EncodesWithMpeg4WhereThereIsNoLibx264) {
  MakeFfmpeg("cat > /dev/null; echo \"$*\" > /dev/fd/3", "mpeg4");
  VideoPipe pipe(output_, kSize, 30);
  pipe.Finish();
  EXPECT_NE(Written().find("-c:v mpeg4"), std::string::npos);
}

TEST_F(VideoPipeTest, RefusesAnFfmpegThatHasNeither) {
  MakeFfmpeg("cat > /dev/null", "gif");
  EXPECT_EQ(Refusal([this] { VideoPipe(output_, kSize, 30); }),
            (folder_ / "ffmpeg").string() +
                ": has neither libx264 nor mpeg4 to encode a video with. Install another one: "
                "apt-get install ffmpeg");
  EXPECT_TRUE(HasNoChild());
}

TEST_F(VideoPipeTest, RefusesAMachineWithoutFfmpeg) {
  setenv("PATH", folder_.c_str(), 1);
  EXPECT_EQ(Refusal([this] { VideoPipe(output_, kSize, 30); }),
            "cannot make a video: no ffmpeg in PATH. Install it: apt-get install ffmpeg");
}

TEST_F(VideoPipeTest, DoesNotTakeAFileThatCannotBeRun) {
  std::ofstream(folder_ / "ffmpeg") << "not a program";
  setenv("PATH", folder_.c_str(), 1);
  EXPECT_EQ(FindFfmpeg(), "");
}

// It would end this process where SIGPIPE is not ignored.
TEST_F(VideoPipeTest, ReportsInItsOwnWordsAnFfmpegThatEndsInTheMiddle) {
  MakeFfmpeg("head -c 100 > /dev/null; echo 'no room' >&2; exit 1");
  VideoPipe pipe(output_, kSize, 30);
  EXPECT_EQ(Refusal([&pipe] {
              constexpr int kMoreThanAnyBuffer = 1000;
              for (int i = 0; i < kMoreThanAnyBuffer; ++i) {
                pipe.Write(Frame('a'));
              }
            }),
            "ffmpeg cannot make the video: no room. See whether there is room on the disk, or "
            "install another one: apt-get install ffmpeg");
  EXPECT_TRUE(HasNoChild());
}

TEST_F(VideoPipeTest, EndsAnFfmpegThatReadsNoFramesAnyMore) {
  MakeFfmpeg("exec < /dev/null; exec sleep 60");
  VideoPipe pipe(output_, kSize, 30);
  const auto started = std::chrono::steady_clock::now();
  EXPECT_EQ(Refusal([&pipe] {
              constexpr int kMoreThanAnyBuffer = 1000;
              for (int i = 0; i < kMoreThanAnyBuffer; ++i) {
                pipe.Write(Frame('a'));
              }
            }),
            "ffmpeg cannot make the video: it reads no frames any more and does not end. Install "
            "another one: apt-get install ffmpeg");
  EXPECT_LT(std::chrono::steady_clock::now() - started, std::chrono::seconds(30));
  EXPECT_TRUE(HasNoChild());
}

TEST_F(VideoPipeTest, ReportsAFailureToAProcessThatIgnoresItsChildren) {
  MakeFfmpeg("cat > /dev/null; echo half > /dev/fd/3; exit 1");
  const auto before = std::signal(SIGCHLD, SIG_IGN);
  const std::string refusal = Refusal([this] {
    VideoPipe pipe(output_, kSize, 30);
    pipe.Write(Frame('a'));
    pipe.Finish();
  });
  std::signal(SIGCHLD, before);
  EXPECT_NE(refusal.find("it ended with status 1"), std::string::npos) << refusal;
}

// Also those that the child has its own for: standard input, and that of the video.
class OutputDescriptor : public VideoPipeTest, public testing::WithParamInterface<int> {};

TEST_P(OutputDescriptor, MayBeAnyNumber) {
  MakeFfmpeg("cat > /dev/fd/3");
  const int number = GetParam();
  constexpr int kFarAway = 200;
  const int kept = fcntl(number, F_DUPFD_CLOEXEC, kFarAway);
  ASSERT_EQ(dup2(output_, number), number);
  {
    VideoPipe pipe(number, kSize, 30);
    pipe.Write(Frame('a'));
    pipe.Finish();
  }
  if (kept >= 0) {
    dup2(kept, number);
    close(kept);
  } else {
    close(number);
  }
  EXPECT_EQ(Written(), std::string(std::size_t{3} * 64 * 48, 'a'));
}

INSTANTIATE_TEST_SUITE_P(Numbers, OutputDescriptor, testing::Values(0, 3, 100));

TEST_F(VideoPipeTest, ReportsAnFfmpegThatFailsAtTheEnd) {
  MakeFfmpeg("cat > /dev/null; exit 7");
  VideoPipe pipe(output_, kSize, 30);
  pipe.Write(Frame('a'));
  EXPECT_EQ(Refusal([&pipe] { pipe.Finish(); }),
            "ffmpeg cannot make the video: it ended with status 7. See whether there is room on "
            "the disk, or install another one: apt-get install ffmpeg");
}

TEST_F(VideoPipeTest, EndsAnFfmpegThatIsNotFinished) {
  MakeFfmpeg("exec sleep 1000");
  { const VideoPipe pipe(output_, kSize, 30); }
  EXPECT_TRUE(HasNoChild());
}

TEST_F(VideoPipeTest, RefusesOddSizesWhichTheFormatDoesNotHave) {
  MakeFfmpeg("cat > /dev/null");
  EXPECT_EQ(Refusal([this] {
              VideoPipe(output_, {65, 48}, 30);
            }),
            "a video of 65x48 pixels: width and height have to be even, such as 640x480");
}

TEST_F(VideoPipeTest, RefusesRatesThatAreTooSlowOrTooFast) {
  MakeFfmpeg("cat > /dev/null");
  for (const int rate : {0, -1, 241}) {
    EXPECT_EQ(Refusal([&] { VideoPipe(output_, kSize, rate); }),
              "a video of " + std::to_string(rate) + " frames a second: expected 1 to 240");
  }
}

}  // namespace
}  // namespace girdle::video_pipe_test
