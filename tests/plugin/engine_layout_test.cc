// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "plugin/engine_layout.h"

#include <gtest/gtest.h>

#include <cstddef>

#include "plugin/engine_views.h"
#include "simulation/plugin_fixture.h"

namespace girdle::engine_layout_test {
namespace {

// Versions that have members in other places than the one that these tests run with.
constexpr int kOthers[] = {330, 340, 3005000, 3010000};

using EngineLayoutTest = PluginTest;

TEST(EngineVersionText, IsThatOfTheReleases) {
  EXPECT_EQ(EngineVersionText(330), "3.3.0");
  EXPECT_EQ(EngineVersionText(3010000), "3.10.0");
  EXPECT_EQ(EngineVersionText(4000001), "4.0.1");
}

TEST(EngineLayouts, AreThoseOfPublishedVersionsAlone) {
  for (const int version : {330, 340, 3011000, 3017000, 4000000, 4000001}) {
    ASSERT_NE(FindEngineLayout(version), nullptr) << version;
    EXPECT_EQ(FindEngineLayout(version)->version, version);
  }
  // 2.3.7, one that was never published, and what no version is.
  for (const int version : {237, 9009009, 0, -1}) {
    EXPECT_EQ(FindEngineLayout(version), nullptr) << version;
  }
}

TEST_F(EngineLayoutTest, AViewShowsWhatTheCompilerSees) {
  const EngineLayout& layout = *FindEngineLayout(mj_version());
  const ModelView model = ViewOf(*model_, layout);
#define GIRDLE_MODEL_COUNT(member) EXPECT_EQ(model.member, model_->member) << #member;
#define GIRDLE_MODEL_FLAGS(member, name) EXPECT_EQ(model.name, model_->member) << #member;
#define GIRDLE_MODEL_ARRAY(type, member) \
  EXPECT_EQ(static_cast<const void*>(model.member), model_->member) << #member;
#define GIRDLE_CONSTANT(enumerator, name) EXPECT_EQ(layout.name, enumerator) << #enumerator;
#include "plugin/engine_members.inc"
  const DataView data = ViewOf(*data_, layout);
#define GIRDLE_DATA_ARRAY(type, member) \
  EXPECT_EQ(static_cast<const void*>(data.member), data_->member) << #member;
#include "plugin/engine_members.inc"
}

TEST_F(EngineLayoutTest, TheLayoutOfAnotherVersionDoesNotFit) {
  const char* const name = mj_id2name(model_.get(), mjOBJ_PLUGIN, 0);
  ASSERT_NE(name, nullptr);
  EXPECT_TRUE(LayoutFits(*model_, *data_, *FindEngineLayout(mj_version()), 0, name));
  for (const int version : kOthers) {
    EXPECT_FALSE(LayoutFits(*model_, *data_, *FindEngineLayout(version), 0, name)) << version;
  }
}

TEST_F(EngineLayoutTest, NamesElsewhereDoNotFit) {
  EngineLayout layout = *FindEngineLayout(mj_version());
  const char* const name = mj_id2name(model_.get(), mjOBJ_PLUGIN, 0);
  // As if one array had been added before the names.
  layout.names = offsetof(mjModel, paths);
  EXPECT_FALSE(LayoutFits(*model_, *data_, layout, 0, name));
}

TEST_F(EngineLayoutTest, APointerOutOfTheBufferDoesNotFit) {
  EngineLayout layout = *FindEngineLayout(mj_version());
  const char* const name = mj_id2name(model_.get(), mjOBJ_PLUGIN, 0);
  layout.eq_type = offsetof(mjModel, opt);  // a time step, as a pointer some 10^18
  EXPECT_FALSE(LayoutFits(*model_, *data_, layout, 0, name));
  layout = *FindEngineLayout(mj_version());
  layout.ctrl = offsetof(mjData, time);
  data_->time = 1;  // as a pointer some 10^18
  EXPECT_FALSE(LayoutFits(*model_, *data_, layout, 0, name));
}

}  // namespace
}  // namespace girdle::engine_layout_test
