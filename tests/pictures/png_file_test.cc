// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "pictures/png_file.h"

#include <gtest/gtest.h>
#include <png.h>

#include <cstdint>
#include <string>
#include <vector>

namespace girdle::png_file_test {
namespace {

// Every pixel another colour; an odd width.
Picture Sample() {
  Picture picture{{17, 19}, {}};
  for (int i = 0; i < 3 * 17 * 19; ++i) {
    picture.rgb.push_back(static_cast<std::uint8_t>(i * 7));
  }
  return picture;
}

TEST(PngFile, HoldsThePicture) {
  const Picture picture = Sample();
  const std::string bytes = PngBytes(picture);
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  ASSERT_NE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()), 0);
  EXPECT_EQ(image.width, 17U);
  EXPECT_EQ(image.height, 19U);
  image.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> read(PNG_IMAGE_SIZE(image));
  ASSERT_NE(png_image_finish_read(&image, nullptr, read.data(), 0, nullptr), 0);
  EXPECT_EQ(read, picture.rgb);
}

TEST(PngFile, IsTheSameForTheSamePicture) { EXPECT_EQ(PngBytes(Sample()), PngBytes(Sample())); }

TEST(PngFile, SaysNothingOfTimeOrProgram) {
  const std::string bytes = PngBytes(Sample());
  for (const char* chunk : {"tIME", "tEXt", "iTXt", "zTXt"}) {
    EXPECT_EQ(bytes.find(chunk), std::string::npos) << chunk;
  }
}

}  // namespace
}  // namespace girdle::png_file_test
