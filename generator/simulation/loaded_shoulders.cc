// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "simulation/loaded_shoulders.h"

#include <utility>

#include "rhythm_tables/rhythm_config.h"
#include "text/input_error.h"
#include "text/number_text.h"

namespace girdle {
namespace {

// With longer steps there are too few for the measured motions. With shorter ones a motion of some
// seconds takes too long.
constexpr double kLongestTimestep_s = 0.01;
constexpr double kShortestTimestep_s = 1e-6;

// Returns the ranges of a shoulder's driven hinges.
JointRanges RangesOf(const mjModel& model, const ShoulderElements& elements) {
  JointRanges ranges = ShoulderRhythm::Unbounded();
  const auto coordinates = DrivenCoordinates(elements.assembly);
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    const int joint =
        mj_name2id(&model, mjOBJ_JOINT, SidedName(coordinates[k], elements.side).c_str());
    if (model.jnt_limited[joint] != 0) {
      ranges[k] = {model.jnt_range[2 * joint], model.jnt_range[2 * joint + 1]};
    }
  }
  return ranges;
}

// Returns the stiffness of the servos; 0 for joints without one.
JointAngles StiffnessOf(const mjModel& model, const ShoulderElements& elements) {
  if (elements.has_plugin()) {
    const char* text = mj_getPluginConfig(&model, elements.instance, kStiffnessKey);
    RhythmConfigText config;
    config.stiffness = text == nullptr ? "" : text;
    return ParseRhythmConfig(config).stiffness_N_m_per_rad;
  }
  JointAngles stiffness_N_m_per_rad{};
  const auto coordinates = DrivenCoordinates(elements.assembly);
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    const int servo =
        mj_name2id(&model, mjOBJ_ACTUATOR, SidedName(coordinates[k], elements.side).c_str());
    stiffness_N_m_per_rad[k] = servo < 0 ? 0 : model.actuator_gainprm[mjNGAIN * servo];
  }
  return stiffness_N_m_per_rad;
}

std::string OwnConfigText(const LoadedShoulders& shoulders, const char* key) {
  const char* const text =
      mj_getPluginConfig(&shoulders.model(), shoulders.elements().instance, key);
  return text == nullptr ? "" : text;
}

}  // namespace

LoadedShoulders::LoadedShoulders(ModelPointer model, std::string name)
    : name_(std::move(name)),
      model_(std::move(model)),
      data_(MakeData(*model_)),
      shoulders_(FindShoulders(*model_, name_)),
      ranges_(RangesOf(*model_, shoulders_.front())),
      stiffness_N_m_per_rad_(StiffnessOf(*model_, shoulders_.front())) {
  if (!(timestep_s() >= kShortestTimestep_s && timestep_s() <= kLongestTimestep_s)) {
    throw InputError(name_ + ": the time step is " + NumberText(timestep_s()) + " s, expected " +
                     NumberText(kShortestTimestep_s) + " to " + NumberText(kLongestTimestep_s) +
                     ". Set <option timestep=\"0.002\"/>");
  }
}

void LoadedShoulders::Watch(Side side) {
  for (std::size_t i = 0; i < shoulders_.size(); ++i) {
    if (shoulders_[i].side == side) {
      watched_ = i;
      return;
    }
  }
  throw InputError(name_ + ": has no " + std::string(Name(side)) +
                   " shoulder. Make one that has with girdle generate --side");
}

RhythmChoice OwnChoice(const LoadedShoulders& shoulders) {
  if (!shoulders.has_plugin()) {
    return {};
  }
  RhythmConfigText text;
  text.interpolation = OwnConfigText(shoulders, kInterpolationKey);
  text.closure = OwnConfigText(shoulders, kClosureKey);
  text.range = OwnConfigText(shoulders, kRangeKey);
  text.table = OwnConfigText(shoulders, kTableKey);
  return ParseRhythmConfig(text).rhythm;
}

AxialFrom OwnAxialFrom(const LoadedShoulders& shoulders) {
  if (!shoulders.has_plugin()) {
    return AxialFrom::kRhythm;
  }
  RhythmConfigText text;
  text.axial_from = OwnConfigText(shoulders, kAxialFromKey);
  return ParseRhythmConfig(text).axial_from;
}

AssembledRhythm OwnRhythm(const LoadedShoulders& shoulders) {
  const JointRanges& ranges = shoulders.ranges();
  return {MakeRhythm(Resolve(OwnChoice(shoulders)), ranges),
          shoulders.elements().assembly,
          {ranges[3], ranges[4], ranges[5]}};
}

}  // namespace girdle
