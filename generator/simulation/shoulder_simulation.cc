// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "simulation/shoulder_simulation.h"

#include <algorithm>
#include <utility>

#include "tables/input_error.h"
#include "tables/number_text.h"

namespace girdle {
namespace {

// Longer steps are too few for the motions that are measured; with shorter ones a motion of some
// seconds never ends.
constexpr double kLongestTimestep_s = 0.01;
constexpr double kShortestTimestep_s = 1e-6;

int FindInstance(const mjModel& model, const std::string& model_name) {
  int slot = -1;
  mjp_getPlugin(kPluginName, &slot);
  for (int instance = 0; instance < model.nplugin; ++instance) {
    if (model.plugin[instance] == slot) {
      return instance;
    }
  }
  throw InputError(model_name + ": has no instance of the plugin " + kPluginName +
                   ". Make a model that has one with girdle generate");
}

// Of the hinges of the right shoulder.
JointRanges RangesOf(const mjModel& model) {
  JointRanges ranges = ShoulderRhythm::Unbounded();
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    const int joint =
        mj_name2id(&model, mjOBJ_JOINT, SidedName(kCoordinateNames[k], kRightSuffix).c_str());
    if (model.jnt_limited[joint] != 0) {
      ranges[k] = {model.jnt_range[2 * joint], model.jnt_range[2 * joint + 1]};
    }
  }
  return ranges;
}

}  // namespace

std::string_view SiteStem(std::size_t site) {
  return site < kLandmarkCount ? kLandmarks[site].name : kJointSites[site - kLandmarkCount].child;
}

ShoulderElements FindShoulder(const mjModel& model, const std::string& model_name) {
  const auto find = [&](mjtObj type, const char* kind, const std::string& name) {
    const int id = mj_name2id(&model, type, name.c_str());
    if (id < 0) {
      throw InputError(model_name + ": has no " + kind + " \"" + name +
                       "\". Restore it, or make the model anew with girdle generate");
    }
    return id;
  };
  const auto right = [](std::string_view stem) { return SidedName(stem, kRightSuffix); };
  ShoulderElements elements;
  elements.instance = FindInstance(model, model_name);
  for (std::size_t i = 0; i < kCommandCount; ++i) {
    elements.command_controls[i] =
        model.actuator_ctrladr[find(mjOBJ_ACTUATOR, "actuator", right(kCommandNames[i]))];
  }
  const auto find_optional = [&](std::string_view stem) {
    const int id = mj_name2id(&model, mjOBJ_ACTUATOR, right(stem).c_str());
    return id < 0 ? -1 : model.actuator_ctrladr[id];
  };
  std::transform(kOffsetNames.begin(), kOffsetNames.end(), elements.offset_controls.begin(),
                 find_optional);
  std::transform(kRateNames.begin(), kRateNames.end(), elements.rate_controls.begin(),
                 find_optional);
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    elements.trim_controls[k] =
        model.actuator_ctrladr[find(mjOBJ_ACTUATOR, "actuator", right(kCoordinateNames[k]))];
    elements.qpos[k] = model.jnt_qposadr[find(mjOBJ_JOINT, "joint", right(kCoordinateNames[k]))];
  }
  for (std::size_t i = 0; i < kSegmentCount; ++i) {
    const bool sided = static_cast<Segment>(i) != Segment::kThorax;
    elements.bodies[i] =
        find(mjOBJ_BODY, "body", sided ? right(kSegmentNames[i]) : std::string(kSegmentNames[i]));
  }
  for (std::size_t i = 0; i < kSiteCount; ++i) {
    const bool sided = i >= kLandmarkCount || kLandmarks[i].sided;
    elements.sites[i] =
        find(mjOBJ_SITE, "site", sided ? right(SiteStem(i)) : std::string(SiteStem(i)));
  }
  const int sensor = find(mjOBJ_SENSOR, "sensor", right(kRhythmName));
  if (model.sensor_type[sensor] != mjSENS_PLUGIN ||
      model.sensor_plugin[sensor] != elements.instance) {
    throw InputError(model_name + ": sensor \"" + right(kRhythmName) +
                     "\" is not one of the plugin " + kPluginName + ". Make it <plugin name=\"" +
                     right(kRhythmName) + "\" instance=\"" + right(kRhythmName) +
                     "\"/>, or make the model anew with girdle generate");
  }
  elements.sensor = model.sensor_adr[sensor];
  return elements;
}

