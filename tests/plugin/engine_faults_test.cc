// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "plugin/engine_faults.h"

#include <gtest/gtest.h>

#include "plugin/engine_layout.h"
#include "simulation/plugin_fixture.h"

namespace girdle::engine_faults_test {
namespace {

class EngineFaultTest : public PluginTest {
 protected:
  [[nodiscard]] std::string FaultIn(int version, bool is_sparse) const {
    return EngineFault(version, ViewOf(*model_, *FindEngineLayout(mj_version())), 0, is_sparse);
  }

  // As an engine does that takes radians for degrees.
  void NarrowRanges() const {
    for (int i = 0; i < 2 * model_->njnt; ++i) {
      model_->jnt_range[i] = RadiansFromDegrees(model_->jnt_range[i]);
    }
  }
};

TEST_F(EngineFaultTest, FourZeroZeroSolvesSparseModelsWrongly) {
  EXPECT_NE(FaultIn(4000000, true).find("<option jacobian=\"dense\"/>"), std::string::npos);
  EXPECT_EQ(FaultIn(4000000, false), "");
  EXPECT_EQ(FaultIn(4000001, true), "");
}

TEST_F(EngineFaultTest, ThreeThreeZeroTakesRadiansForDegreesWhereItAttaches) {
  EXPECT_EQ(FaultIn(330, false), "");
  NarrowRanges();
  EXPECT_NE(FaultIn(330, false).find("compiler.degree"), std::string::npos);
  EXPECT_EQ(FaultIn(331, false), "");
}

}  // namespace
}  // namespace girdle::engine_faults_test
