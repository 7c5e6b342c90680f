// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "plugin/rhythm_binding.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "text/number_text.h"

namespace girdle {
namespace {

// Roles of servos: nine coordinates of a tree, three of a loop, and three of the scapula's place.
constexpr std::size_t kScapulothoracicRole = kCoordinateCount;
constexpr std::size_t kTranslationRole = kScapulothoracicRole + 3;
constexpr std::size_t kServoRoleCount = kTranslationRole + 3;
constexpr std::array<std::string_view, kServoRoleCount> kServoRoles = [] {
  std::array<std::string_view, kServoRoleCount> roles{};
  std::copy(kCoordinateNames.begin(), kCoordinateNames.end(), roles.begin());
  std::copy(kScapulothoracicNames.begin(), kScapulothoracicNames.end(),
            roles.begin() + kScapulothoracicRole);
  std::copy(kTranslationNames.begin(), kTranslationNames.end(), roles.begin() + kTranslationRole);
  return roles;
}();

std::string ActuatorName(const ModelView& model, int actuator) {
  const std::string name = model.names + model.name_actuatoradr[actuator];
  return name.empty() ? "actuator " + std::to_string(actuator) : "actuator \"" + name + "\"";
}

// Returns the index of the role that ends last in an actuator's name. If two end at one place,
// returns the longer one.
template <std::size_t N>
std::optional<std::size_t> RoleOf(std::string_view actuator_name,
                                  const std::array<std::string_view, N>& roles) {
  std::optional<std::size_t> best;
  std::size_t best_end = 0;
  for (std::size_t role = 0; role < N; ++role) {
    const std::size_t begin = actuator_name.rfind(roles[role]);
    if (begin == std::string_view::npos) {
      continue;
    }
    const std::size_t end = begin + roles[role].size();
    if (!best || end > best_end || (end == best_end && roles[role].size() > roles[*best].size())) {
      best = role;
      best_end = end;
    }
  }
  return best;
}

template <std::size_t N>
std::size_t TakeRole(const ModelView& model, int actuator,
                     const std::array<std::string_view, N>& roles, std::array<bool, N>& taken,
                     const char* kind) {
  const auto role = RoleOf(model.names + model.name_actuatoradr[actuator], roles);
  if (!role) {
    std::string known;
    for (const std::string_view name : roles) {
      known += " " + std::string(name);
    }
    throw std::runtime_error(ActuatorName(model, actuator) + " is a " + kind +
                             ", but its name has none of:" + known + ". Name it after one of them");
  }
  if (taken[*role]) {
    throw std::runtime_error(ActuatorName(model, actuator) + " is a second " + kind + " for " +
                             std::string(roles[*role]) + ". Remove one of the two");
  }
  taken[*role] = true;
  return *role;
}

template <std::size_t N>
void CheckTaken(const std::array<std::string_view, N>& roles, const std::array<bool, N>& taken,
                std::size_t role, Side side, const char* kind, const char* example_attributes) {
  if (!taken[role]) {
    throw std::runtime_error("no " + std::string(kind) + " for " + std::string(roles[role]) +
                             ". Add <plugin name=\"" + SidedName(roles[role], side) +
                             "\" instance=\"...\" " + example_attributes + "/> to <actuator>");
  }
}

bool IsCommand(const ModelView& model, int actuator) {
  const mjtNum* gear = model.actuator_gear + 6 * model.OutputOf(actuator);
  return std::all_of(gear, gear + 6, [](mjtNum value) { return value == 0; });
}

class RhythmBinder {
 public:
  RhythmBinder(const ModelView& model, int instance, const RhythmConfig& config)
      : model_(model), instance_(instance), config_(config) {}

  [[nodiscard]] RhythmBinding Bind() {
    binding_.side = config_.side;
    FindActuators();
    CheckCommands();
    CheckServos();
    CheckStiffness();
    CheckRates();
    FindSensors();
    FindRanges();
    FindClavicle();
    return binding_;
  }

 private:
  void FindActuators() {
    if (std::find(model_.actuator_plugin, model_.actuator_plugin + model_.nactuator, instance_) ==
        model_.actuator_plugin + model_.nactuator) {
      throw std::runtime_error(
          "it has lost its actuators, as where a shoulder was deleted from a model. Delete this "
          "instance and its sensor as well, or make the model with girdle generate --side");
    }
    for (int actuator = 0; actuator < model_.nactuator; ++actuator) {
      if (model_.actuator_plugin[actuator] != instance_) {
        continue;
      }
      if (IsCommand(model_, actuator)) {
        const std::size_t role =
            TakeRole(model_, actuator, kAllCommandNames, has_command_, "command actuator (gear 0)");
        binding_.commands[role] = {model_.ControlOf(actuator)};
      } else {
        AddServo(actuator, TakeRole(model_, actuator, kServoRoles, has_servo_, "servo"));
      }
    }
  }

