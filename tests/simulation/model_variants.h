// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Elements of a model by their names, with any prefix, and one way to move every model that there
/// is.
#pragma once

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "anatomy/built_in_anatomy.h"
#include "kinematics/assembled_rhythm.h"
#include "names/model_names.h"
#include "rhythm_tables/built_in_tables.h"
#include "simulation/plugin_fixture.h"

namespace girdle {

/// Id of the element with this name; a test that asks for what is not there must fail.
inline int IdOf(const mjModel& model, mjtObj type, const std::string& name) {
  const int id = mj_name2id(&model, type, name.c_str());
  if (id < 0) throw std::logic_error("the model has no element named " + name);
  return id;
}

inline mjtNum& ControlOf(const mjModel& model, mjData& data, const std::string& actuator) {
  return data.ctrl[model.actuator_ctrladr[IdOf(model, mjOBJ_ACTUATOR, actuator)]];
}

inline mjtNum ForceOf(const mjModel& model, const mjData& data, const std::string& actuator) {
  return data.actuator_force[model.actuator_outadr[IdOf(model, mjOBJ_ACTUATOR, actuator)]];
}

inline mjtNum& PositionOf(const mjModel& model, mjData& data, const std::string& joint) {
  return data.qpos[model.jnt_qposadr[IdOf(model, mjOBJ_JOINT, joint)]];
}

inline const mjtNum* SensorOf(const mjModel& model, const mjData& data, const std::string& sensor) {
  return data.sensordata + model.sensor_adr[IdOf(model, mjOBJ_SENSOR, sensor)];
}

inline Vector3 VectorAt(const mjtNum* v) { return {v[0], v[1], v[2]}; }

/// A tree or a loop with either lead, moved by plugin or servos.
struct Variant {
  const char* name;
  Assembly assembly = Assembly::kTree;
  Lead lead = Lead::kClavicle;
  Actuation actuation = Actuation::kPlugin;

  [[nodiscard]] ShoulderModelOptions Options(Sides sides) const {
    return {.sides = sides, .assembly = assembly, .lead = lead, .actuation = actuation};
  }
  [[nodiscard]] ModelPointer Load(Sides sides) const {
    return LoadedModel(ShoulderXml(Options(sides)));
  }
  [[nodiscard]] bool has_plugin() const { return actuation == Actuation::kPlugin; }
};

inline void PrintTo(const Variant& variant, std::ostream* out) { *out << variant.name; }
inline std::string NameOf(const testing::TestParamInfo<Variant>& tested) {
  return tested.param.name;
}

inline const std::vector<Variant>& PluginVariants() {
  static const std::vector<Variant> kVariants = {
      {"Tree"}, {"Loop", Assembly::kLoop}, {"ScapulaLeads", Assembly::kLoop, Lead::kScapula}};
  return kVariants;
}

inline std::vector<Variant> AllVariants() {
  std::vector<Variant> variants = PluginVariants();
  variants.insert(
      variants.end(),
      {{"TreePosition", Assembly::kTree, Lead::kClavicle, Actuation::kPosition},
       {"LoopPosition", Assembly::kLoop, Lead::kClavicle, Actuation::kPosition},
       {"ScapulaLeadsPosition", Assembly::kLoop, Lead::kScapula, Actuation::kPosition}});
  return variants;
}

/// Stems of the joints of a shoulder in the order of the model.
inline std::vector<std::string_view> JointStems(Assembly assembly) {
  const auto driven = DrivenCoordinates(assembly);
  std::vector<std::string_view> stems(driven.begin(), driven.end());
  if (assembly == Assembly::kLoop) {
    stems.insert(stems.begin() + 3, kTranslationNames.begin(), kTranslationNames.end());
  }
  return stems;
}

/// PAC in the thorax [m] where the clavicle of a right shoulder takes it.
inline Vector3 PlaceOfScapula(const ShoulderPose& pose) {
  static const Anatomy kAnatomy = BuiltInAnatomy();
  return kAnatomy.landmark_m(Landmark::kSC) + pose.q_TC * kAnatomy.landmark_m(Landmark::kPAC);
}

/// One shoulder in a model: its side, and the prefix that it was attached with.
struct ShoulderNames {
  Side side = Side::kRight;
  std::string prefix = {};

  [[nodiscard]] std::string Of(std::string_view stem) const {
    return prefix + SidedName(stem, side);
  }
};

/// Tells a shoulder to go there: the plugin the command, position servos the joints of its pose.
inline void Command(const mjModel& model, mjData& data, const Variant& variant,
                    const ShoulderNames& names, const ArmCommand& command) {
  if (variant.has_plugin()) {
    ControlOf(model, data, names.Of("elevation")) = command.elevation_rad;
    ControlOf(model, data, names.Of("plane")) = command.plane_rad;
    ControlOf(model, data, names.Of("axial")) = command.axial_rad;
    return;
  }
  static const std::array<AssembledRhythm, 2> kRhythms = {
      AssembledRhythm(BuiltInRhythm(), Assembly::kTree),
      AssembledRhythm(BuiltInRhythm(), Assembly::kLoop)};
  const ShoulderPose pose =
      kRhythms.at(static_cast<std::size_t>(variant.assembly)).SolvePose(command);
  const JointAngles target_rad = DrivenAngles(variant.assembly, pose);
  const auto driven = DrivenCoordinates(variant.assembly);
  const bool scapula_leads = variant.lead == Lead::kScapula;
  for (std::size_t k = scapula_leads ? 2 : 0; k < kCoordinateCount; ++k) {
    ControlOf(model, data, names.Of(driven[k])) = target_rad[k];
  }
  const Vector3 place_m = PlaceOfScapula(pose);
  for (int i = 0; scapula_leads && i < 3; ++i) {
    ControlOf(model, data, names.Of(kTranslationNames[static_cast<std::size_t>(i)])) = place_m[i];
  }
}

/// A second of a lively motion over all planes, to where the arm is far from measured.
inline ArmCommand LivelyCommand(double time_s) {
  return {1.4 - 1.4 * std::cos(5 * time_s), 0.7 - 0.9 * std::cos(7 * time_s) + 0.2,
          0.3 * std::sin(11 * time_s)};
}

}  // namespace girdle
