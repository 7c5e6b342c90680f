// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Registers `girdle.rhythm` when the library is loaded.
#include <mujoco/mujoco.h>

#include <cstdint>
#include <exception>
#include <memory>
#include <string>
#include <utility>

#include "names/model_fault_mark.h"
#include "names/model_names.h"
#include "plugin/controller_registry.h"
#include "plugin/engine_faults.h"
#include "plugin/engine_functions.h"
#include "plugin/engine_views.h"
#include "plugin/library_files.h"
#include "plugin/model_faults.h"
#include "plugin/rhythm_controller.h"
#include "rhythm_tables/rhythm_config.h"
#include "text/same_bytes.h"

namespace girdle {
namespace {

// These are set once while the library is loaded, before MuJoCo can call any function below. The
// registry is never deleted, because a program may delete its mjData last of all.
EngineFunctions engine;                  // NOLINT(readability-identifier-naming)
const EngineLayout* layout = nullptr;    // NOLINT(readability-identifier-naming)
ControllerRegistry* registry = nullptr;  // NOLINT(readability-identifier-naming)

std::uintptr_t& TicketIn(mjData& data, int instance) noexcept {
  return ViewOf(data, *layout).plugin_data[instance];
}

std::string ConfigText(const mjModel* model, int instance, const char* key) {
  const char* text = engine.get_plugin_config(model, instance, key);
  return text == nullptr ? "" : text;
}

std::unique_ptr<RhythmController> MakeController(const mjModel* model, int instance) {
  const RhythmConfig config = ParseRhythmConfig(
      {ConfigText(model, instance, kInterpolationKey), ConfigText(model, instance, kClosureKey),
       ConfigText(model, instance, kRangeKey), ConfigText(model, instance, kTableKey),
       ConfigText(model, instance, kStiffnessKey), ConfigText(model, instance, kSideKey),
       ConfigText(model, instance, kTranslationStiffnessKey),
       ConfigText(model, instance, kAxialFromKey)});
  return std::make_unique<RhythmController>(ViewOf(*model, *layout), instance, config);
}

// Writes a warning about an instance. The instance may lack a name.
void Warn(const char* instance_name, const char* message) noexcept {
  engine.warning("%s instance \"%s\": %s", kPluginName,
                 instance_name == nullptr ? "" : instance_name, message);
}

// Returns faults of this engine and of the model that move the shoulder wrongly without a warning
// of MuJoCo's own.
std::string Faults(const mjModel* model, const RhythmController& controller) {
  const std::string of_engine = EngineFault(engine.version(), engine.is_sparse(model) != 0);
  const std::string of_model =
      ModelFaults(CompiledViewOf(*model, *layout), controller.binding(), controller.rhythm());
  return of_engine + (of_engine.empty() || of_model.empty() ? "" : "; ") +
         (of_model.empty() ? "" : kModelFaultMark + of_model);
}

// Returns 0, or -1 after a warning with the instance's name and the fix. Throws nothing.
int Init(const mjModel* model, mjData* data, int instance) noexcept {
  const char* const name = engine.id_to_name(model, layout->object_plugin, instance);
  if (!LayoutFits(*model, *data, *layout, instance, name)) {
    engine.warning(
        "%s: this MuJoCo says that it is version %s, but its mjModel is laid out in another way. "
        "Run a published MuJoCo, for example the one of `pip install mujoco`",
        kPluginName, engine.version_string());
    return -1;
  }
  TicketIn(*data, instance) = 0;
  try {
    std::unique_ptr<RhythmController> controller = MakeController(model, instance);
    const std::string faults = Faults(model, *controller);
    TicketIn(*data, instance) = registry->Add(std::move(controller), data, instance);
    if (!faults.empty()) {
      Warn(name, faults.c_str());
    }
    return 0;
  } catch (const std::exception& error) {
    Warn(name, error.what());
  } catch (...) {
    Warn(name, "unknown error");
  }
  return -1;
}

// Returns the controller of an mjData whose ticket is from another mjData or another process: the
// controller made for it earlier, or a new one. Returns null after a warning.
RhythmController* RecoveredController(const mjModel* model, mjData* data, int instance) noexcept {
  std::uintptr_t& ticket = TicketIn(*data, instance);
  ticket = registry->TicketOf(data, instance);
  if (ticket == 0 && Init(model, data, instance) != 0) {
    return nullptr;
  }
  return registry->Find(ticket, data, instance);
}

void Compute(const mjModel* model, mjData* data, int instance, int capability) noexcept {
  const DataView data_view = ViewOf(*data, *layout);
  RhythmController* controller = registry->Find(data_view.plugin_data[instance], data, instance);
  if (controller == nullptr) {
    controller = RecoveredController(model, data, instance);
  }
  if (controller == nullptr) {
    return;
  }
  const ModelView model_view = ViewOf(*model, *layout);
  if ((capability & layout->plugin_actuator) != 0) {
    controller->Actuate(model_view, data_view);
  }
  if ((capability & layout->plugin_sensor) != 0) {
    controller->Sense(model_view, data_view);
    if (controller->FirstMisses(data_view)) {
      Warn(engine.id_to_name(model, layout->object_plugin, instance),
           "MuJoCo does not work out where the thorax is, and the sensor shows no arm, because "
           "sleeping was switched on after mj_makeData: call mj_resetData after you switch it on");
    }
  }
}

// Returns whether the process has the plugin already. Warns if that plugin is from another library
// than this one.
bool IsRegistered() {
  const mjpPlugin* const registered = engine.get_plugin(kPluginName, nullptr);
  if (registered == nullptr) {
    return false;
  }
  const std::string first = FileOf(reinterpret_cast<const void*>(registered->init));
  const std::string second = OwnFile();
  if (!HaveTheSameBytes(first, second)) {
    engine.warning(
        "%s of %s is not used, because this process has the plugin of %s already. Load one of "
        "them; after an "
        "update `girdle doctor --install` puts the new one into Python's folder",
        kPluginName, DescribedPlugin(second).c_str(), DescribedPlugin(first).c_str());
  }
  return true;
}

void Register() {
  engine = FindEngine();
  if (!engine.complete()) {
    return;  // the process has no engine to register with or to warn through
  }
  layout = FindEngineLayout(engine.version());
  if (layout == nullptr) {
    engine.warning(
        "%s (Girdle %s) does not know MuJoCo %s, so the plugin %s is not available. Run a MuJoCo "
        "from %s, or take a newer Girdle",
        OwnFile().c_str(), GIRDLE_VERSION, engine.version_string(), kPluginName,
        KnownEngineVersions().c_str());
    return;
  }
  if (IsRegistered()) {
    return;
  }
  registry = new ControllerRegistry;
  static const char* const kAttributes[] = {
      kInterpolationKey,        kClosureKey,  kRangeKey, kTableKey, kStiffnessKey, kSideKey,
      kTranslationStiffnessKey, kAxialFromKey};
  mjpPlugin plugin;
  engine.default_plugin(&plugin);
  plugin.name = kPluginName;
  plugin.nattribute = sizeof(kAttributes) / sizeof(kAttributes[0]);
  plugin.attributes = kAttributes;
  plugin.capabilityflags = layout->plugin_actuator | layout->plugin_sensor;
  // The position stage is the one that makes the engine compute least. A change of only a control
  // skips this stage; Actuate then updates the sensors.
  plugin.needstage = layout->stage_pos;
  plugin.nstate = +[](const mjModel*, int) { return 0; };
  plugin.nsensordata = +[](const mjModel*, int, int) { return int{sensor_layout::kSize}; };
  plugin.init = +[](const mjModel* m, mjData* d, int instance) { return Init(m, d, instance); };
  plugin.destroy = +[](mjData* d, int instance) { registry->Remove(d, instance); };
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
    // Out of memory during loading: the plugin stays unregistered, and MuJoCo reports that it is
    // unknown.
  }
}

}  // namespace
}  // namespace girdle

// kPluginVersionSymbol is the name of this function.
extern "C" __attribute__((visibility("default"))) const char* girdle_rhythm_version() {
  return GIRDLE_VERSION;
}
