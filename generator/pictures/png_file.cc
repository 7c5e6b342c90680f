// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "pictures/png_file.h"

#include <png.h>

#include "text/input_error.h"

namespace girdle {

std::string PngBytes(const Picture& picture) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.size.width);
  image.height = static_cast<png_uint_32>(picture.size.height);
  image.format = PNG_FORMAT_RGB;
  std::string bytes;
  // The largest size that any picture of these dimensions needs. A pass to measure the exact size
  // would compress the picture twice.
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  bytes.resize(size);
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, picture.rgb.data(), 0, nullptr) ==
      0) {
    throw InputError("cannot make a PNG: " + std::string(image.message));
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace girdle
