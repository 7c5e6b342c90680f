// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Models with the plugin, their controls by name, and what the plugin should answer.
#pragma once

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "anatomy/built_in_anatomy.h"
#include "mjcf/shoulder_model.h"
#include "names/model_names.h"
#include "rhythm_tables/built_in_tables.h"
#include "simulation/engine_fixture.h"

namespace girdle {

inline constexpr int kPositions = kCoordinateCount;

/// The model of a built-in rhythm.
inline std::string ShoulderXml(ShoulderModelOptions model = {}, const RhythmOptions& options = {}) {
  model.table = DefaultTable(options.interpolation);
  return ShoulderModelXml(BuiltInAnatomy(), BuiltInRhythm(options), model);
}

/// The published method.
inline constexpr RhythmOptions kAsPublished = {Interpolation::kSquad, Closure::kTable};

/// With commands for offsets and rates.
inline std::string FullShoulderXml() {
  return ShoulderXml({.has_offsets = true, .has_rates = true});
}

inline ModelPointer LoadedModel(const std::string& xml) {
  return LoadModel({{"shoulder.xml", xml}});
}

/// A copy of `text` with the first `from` replaced; a test that looks for what is not there must
/// fail.
inline std::string Replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) {
    throw std::logic_error("the model does not hold: " + from);
  }
  return text.replace(at, from.size(), to);
}

/// The text of MuJoCo's warnings since the last look; empty if there were none.
inline std::string TakenWarnings() {
  try {
    EngineWatch::ExpectNoWarning("test");
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

/// One model with the plugin and its state. Controls are those of kAllCommandNames that the model
/// has, in this order, and nine trims.
class PluginTest : public EngineTest {
 protected:
  explicit PluginTest(const std::string& xml = ShoulderXml())
      : model_(LoadedModel(xml)),
        data_(MakeData(*model_)),
        commands_(static_cast<int>(model_->nu) - kPositions) {}

  static double Draw(std::mt19937& random, double lower, double upper) {
    return std::uniform_real_distribution(lower, upper)(random);
  }

  static double DrawDegrees(std::mt19937& random, double lower_deg, double upper_deg) {
    return RadiansFromDegrees(Draw(random, lower_deg, upper_deg));
  }

  // Outputs of the nine servos, which follow those of the commands.
  [[nodiscard]] const mjtNum* forces() const { return data_->actuator_force + commands_; }
  [[nodiscard]] mjtNum* trims() const { return data_->ctrl + commands_; }

  [[nodiscard]] std::vector<mjtNum> SensorValues() const {
    return {data_->sensordata, data_->sensordata + model_->nsensordata};
  }

  void SetCommand(const ArmCommand& command) const {
    const double values[] = {command.elevation_rad, command.plane_rad, command.axial_rad,
                             command.shrug_rad, command.protraction_rad};
    std::copy_n(values, std::min(commands_, static_cast<int>(std::size(values))), data_->ctrl);
  }

  // The command within the controls' ranges.
  [[nodiscard]] ArmCommand CommandRead() const {
    double values[kCommandCount + kOffsetCount] = {};
    for (int i = 0; i < std::min(commands_, static_cast<int>(std::size(values))); ++i) {
      values[i] = std::clamp(data_->ctrl[i], model_->actuator_ctrlrange[2 * i],
                             model_->actuator_ctrlrange[2 * i + 1]);
    }
    return {values[0], values[1], values[2], values[3], values[4]};
  }

  // Trims and joint positions around where the joints start.
  void RandomisePositions(std::mt19937& random) const {
    for (int k = 0; k < kPositions; ++k) {
      trims()[k] = Draw(random, -0.3, 0.3);
      data_->qpos[k] = model_->qpos0[k] + Draw(random, -0.05, 0.05);
      data_->qvel[k] = Draw(random, -0.5, 0.5);
    }
  }

  // Commands within what an arm reaches, away from its limits.
  void Randomise(std::mt19937& random) const {
    SetCommand({DrawDegrees(random, 20, 160), DrawDegrees(random, -25, 130),
                DrawDegrees(random, -20, 20), DrawDegrees(random, -5, 5),
                DrawDegrees(random, -5, 5)});
    RandomisePositions(random);
  }

  void PutAt(const JointAngles& angles_rad) const {
    std::copy(angles_rad.begin(), angles_rad.end(), data_->qpos);
    std::fill_n(data_->qvel, kPositions, 0);
  }

  ModelPointer model_;
  DataPointer data_;
  int commands_;
};

class FullPluginTest : public PluginTest {
 protected:
  FullPluginTest() : PluginTest(FullShoulderXml()) {}
};

inline JointAngles TargetsOf(const ShoulderRhythm& rhythm, const ArmCommand& command) {
  return AnglesFromPose(rhythm.SolvePose(command));
}

}  // namespace girdle
