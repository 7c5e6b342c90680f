// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "plugin/engine_faults.h"

#include <gtest/gtest.h>

namespace girdle::engine_faults_test {
namespace {

TEST(EngineFault, FourZeroZeroSolvesSparseModelsWrongly) {
  EXPECT_NE(EngineFault(4000000, true).find("<option jacobian=\"dense\"/>"), std::string::npos);
  EXPECT_EQ(EngineFault(4000000, false), "");
  EXPECT_EQ(EngineFault(4000001, true), "");
}

}  // namespace
}  // namespace girdle::engine_faults_test
