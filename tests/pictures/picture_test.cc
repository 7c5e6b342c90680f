// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "pictures/picture.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <random>

namespace girdle::picture_test {
namespace {

using Paint = std::function<int(int x, int y, int colour)>;

// 0 to 255 of each colour of each pixel.
Picture Painted(const PictureSize& size, const Paint& paint) {
  Picture picture{size, {}};
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      for (int colour = 0; colour < 3; ++colour) {
        picture.rgb.push_back(static_cast<std::uint8_t>(paint(x, y, colour)));
      }
    }
  }
  return picture;
}

constexpr PictureSize kSize = {64, 48};

TEST(Picture, OfOneColourIsBlank) {
  EXPECT_EQ(FaultOf(Painted(kSize, [](int, int, int colour) { return 40 + 60 * colour; })),
            PictureFault::kBlank);
}

TEST(Picture, OfOneColourThatIsDitheredIsBlank) {
  EXPECT_EQ(FaultOf(Painted(kSize, [](int x, int y, int) { return 200 + (x + y) % 2; })),
            PictureFault::kBlank);
}

TEST(Picture, WithOneSmallThingInItIsFine) {
  const Paint dot = [](int x, int y, int) { return x / 3 == 10 && y / 3 == 8 ? 255 : 0; };
  EXPECT_EQ(FaultOf(Painted(kSize, dot)), std::nullopt);
}

TEST(Picture, OfUnrelatedPixelsIsNoise) {
  std::mt19937 random(20090815);
  std::uniform_int_distribution<int> value(0, 255);
  EXPECT_EQ(FaultOf(Painted(kSize, [&](int, int, int) { return value(random); })),
            PictureFault::kNoise);
}

TEST(Picture, OfUnrelatedPixelsIsNoiseAtTheSmallestSize) {
  std::mt19937 random(20090815);
  std::uniform_int_distribution<int> value(0, 255);
  EXPECT_EQ(FaultOf(Painted({kSmallestPicture, kSmallestPicture},
                            [&](int, int, int) { return value(random); })),
            PictureFault::kNoise);
}

TEST(Picture, OfSlowlyChangingColoursIsFine) {
  EXPECT_EQ(FaultOf(Painted(kSize, [](int x, int y, int colour) { return x + y + 20 * colour; })),
            std::nullopt);
}

TEST(Picture, OfFineStripesIsFine) {
  EXPECT_EQ(FaultOf(Painted(kSize, [](int x, int, int) { return x % 2 == 0 ? 0 : 255; })),
            std::nullopt);
  EXPECT_EQ(FaultOf(Painted(kSize, [](int, int y, int) { return y % 2 == 0 ? 0 : 255; })),
            std::nullopt);
}

TEST(Picture, WithNoiseInAFifthOfItIsFine) {
  std::mt19937 random(20090815);
  std::uniform_int_distribution<int> value(0, 255);
  const Paint part = [&](int x, int y, int) { return 5 * x > 64 ? x + y : value(random); };
  EXPECT_EQ(FaultOf(Painted(kSize, part)), std::nullopt);
}

}  // namespace
}  // namespace girdle::picture_test