ShoulderSimulation::ShoulderSimulation(ModelPointer model, std::string name)
    : name_(std::move(name)),
      model_(std::move(model)),
      data_(MakeData(*model_)),
      elements_(FindShoulder(*model_, name_)),
      ranges_(RangesOf(*model_)) {
  if (!(timestep_s() >= kShortestTimestep_s && timestep_s() <= kLongestTimestep_s)) {
    throw InputError(name_ + ": the time step is " + NumberText(timestep_s()) + " s, expected " +
                     NumberText(kShortestTimestep_s) + " to " + NumberText(kLongestTimestep_s) +
                     ". Set <option timestep=\"0.002\"/>");
  }
}

void ShoulderSimulation::SetCommand(const ArmCommand& command, const CommandRate& rate) {
  data_->ctrl[elements_.command_controls[0]] = command.elevation_rad;
  data_->ctrl[elements_.command_controls[1]] = command.plane_rad;
  data_->ctrl[elements_.command_controls[2]] = command.axial_rad;
  const std::array<double, kOffsetCount> offsets_rad = {command.shrug_rad, command.protraction_rad};
  for (std::size_t i = 0; i < kOffsetCount; ++i) {
    if (elements_.offset_controls[i] >= 0) {
      data_->ctrl[elements_.offset_controls[i]] = offsets_rad[i];
    } else if (offsets_rad[i] != 0) {
      throw InputError(name_ + ": " + std::string(kOffsetNames[i]) +
                       " is commanded, and the model has no actuator \"" +
                       SidedName(kOffsetNames[i], kRightSuffix) +
                       "\". Make one that has with girdle generate --offsets");
    }
  }
  for (std::size_t i = 0; i < kRateCount; ++i) {
    if (elements_.rate_controls[i] >= 0) {
      data_->ctrl[elements_.rate_controls[i]] = rate[i];
    }
  }
}

JointAngles ShoulderSimulation::Positions() const {
  JointAngles position_rad{};
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    position_rad[k] = data_->qpos[elements_.qpos[k]];
  }
  return position_rad;
}

ShoulderState ShoulderSimulation::Derived(double time_s, const ArmCommand& command,
                                          const JointAngles& position_rad) const {
  ShoulderState state;
  state.time_s = time_s;
  state.command = command;
  state.position_rad = position_rad;
  const mjtNum* sensor = data_->sensordata + elements_.sensor;
  std::copy_n(sensor + sensor_layout::kTarget, kCoordinateCount, state.target_rad.begin());
  state.distance_rad = sensor[sensor_layout::kDistance];
  state.clamped = sensor[sensor_layout::kCommanded] != command.elevation_rad ||
                  sensor[sensor_layout::kCommanded + 1] != command.plane_rad ||
                  sensor[sensor_layout::kCommanded + 2] != command.axial_rad;
  for (std::size_t i = 0; i < kSegmentCount; ++i) {
    const mjtNum* q = data_->xquat + 4 * elements_.bodies[i];
    state.q_WB[i] = {q[0], q[1], q[2], q[3]};
  }
  for (std::size_t i = 0; i < kSiteCount; ++i) {
    const mjtNum* p = data_->site_xpos + 3 * elements_.sites[i];
    state.site_m[i] = {p[0], p[1], p[2]};
  }
  return state;
}

void ShoulderSimulation::Start(const ArmCommand& command) {
  mj_resetData(model_.get(), data_.get());
  const ShoulderState state = Observe(command);
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    data_->qpos[elements_.qpos[k]] = state.target_rad[k];
  }
}

ShoulderState ShoulderSimulation::Step(const ArmCommand& command, const CommandRate& rate) {
  SetCommand(command, rate);
  const double time_s = data_->time;
  const JointAngles position_rad = Positions();
  // What mj_step derives belongs to the positions before it moves them.
  mj_step(model_.get(), data_.get());
  EngineWatch::ExpectNoWarning(name_ + ": at " + NumberText(time_s) + " s");
  return Derived(time_s, command, position_rad);
}

ShoulderState ShoulderSimulation::Observe(const ArmCommand& command) {
  SetCommand(command, {});
  mj_forward(model_.get(), data_.get());
  EngineWatch::ExpectNoWarning(name_ + ": at " + NumberText(data_->time) + " s");
  return Derived(data_->time, command, Positions());
}

ShoulderState ShoulderSimulation::ObserveAtTargets(const ArmCommand& command) {
  Start(command);
  return Observe(command);
}

}  // namespace girdle
