// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "engines/engine_version.h"

#include <gtest/gtest.h>

namespace girdle::engine_version_test {
namespace {

TEST(EngineVersion, IsReadFromMujocosNumberNewAndOld) {
  EXPECT_EQ(Text(EngineVersionFromNumber(4000001)), "4.0.1");
  EXPECT_EQ(Text(EngineVersionFromNumber(3017000)), "3.17.0");
  EXPECT_EQ(Text(EngineVersionFromNumber(337)), "3.3.7");
}

TEST(EngineVersion, TheLastThreeAndWhatComesAfterItAreGood) {
  EXPECT_EQ(WhyRefused({3, 17, 0}), "");
  EXPECT_EQ(WhyRefused({4, 0, 1}), "");
  EXPECT_EQ(WhyRefused({5, 0, 0}), "");
}

TEST(EngineVersion, WhatIsOlderIsRefusedWithTheVersionThatIsNeeded) {
  EXPECT_EQ(WhyRefused({3, 16, 9}), "too old: Girdle needs 3.17.0 or later");
}

TEST(EngineVersion, FourZeroZeroIsRefusedForWhatIsWrongWithIt) {
  EXPECT_NE(WhyRefused({4, 0, 0}).find("factorisation"), std::string::npos);
}

TEST(EngineVersion, PipKnowsTheLibraryByAnotherNameSinceFour) {
  EXPECT_EQ(PipPackage({3, 17, 0}), "mujoco==3.17.0");
  EXPECT_EQ(PipPackage({4, 0, 1}), "mujoco-core==4.0.1");
}

}  // namespace
}  // namespace girdle::engine_version_test
