// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "simulation/shoulder_elements.h"

#include <algorithm>

#include "simulation/named_elements.h"
#include "text/input_error.h"

namespace girdle {
namespace {

// Whether the model has any instance of the plugin.
bool HasInstance(const mjModel& model) {
  int slot = -1;
  return mjp_getPlugin(kPluginName, &slot) != nullptr &&
         std::find(model.plugin, model.plugin + model.nplugin, slot) !=
             model.plugin + model.nplugin;
}

// Returns the first name that is `name` behind a prefix, such as a model gives that the shoulder is
// attached to; empty if there is none.
std::string PrefixedName(const mjModel& model, mjtObj type, const std::string& name) {
  for (const std::string& other : ElementNames(model, type)) {
    if (other.size() > name.size() && other.ends_with(name)) {
      return other;
    }
  }
  return "";
}

// Finds the elements of one side by their names.
class ElementFinder {
 public:
  ElementFinder(const mjModel& model, const std::string& model_name, Side side)
      : model_(model), model_name_(model_name), side_(side) {}

  // Returns the id, or -1 if there is no such element.
  [[nodiscard]] int Look(mjtObj type, std::string_view stem) const {
    return mj_name2id(&model_, type, SidedName(stem, side_).c_str());
  }

  [[nodiscard]] int Find(mjtObj type, const char* kind, std::string_view stem,
                         bool sided = true) const {
    const std::string name = sided ? SidedName(stem, side_) : std::string(stem);
    const int id = mj_name2id(&model_, type, name.c_str());
    if (id < 0) {
      const std::string prefixed = PrefixedName(model_, type, name);
      throw InputError(model_name_ + ": has no " + kind + " \"" + name + "\". " +
                       (prefixed.empty()
                            ? "Restore it, or make the model anew with girdle generate"
                            : "It has \"" + prefixed +
                                  "\": Girdle's verbs take names without a prefix. Attach the "
                                  "shoulder with an empty prefix, or compare it with girdle verify "
                                  "--mapping"));
    }
    return id;
  }

  [[nodiscard]] ShoulderElements FindAll() const {
    ShoulderElements elements;
    elements.side = side_;
    elements.assembly =
        Look(mjOBJ_JOINT, kScapulothoracicNames[0]) < 0 ? Assembly::kTree : Assembly::kLoop;
    elements.lead =
        Look(mjOBJ_ACTUATOR, kTranslationNames[0]) < 0 ? Lead::kClavicle : Lead::kScapula;
    const auto coordinates = DrivenCoordinates(elements.assembly);
    const bool has_plugin = HasInstance(model_);
    if (!has_plugin && Look(mjOBJ_ACTUATOR, kCoordinateNames[2]) < 0) {
      throw InputError(
          model_name_ + ": has no instance of the plugin " + kPluginName +
          ". Make a model that has one with girdle generate; for an arm that is not Girdle's "
          "there is girdle verify --mapping");
    }
    if (has_plugin) {
      FindCommands(elements);
    }
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      const bool follows = !has_plugin && elements.lead == Lead::kScapula && k < 2;
      elements.joint_controls[k] = follows ? -1 : Control(coordinates[k]);
      elements.qpos[k] = model_.jnt_qposadr[Find(mjOBJ_JOINT, "joint", coordinates[k])];
    }
    if (elements.assembly == Assembly::kLoop) {
      FindLoop(elements);
    }
    for (std::size_t i = 0; i < kSegmentCount; ++i) {
      const bool sided = static_cast<Segment>(i) != Segment::kThorax;
      elements.bodies[i] = Find(mjOBJ_BODY, "body", kSegmentNames[i], sided);
    }
    for (std::size_t i = 0; i < kSiteCount; ++i) {
      const bool sided = i >= kLandmarkCount || kLandmarks[i].sided;
      elements.sites[i] = Find(mjOBJ_SITE, "site", SiteStem(i), sided);
    }
    for (std::size_t i = 0; i < kLigamentCount; ++i) {
      elements.tendons[i] = Find(mjOBJ_TENDON, "tendon", kLigamentNames[i]);
    }
    elements.gliding = Look(mjOBJ_GEOM, kGlidingName);
    if (has_plugin) {
      FindSensor(elements);
    }
    return elements;
  }

