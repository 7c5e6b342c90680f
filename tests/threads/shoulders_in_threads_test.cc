// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Many simulations in one process. This is what runs under the thread sanitizer as well.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <thread>
#include <vector>

#include "simulation/plugin_fixture.h"

namespace girdle::shoulders_in_threads_test {
namespace {

constexpr std::size_t kThreads = 8;
constexpr int kSteps = 300;

// Two models that share no more than the plugin: one shoulder with all commands, which has a state
// of its own in each mjData, and two on one thorax that a constraint closes.
class ShouldersInThreads : public EngineTest {
 protected:
  using States = std::vector<std::vector<mjtNum>>;

  // Makes a state, steps it through a motion that only `simulation` takes, and returns all that
  // MuJoCo integrates, and the sensors, at the end.
  [[nodiscard]] std::vector<mjtNum> Simulate(std::size_t simulation) const {
    const mjModel& model = *models_[simulation % models_.size()];
    const DataPointer data(mj_makeData(&model));
    for (int step = 0; step < kSteps; ++step) {
      for (int i = 0; i < model.nu; ++i) {
        const double middle =
            (model.actuator_ctrlrange[2 * i] + model.actuator_ctrlrange[2 * i + 1]) / 2;
        // Anything smooth that differs; elevation and plane of an arm come first.
        data->ctrl[i] = (i < 2 ? middle / 2 : 0.02) *
                        std::sin(0.01 * step * static_cast<double>(1 + simulation) + i);
      }
      mj_step(&model, data.get());
    }
    std::vector<mjtNum> state(static_cast<std::size_t>(mj_stateSize(&model, mjSTATE_INTEGRATION)));
    mj_getState(&model, data.get(), state.data(), mjSTATE_INTEGRATION);
    state.insert(state.end(), data->sensordata, data->sensordata + model.nsensordata);
    return state;
  }

  std::array<ModelPointer, 2> models_ = {
      LoadedModel(FullShoulderXml()),
      LoadedModel(ShoulderXml({.sides = Sides::kBoth, .assembly = Assembly::kLoop}))};
};

TEST_F(ShouldersInThreads, TwoModelsInEightThreadsGiveTheBitsOfOneThread) {
  States expected(kThreads);
  for (std::size_t k = 0; k < kThreads; ++k) {
    expected[k] = Simulate(k);
  }
  States states(kThreads);
  {
    std::vector<std::jthread> threads;
    threads.reserve(kThreads);
    for (std::size_t k = 0; k < kThreads; ++k) {
      threads.emplace_back([this, k, &states] { states[k] = Simulate(k); });
    }
  }
  for (std::size_t k = 0; k < kThreads; ++k) {
    EXPECT_EQ(states[k], expected[k]) << "thread " << k;
  }
  // Of simulations that all did the same this would say little.
  for (std::size_t k = models_.size(); k < kThreads; ++k) {
    EXPECT_NE(expected[k], expected[k - models_.size()]) << "thread " << k;
  }
}

}  // namespace
}  // namespace girdle::shoulders_in_threads_test