  void AddServo(int actuator, std::size_t role) {
    const int joint = model_.actuator_trnid[2 * actuator];
    const bool is_translation = role >= kTranslationRole;
    const char* const kind = is_translation ? "slide" : "hinge";
    if (model_.actuator_trntype[actuator] != model_.engine->transmission_joint ||
        model_.jnt_type[joint] !=
            (is_translation ? model_.engine->joint_slide : model_.engine->joint_hinge)) {
      throw std::runtime_error(ActuatorName(model_, actuator) + " does not act on a " + kind +
                               ". Give it joint=\"" + SidedName(kServoRoles[role], config_.side) +
                               "\", a " + kind);
    }
    const int output = model_.OutputOf(actuator);
    if (model_.actuator_gear[6 * output] != 1) {
      throw std::runtime_error(ActuatorName(model_, actuator) + " has gear " +
                               std::to_string(model_.actuator_gear[6 * output]) +
                               ", expected 1 (or 0 for a command). Remove gear and set kp instead");
    }
    // AC's coordinates and those of the scapula on the thorax share slots: a model has only one of
    // the two.
    const std::size_t slot = role < kScapulothoracicRole ? role
                             : is_translation            ? role - kTranslationRole
                                              : kJointCount + role - kScapulothoracicRole;
    BoundServo& servo = is_translation ? binding_.place_servos[slot] : binding_.servos[slot];
    servo = {model_.jnt_qposadr[joint],
             model_.jnt_dofadr[joint],
             output,
             {model_.ControlOf(actuator)},
             is_translation ? config_.translation_stiffness_N_per_m
                            : config_.stiffness_N_m_per_rad[slot],
             model_.actuator_group[actuator]};
    // The first hinge of SC belongs to the clavicle, whose parent is the thorax. The last of GH
    // belongs to the humerus.
    if (role == 0) {
      binding_.clavicle_body = model_.jnt_bodyid[joint];
      binding_.thorax_body = model_.body_parentid[binding_.clavicle_body];
    } else if (slot == kJointCount && !is_translation) {
      binding_.scapula_body = model_.jnt_bodyid[joint];
    } else if (role == kGhAxialIndex) {
      binding_.humerus_body = model_.jnt_bodyid[joint];
    }
  }

  void CheckCommands() const {
    for (std::size_t role = 0; role < kCommandCount; ++role) {
      CheckTaken(kAllCommandNames, has_command_, role, config_.side, "command actuator",
                 "joint=\"...\" gear=\"0\"");
    }
  }

  // A tree has servos for the first nine roles. A loop has those of the scapula on the thorax in
  // place of AC's, and optionally three for the scapula's place.
  void CheckServos() {
    // Returns the first of three roles that has a servo.
    const auto first_of = [this](std::size_t begin) -> std::optional<std::size_t> {
      for (std::size_t role = begin; role < begin + 3; ++role) {
        if (has_servo_[role]) {
          return role;
        }
      }
      return std::nullopt;
    };
    const auto ac = first_of(kJointCount);
    const auto st = first_of(kScapulothoracicRole);
    binding_.has_place_servos = first_of(kTranslationRole).has_value();
    if (ac && st) {
      throw std::runtime_error("servos of both " + std::string(kServoRoles[*ac]) + " and " +
                               std::string(kServoRoles[*st]) +
                               ": the scapula hangs either from the clavicle (ac_ servos) or from "
                               "the thorax (st_ servos). Remove one kind");
    }
    if (binding_.has_place_servos && !st) {
      throw std::runtime_error(
          "servos for the scapula's place (st_lateral and so on), but none for its orientation. "
          "Add st_internal_rotation, st_upward_rotation and st_tilt");
    }
    const auto expect_three = [&](std::size_t begin) {
      for (std::size_t role = begin; role < begin + 3; ++role) {
        CheckTaken(kServoRoles, has_servo_, role, config_.side, "servo", "joint=\"...\"");
      }
    };
    expect_three(0);
    expect_three(st ? kScapulothoracicRole : kJointCount);
    expect_three(kCoordinateCount - 3);
    if (binding_.has_place_servos) {
      expect_three(kTranslationRole);
    }
    binding_.assembly = st ? Assembly::kLoop : Assembly::kTree;
  }

