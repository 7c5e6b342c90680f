// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Fixture of tests that run MuJoCo: the plugin is loaded as any user loads it, and a warning of
/// the engine fails the test.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "simulation/engine.h"

namespace girdle {

inline const std::string kPluginFile = GIRDLE_BINARY_DIR "/libgirdle_rhythm.so";

class EngineTest : public testing::Test {
 protected:
  EngineTest() { LoadPlugin(kPluginFile); }
  void TearDown() override {
    EXPECT_NO_THROW(EngineWatch::ExpectNoWarning("the test")) << "MuJoCo warned";
  }

 private:
  EngineWatch watch_;
};

}  // namespace girdle
