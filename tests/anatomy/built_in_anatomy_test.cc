// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "anatomy/built_in_files.h"

#include <gtest/gtest.h>

#include "text/text_in_data.h"

namespace girdle::built_in_anatomy_test {
namespace {

TEST(BuiltInAnatomyFiles, AreThoseOfDataByteForByte) {
  EXPECT_EQ(built_in_files::kLandmarks, TextInData("landmarks.csv"));
  EXPECT_EQ(built_in_files::kSegments, TextInData("segments.csv"));
  EXPECT_EQ(built_in_files::kJointRanges, TextInData("joint_ranges.csv"));
  EXPECT_EQ(built_in_files::kThoraxEllipsoids, TextInData("thorax_ellipsoids.csv"));
  EXPECT_EQ(built_in_files::kLigaments, TextInData("ligaments.csv"));
  EXPECT_EQ(built_in_files::kPostures, TextInData("postures.csv"));
}

}  // namespace
}  // namespace girdle::built_in_anatomy_test
