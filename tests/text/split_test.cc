// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "text/split.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace girdle::split_test {
namespace {

using Parts = std::vector<std::string>;

TEST(Split, ReturnsThePartsBetweenSeparators) {
  EXPECT_EQ(Split("0:180:5", ":"), (Parts{"0", "180", "5"}));
  EXPECT_EQ(Split("IJ 0 0; PX 1", "; "), (Parts{"IJ 0 0", "PX 1"}));
}

TEST(Split, KeepsEmptyParts) {
  EXPECT_EQ(Split("", ":"), (Parts{""}));
  EXPECT_EQ(Split(":0:", ":"), (Parts{"", "0", ""}));
}

}  // namespace
}  // namespace girdle::split_test