 private:
  [[nodiscard]] int Control(std::string_view stem) const {
    return model_.actuator_ctrladr[Find(mjOBJ_ACTUATOR, "actuator", stem)];
  }

  void FindCommands(ShoulderElements& elements) const {
    for (std::size_t i = 0; i < kCommandCount; ++i) {
      elements.command_controls[i] = Control(kCommandNames[i]);
    }
    elements.instance =
        model_.actuator_plugin[Find(mjOBJ_ACTUATOR, "actuator", kCommandNames.front())];
    if (elements.instance < 0) {
      throw InputError(model_name_ + ": actuator \"" + SidedName(kCommandNames.front(), side_) +
                       "\" is not one of the plugin " + kPluginName +
                       ". Make the model anew with girdle generate");
    }
    CheckSide(elements.instance);
    const auto find_optional = [this](std::string_view stem) {
      const int id = Look(mjOBJ_ACTUATOR, stem);
      return id < 0 ? -1 : model_.actuator_ctrladr[id];
    };
    std::transform(kOffsetNames.begin(), kOffsetNames.end(), elements.offset_controls.begin(),
                   find_optional);
    std::transform(kRateNames.begin(), kRateNames.end(), elements.rate_controls.begin(),
                   find_optional);
  }

  // Throws if an instance is configured for the other side: it would drive the mirror image.
  void CheckSide(int instance) const {
    const char* const text = mj_getPluginConfig(&model_, instance, kSideKey);
    const std::string configured(text == nullptr || *text == '\0' ? kSideNames.front()
                                                                  : std::string_view(text));
    const std::string own(Name(side_));
    if (configured != own) {
      throw InputError(model_name_ + ": the plugin's instance \"" +
                       (model_.names + model_.name_pluginadr[instance]) + "\" moves a " +
                       configured + " shoulder, and its elements end in " +
                       std::string(kSideSuffixes[static_cast<std::size_t>(side_)]) +
                       ". Set <config key=\"" + kSideKey + "\" value=\"" + own +
                       "\"/>, or make the model anew with girdle generate");
    }
  }

  void FindLoop(ShoulderElements& elements) const {
    for (std::size_t i = 0; i < kTranslationNames.size(); ++i) {
      elements.place_qpos[i] = model_.jnt_qposadr[Find(mjOBJ_JOINT, "joint", kTranslationNames[i])];
      elements.place_controls[i] =
          elements.lead == Lead::kScapula ? Control(kTranslationNames[i]) : -1;
    }
    elements.connect = Find(mjOBJ_EQUALITY, "equality", kConnectName);
  }

  void FindSensor(ShoulderElements& elements) const {
    const int sensor = Find(mjOBJ_SENSOR, "sensor", kRhythmName);
    if (model_.sensor_type[sensor] != mjSENS_PLUGIN ||
        model_.sensor_plugin[sensor] != elements.instance) {
      const std::string name = SidedName(kRhythmName, side_);
      throw InputError(model_name_ + ": sensor \"" + name + "\" is not one of the plugin " +
                       kPluginName + ". Make it <plugin name=\"" + name + "\" instance=\"" + name +
                       "\"/>, or make the model anew with girdle generate");
    }
    elements.sensor = model_.sensor_adr[sensor];
  }

  const mjModel& model_;
  const std::string& model_name_;
  Side side_;
};

}  // namespace

std::string_view SiteStem(std::size_t site) {
  return site < kLandmarkCount ? kLandmarks[site].name : kJointSites[site - kLandmarkCount].child;
}

std::vector<ShoulderElements> FindShoulders(const mjModel& model, const std::string& model_name) {
  std::vector<ShoulderElements> shoulders;
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const ElementFinder finder(model, model_name, side);
    if (finder.Look(mjOBJ_BODY, kSegmentNames[1]) >= 0 ||
        finder.Look(mjOBJ_JOINT, kCoordinateNames.front()) >= 0 ||
        finder.Look(mjOBJ_ACTUATOR, kCommandNames.front()) >= 0) {
      shoulders.push_back(finder.FindAll());
    }
  }
  if (shoulders.empty()) {
    // FindAll throws, and names the element of a right shoulder that is missing.
    shoulders.push_back(ElementFinder(model, model_name, Side::kRight).FindAll());
  }
  return shoulders;
}

}  // namespace girdle
