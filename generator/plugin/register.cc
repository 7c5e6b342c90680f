// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Registers `girdle.rhythm` when the library is loaded.
#include <mujoco/mujoco.h>

#include <exception>
#include <memory>
#include <string>

#include "kinematics/model_names.h"
#include "plugin/engine_functions.h"
#include "plugin/rhythm_controller.h"
#include "tables/rhythm_config.h"

// The version that the plugin accepts. Tests build one that is wrong.
#ifndef GIRDLE_ENGINE_VERSION
#define GIRDLE_ENGINE_VERSION mjVERSION_HEADER
#endif

namespace girdle {
namespace {

// Set once while the library is loaded, before MuJoCo can call anything below.
EngineFunctions engine;  // NOLINT(readability-identifier-naming)

RhythmController* ControllerOf(const mjData* data, int instance) {
  return reinterpret_cast<RhythmController*>(data->plugin_data[instance]);
}

std::string ConfigText(const mjModel* model, int instance, const char* key) {
  const char* text = engine.get_plugin_config(model, instance, key);
  return text == nullptr ? "" : text;
}

// Returns 0, or -1 after a warning that names instance and fix. Nothing escapes.
int Init(const mjModel* model, mjData* data, int instance) noexcept {
  data->plugin_data[instance] = 0;
  const char* name = model->names + model->name_pluginadr[instance];
  try {
    const RhythmConfig config = ParseRhythmConfig(
        {ConfigText(model, instance, kInterpolationKey), ConfigText(model, instance, kClosureKey),
         ConfigText(model, instance, kRangeKey), ConfigText(model, instance, kTableKey),
         ConfigText(model, instance, kStiffnessKey), ConfigText(model, instance, kSideKey),
         ConfigText(model, instance, kTranslationStiffnessKey)});
    auto controller = std::make_unique<RhythmController>(*model, instance, config);
    data->plugin_data[instance] = reinterpret_cast<uintptr_t>(controller.release());
    return 0;
  } catch (const std::exception& error) {
    engine.warning("%s instance \"%s\": %s", kPluginName, name, error.what());
  } catch (...) {
    engine.warning("%s instance \"%s\": unknown error", kPluginName, name);
  }
  return -1;
}

void Destroy(mjData* data, int instance) noexcept {
  delete ControllerOf(data, instance);
  data->plugin_data[instance] = 0;
}

void Compute(const mjModel* model, mjData* data, int instance, int capability) noexcept {
  RhythmController& controller = *ControllerOf(data, instance);
  if ((capability & mjPLUGIN_ACTUATOR) != 0) {
    controller.Actuate(*model, *data);
  }
  if ((capability & mjPLUGIN_SENSOR) != 0) {
    controller.Sense(*model, *data);
  }
}

std::string VersionText(int version) {
  return std::to_string(version / 1000000) + "." + std::to_string(version / 1000 % 1000) + "." +
         std::to_string(version % 1000);
}

void Register() {
  engine = FindEngine(GIRDLE_ENGINE_VERSION);
  if (!engine.complete()) {
    return;  // no engine in this process: nobody to register with, nobody to tell
  }
  if (engine.version() != GIRDLE_ENGINE_VERSION) {
    const std::string built_for = VersionText(GIRDLE_ENGINE_VERSION);
    engine.warning(
        "%s is built for MuJoCo %s, this process runs %s: the plugin %s is not available. Run "
        "MuJoCo "
        "%s, or build Girdle with MUJOCO_ROOT set to your MuJoCo",
        PluginPath(), built_for.c_str(), engine.version_string(), kPluginName, built_for.c_str());
    return;
  }
  static const char* const kAttributes[] = {
      kInterpolationKey,       kClosureKey, kRangeKey, kTableKey, kStiffnessKey, kSideKey,
      kTranslationStiffnessKey};
  mjpPlugin plugin;
  engine.default_plugin(&plugin);
  plugin.name = kPluginName;
  plugin.nattribute = sizeof(kAttributes) / sizeof(kAttributes[0]);
  plugin.attributes = kAttributes;
  plugin.capabilityflags = mjPLUGIN_ACTUATOR | mjPLUGIN_SENSOR;
  // Of the stages the one that asks the engine for nothing more. A change of a control alone, which
  // leaves out this stage, reaches the sensors by way of the actuators.
  plugin.needstage = mjSTAGE_POS;
  plugin.nstate = +[](const mjModel*, int) { return 0; };
  plugin.nsensordata = +[](const mjModel*, int, int) { return int{sensor_layout::kSize}; };
  plugin.init = +[](const mjModel* m, mjData* d, int instance) { return Init(m, d, instance); };
  plugin.destroy = +[](mjData* d, int instance) { Destroy(d, instance); };
  plugin.reset = +[](const mjModel*, mjtNum*, void*, int) {};
  plugin.compute = +[](const mjModel* m, mjData* d, int instance, int capability) {
    Compute(m, d, instance, capability);
  };
  engine.register_plugin(&plugin);
}

mjPLUGIN_LIB_INIT(girdle_rhythm) {
  try {
    Register();
  } catch (...) {
    // Out of memory while the library is loaded: it stays unregistered, and MuJoCo says so.
  }
}

}  // namespace
}  // namespace girdle

// Named by kPluginVersionSymbol.
extern "C" __attribute__((visibility("default"))) const char* girdle_rhythm_version() {
  return GIRDLE_VERSION;
}
