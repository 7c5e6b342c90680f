// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// What the engine plugin costs: one mj_step of the right shoulder driven by it, against the same
/// model with nine native position servos at fixed targets, all timed in turn in one run.
///   step_cost PLUGIN
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <vector>

#include "kinematics/model_names.h"
#include "mjcf/shoulder_model.h"
#include "simulation/engine.h"
#include "tables/built_in.h"

namespace girdle {
namespace {

constexpr int kStepsPerRound = 2000;
constexpr int kRounds = 101;

// Time of one step [s], averaged over a round that starts from rest.
double StepTime(const mjModel& model, mjData& data, bool moves) {
  using Clock = std::chrono::steady_clock;
  mj_resetDataKeyframe(&model, &data, 2);
  const auto start = Clock::now();
  for (int step = 0; step < kStepsPerRound; ++step) {
    if (moves) {
      // Every step asks for another pose, so that nothing can be reused.
      data.ctrl[0] = RadiansFromDegrees(60 + 0.01 * step);
      data.ctrl[1] = RadiansFromDegrees(20 + 0.02 * step);
    }
    mj_step(&model, &data);
  }
  return std::chrono::duration<double>(Clock::now() - start).count() / kStepsPerRound;
}

double Median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

int Run(const char* plugin) {
  const EngineWatch watch;
  LoadPlugin(plugin);
  const ShoulderRhythm rhythm = BuiltInRhythm();
  const Anatomy anatomy = BuiltInAnatomy();
  const ModelPointer driven = LoadModel({{"driven.xml", ShoulderModelXml(anatomy, rhythm)}});
  const ModelPointer servos = LoadModel(
      {{"servos.xml", ShoulderModelXml(anatomy, rhythm, {.actuation = Actuation::kPosition})}});
  const DataPointer driven_data = MakeData(*driven);
  const DataPointer servo_data = MakeData(*servos);

  std::vector<double> servo_us;
  std::vector<double> held_us;
  std::vector<double> moving_us;
  std::vector<double> held_percent;
  std::vector<double> moving_percent;
  for (int round = 0; round < kRounds; ++round) {
    constexpr double kMicrosecondsPerSecond = 1e6;
    servo_us.push_back(kMicrosecondsPerSecond * StepTime(*servos, *servo_data, false));
    held_us.push_back(kMicrosecondsPerSecond * StepTime(*driven, *driven_data, false));
    moving_us.push_back(kMicrosecondsPerSecond * StepTime(*driven, *driven_data, true));
    held_percent.push_back(100 * (held_us.back() / servo_us.back() - 1));
    moving_percent.push_back(100 * (moving_us.back() / servo_us.back() - 1));
  }
  EngineWatch::ExpectNoWarning("stepping");
  std::printf(
      "mj_step of the right shoulder, median of %d rounds of %d steps in turn\n"
      "  nine native position servos, fixed targets     %6.2f us\n"
      "  plugin and its sensor, commands held           %6.2f us  %+6.1f %%\n"
      "  plugin and its sensor, new commands each step  %6.2f us  %+6.1f %%\n",
      kRounds, kStepsPerRound, Median(servo_us), Median(held_us), Median(held_percent),
      Median(moving_us), Median(moving_percent));
  return 0;
}

}  // namespace
}  // namespace girdle

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: step_cost PLUGIN\n");
    return 2;
  }
  try {
    return girdle::Run(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "step_cost: %s\n", error.what());
    return 2;
  }
}