  // Throws if a joint has no stiffness: nothing would hold it. SC's first two joints may lack it if
  // the servos of the scapula's place move the clavicle.
  void CheckStiffness() const {
    std::string text;
    bool is_held = true;
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      const double stiffness = config_.stiffness_N_m_per_rad[k];
      text += (text.empty() ? "" : " ") + NumberText(stiffness);
      is_held = is_held && (stiffness > 0 || (binding_.has_place_servos && k < 2));
    }
    if (!is_held) {
      throw std::runtime_error(std::string(kStiffnessKey) + " is \"" + text +
                               "\", expected one positive number of N m/rad, or nine in the order "
                               "sc, ac, gh. 0 is for sc_protraction and sc_elevation alone, where "
                               "st_ servos drive the scapula's place");
    }
  }

  void CheckRates() {
    const auto first_rate = has_command_.begin() + kCommandCount + kOffsetCount;
    binding_.has_rates = std::any_of(first_rate, has_command_.end(), [](bool has) { return has; });
    if (binding_.has_rates && OptionsOf(config_.rhythm).interpolation != Interpolation::kSmooth) {
      throw std::runtime_error(
          "there are rate commands (elevation_rate and so on), and the interpolation is " +
          std::string(Name(OptionsOf(config_.rhythm).interpolation)) +
          ", which has no rates. Remove them, or use the interpolation smooth");
    }
    if (binding_.has_rates && binding_.assembly == Assembly::kLoop) {
      throw std::runtime_error(
          "there are rate commands (elevation_rate and so on), and the scapula hangs from the "
          "thorax (st_ servos), where they are not known. Remove them");
    }
  }

  void FindSensors() {
    for (int sensor = 0; sensor < model_.nsensor; ++sensor) {
      if (model_.sensor_type[sensor] == model_.engine->sensor_plugin_type &&
          model_.sensor_plugin[sensor] == instance_) {
        binding_.sensors.push_back({model_.sensor_adr[sensor], model_.sensor_cutoff[sensor]});
      }
    }
  }

  void FindRanges() {
    binding_.ranges = ShoulderRhythm::Unbounded();
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      const int joint = model_.dof_jntid[binding_.servos[k].dof_address];
      if (model_.jnt_limited[joint] != 0) {
        binding_.ranges[k] = {model_.jnt_range[2 * joint], model_.jnt_range[2 * joint + 1]};
      }
    }
  }

  // Finds the origin of the clavicle in the thorax, and that of the scapula on the clavicle. Points
  // of a left shoulder are mirrored to the right.
  void FindClavicle() {
    binding_.p_TC_m = ToTheRight(model_.body_pos + 3 * binding_.clavicle_body);
    if (binding_.assembly == Assembly::kLoop) {
      FindConnects();
    } else if (model_.body_parentid[binding_.scapula_body] == binding_.clavicle_body) {
      binding_.p_CS_m = ToTheRight(model_.body_pos + 3 * binding_.scapula_body);
    }
    if (binding_.has_place_servos && !binding_.p_CS_m) {
      throw std::runtime_error(
          "servos for the scapula's place (st_lateral and so on), but no <connect site1=\"...\" "
          "site2=\"...\"/> of clavicle and scapula in <equality>, which says where the AC joint "
          "is. Add one");
    }
  }

  [[nodiscard]] Vector3 ToTheRight(const mjtNum* p) const {
    return OnSide(config_.side, Vector3(p[0], p[1], p[2]));
  }

  // Finds the connects of the two bones, and the place of the first one on the clavicle.
  void FindConnects() {
    for (int equality = 0; equality < model_.neq; ++equality) {
      if (model_.eq_type[equality] != model_.engine->equality_connect ||
          model_.eq_objtype[equality] != model_.engine->object_site) {
        continue;
      }
      const std::array<int, 2> sites = {model_.eq_obj1id[equality], model_.eq_obj2id[equality]};
      const std::array<int, 2> bodies = {model_.site_bodyid[sites[0]],
                                         model_.site_bodyid[sites[1]]};
      for (const std::size_t own : {std::size_t{0}, std::size_t{1}}) {
        if (bodies[own] == binding_.clavicle_body && bodies[1 - own] == binding_.scapula_body) {
          if (binding_.closing_connects.empty()) {
            binding_.p_CS_m = ToTheRight(model_.site_pos + 3 * sites[own]);
          }
          binding_.closing_connects.push_back(equality);
        }
      }
    }
  }

  const ModelView& model_;
  int instance_;
  const RhythmConfig& config_;
  std::array<bool, kAllCommandCount> has_command_{};
  std::array<bool, kServoRoleCount> has_servo_{};
  RhythmBinding binding_;
};

}  // namespace

RhythmBinding BindRhythm(const ModelView& model, int instance, const RhythmConfig& config) {
  return RhythmBinder(model, instance, config).Bind();
}

}  // namespace girdle
