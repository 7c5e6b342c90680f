// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "skin/weight_blend.h"

#include <gtest/gtest.h>

#include <vector>

namespace girdle::weight_blend_test {
namespace {

// Two triangles in a row: 0 and 3 are not neighbours.
const TriangleMesh kStrip{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 3, 2}}};

const std::vector<SkinBone> kBoth = SkinBonesOf({Side::kRight, Side::kLeft});

TEST(Mixed, IsEachInItsShare) {
  const SkinWeights mixed = Mixed({{1, 0}, {0, 1}}, {{0.5, 0.5}, {0.5, 0.5}}, 0.25);
  EXPECT_EQ(mixed, (SkinWeights{{0.875, 0.125}, {0.125, 0.875}}));
}

TEST(Smoothed, GoesHalfTheWayToTheNeighbours) {
  const SkinWeights smooth = Smoothed(kStrip, {{1, 0, 0, 0}, {0, 1, 1, 1}}, 1);
  EXPECT_DOUBLE_EQ(smooth[0][0], 0.5);
  EXPECT_DOUBLE_EQ(smooth[0][1], 1.0 / 6);
  EXPECT_DOUBLE_EQ(smooth[0][2], 1.0 / 6);
  EXPECT_DOUBLE_EQ(smooth[0][3], 0);
}

TEST(Smoothed, KeepsTheSumOfShares) {
  const SkinWeights smooth = Smoothed(kStrip, {{1, 0, 0.3, 0}, {0, 1, 0.7, 1}}, 5);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_DOUBLE_EQ(smooth[0][i] + smooth[1][i], 1);
}

TEST(Smoothed, WithoutStepsChangesNothing) {
  const SkinWeights weights{{1, 0, 0.3, 0}};
  EXPECT_EQ(Smoothed(kStrip, weights, 0), weights);
}

TEST(SharesOf, OfTheSameBonesAreTheSame) {
  const SkinWeights weights{{0.1}, {0.2}, {0.3}, {0.4}, {0}, {0}, {0}};
  EXPECT_EQ(SharesOf(kBoth, kBoth, weights), weights);
}

TEST(SharesOf, ASideThatIsNotThereGoToTheThorax) {
  const SkinWeights weights{{0.25}, {0}, {0}, {0.25}, {0.125}, {0.125}, {0.25}};
  EXPECT_EQ(SharesOf(SkinBonesOf({Side::kRight}), kBoth, weights),
            (SkinWeights{{0.75}, {0}, {0}, {0.25}}));
  EXPECT_EQ(SharesOf(SkinBonesOf({Side::kLeft}), kBoth, weights),
            (SkinWeights{{0.5}, {0.125}, {0.125}, {0.25}}));
}

}  // namespace
}  // namespace girdle::weight_blend_test
