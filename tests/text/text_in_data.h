// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// What stands in a file of data/.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

namespace girdle {

/// Returns all bytes of a file of data/. A file that cannot be read is a failure, and empty.
inline std::string TextInData(const std::string& file) {
  std::ifstream in(std::string(GIRDLE_SOURCE_DIR) + "/data/" + file, std::ios::binary);
  EXPECT_TRUE(in) << file;
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace girdle
