// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "plugin/rhythm_controller.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "text/number_text.h"

namespace girdle {
namespace {

std::string ActuatorName(const ModelView& model, int actuator) {
  const std::string name = model.names + model.name_actuatoradr[actuator];
  return name.empty() ? "actuator " + std::to_string(actuator) : "actuator \"" + name + "\"";
}

// Index of the role that stands last in an actuator's name; the longer one where two end together.
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

Quaternion BodyRotation(const DataView& data, int body) noexcept {
  const mjtNum* q = data.xquat + 4 * body;
  return {q[0], q[1], q[2], q[3]};
}

bool IsNumber(const ArmCommand& command) noexcept {
  return !std::isnan(command.elevation_rad) && !std::isnan(command.plane_rad) &&
         !std::isnan(command.axial_rad) && !std::isnan(command.shrug_rad) &&
         !std::isnan(command.protraction_rad);
}

}  // namespace

double RhythmController::Control::Read(const ModelView& model,
                                       const DataView& data) const noexcept {
  const double value = Raw(data);
  if (!exists() || model.actuator_ctrllimited[address] == 0 ||
      model.Disables(model.engine->disable_clampctrl)) {
    return value;
  }
  const mjtNum* range = model.actuator_ctrlrange + 2 * address;
  return std::clamp(value, range[0], range[1]);
}

double RhythmController::Control::ReadFinite(const ModelView& model,
                                             const DataView& data) const noexcept {
  const double value = Read(model, data);
  return std::isfinite(value) ? value : 0;
}

// The bits of the option stand for the first groups; other groups cannot be disabled.
bool RhythmController::Servo::IsDisabled(const ModelView& model) const noexcept {
  constexpr int kBits = 31;
  return group >= 0 && group < kBits && ((model.disableactuator >> group) & 1) != 0;
}

RhythmController::RhythmController(const ModelView& model, int instance, const RhythmConfig& config)
    : side_(config.side) {
  std::array<bool, kAllCommandCount> has_command{};
  std::array<bool, kServoRoleCount> has_servo{};
  for (int actuator = 0; actuator < model.nactuator; ++actuator) {
    if (model.actuator_plugin[actuator] != instance) {
      continue;
    }
    if (IsCommand(model, actuator)) {
      AddCommand(
          model, actuator,
          TakeRole(model, actuator, kAllCommandNames, has_command, "command actuator (gear 0)"));
    } else {
      const std::size_t role = TakeRole(model, actuator, kServoRoles, has_servo, "servo");
      AddServo(model, actuator, role, config);
    }
  }
  for (std::size_t role = 0; role < kCommandCount; ++role) {
    CheckTaken(kAllCommandNames, has_command, role, side_, "command actuator",
               "joint=\"...\" gear=\"0\"");
  }
  const Assembly assembly = CheckServos(has_servo);
  CheckStiffness(config);
  FindSensors(model, instance);
  const auto first_rate = has_command.begin() + kCommandCount + kOffsetCount;
  has_rates_ = std::any_of(first_rate, has_command.end(), [](bool has) { return has; });
  const ResolvedRhythm resolved = Resolve(config.rhythm);
  if (has_rates_ && resolved.options.interpolation != Interpolation::kSmooth) {
    throw std::runtime_error(
        "there are rate commands (elevation_rate and so on), and the interpolation is " +
        std::string(Name(resolved.options.interpolation)) +
        ", which has no rates. Remove them, or use the interpolation smooth");
  }
  if (has_rates_ && assembly == Assembly::kLoop) {
    throw std::runtime_error(
        "there are rate commands (elevation_rate and so on), and the scapula hangs from the thorax "
        "(st_ servos), where they are not known. Remove them");
  }
  try {
    const JointRanges ranges = RangesOf(model);
    rhythm_.emplace(MakeRhythm(resolved, ranges, "config: "), assembly,
                    ScapulothoracicRanges{ranges[3], ranges[4], ranges[5]});
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error("st_ servos: " + std::string(error.what()));
  }
  if (has_translations_) {
    FindClavicle(model);
  }
  SolveAim(solved_command_);
}

// The first nine are a tree's; a loop has those of the scapula on the thorax instead of AC's, and
// three for its place as well or not.
Assembly RhythmController::CheckServos(const std::array<bool, kServoRoleCount>& has_servo) {
  // The first of three roles that has a servo.
  const auto first_of = [&has_servo](std::size_t begin) -> std::optional<std::size_t> {
    for (std::size_t role = begin; role < begin + 3; ++role) {
      if (has_servo[role]) {
        return role;
      }
    }
    return std::nullopt;
  };
  const auto ac = first_of(kJointCount);
  const auto st = first_of(kScapulothoracicRole);
  has_translations_ = first_of(kTranslationRole).has_value();
  if (ac && st) {
    throw std::runtime_error("servos of both " + std::string(kServoRoles[*ac]) + " and " +
                             std::string(kServoRoles[*st]) +
                             ": the scapula hangs either from the clavicle (ac_ servos) or from "
                             "the thorax (st_ servos). Remove one kind");
  }
  if (has_translations_ && !st) {
    throw std::runtime_error(
        "servos for the scapula's place (st_lateral and so on), but none for its orientation. Add "
        "st_internal_rotation, st_upward_rotation and st_tilt");
  }
  const auto expect_three = [&](std::size_t begin) {
    for (std::size_t role = begin; role < begin + 3; ++role) {
      CheckTaken(kServoRoles, has_servo, role, side_, "servo", "joint=\"...\"");
    }
  };
  expect_three(0);
  expect_three(st ? kScapulothoracicRole : kJointCount);
  expect_three(kCoordinateCount - 3);
  if (has_translations_) {
    expect_three(kTranslationRole);
  }
  return st ? Assembly::kLoop : Assembly::kTree;
}

// Without a servo nothing says where a joint is, but where the scapula leads the clavicle.
void RhythmController::CheckStiffness(const RhythmConfig& config) const {
  std::string text;
  bool is_held = true;
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    const double stiffness = config.stiffness_N_m_per_rad[k];
    text += (text.empty() ? "" : " ") + NumberText(stiffness);
    is_held = is_held && (stiffness > 0 || (has_translations_ && k < 2));
  }
  if (!is_held) {
    throw std::runtime_error(std::string(kStiffnessKey) + " is \"" + text +
                             "\", expected one positive number of N m/rad, or nine in the order "
                             "sc, ac, gh. 0 is for sc_protraction and sc_elevation alone, where "
                             "st_ servos drive the scapula's place");
  }
}

// Where the clavicle begins in the thorax, and where on it the scapula hangs: from the connect of
// the two bones. A left shoulder's are taken to the right.
void RhythmController::FindClavicle(const ModelView& model) {
  const int clavicle = model.jnt_bodyid[model.dof_jntid[servos_[0].dof_address]];
  const int scapula = model.jnt_bodyid[model.dof_jntid[servos_[kCoordinateCount].dof_address]];
  const auto canonical = [this](const mjtNum* p) {
    const Vector3 position{p[0], p[1], p[2]};
    return side_ == Side::kRight ? position : Mirrored(position);
  };
  p_TC_m_ = canonical(model.body_pos + 3 * clavicle);
  for (int equality = 0; equality < model.neq; ++equality) {
    if (model.eq_type[equality] != model.engine->equality_connect ||
        model.eq_objtype[equality] != model.engine->object_site) {
      continue;
    }
    const std::array<int, 2> sites = {model.eq_obj1id[equality], model.eq_obj2id[equality]};
    const std::array<int, 2> bodies = {model.site_bodyid[sites[0]], model.site_bodyid[sites[1]]};
    for (const std::size_t own : {std::size_t{0}, std::size_t{1}}) {
      if (bodies[own] == clavicle && bodies[1 - own] == scapula) {
        p_CS_m_ = canonical(model.site_pos + 3 * sites[own]);
        return;
      }
    }
  }
  throw std::runtime_error(
      "servos for the scapula's place (st_lateral and so on), but no <connect site1=\"...\" "
      "site2=\"...\"/> of clavicle and scapula in <equality>, which says where the AC joint is. "
      "Add "
      "one");
}

void RhythmController::SolveAim(const ArmCommand& command) noexcept {
  solved_command_ = command;
  const ShoulderPose pose = rhythm_->SolvePose(command, &solved_.used);
  solved_.target_rad = DrivenAngles(rhythm_->assembly(), pose);
  if (has_translations_) {
    solved_.target_p_TS_m = p_TC_m_ + pose.q_TC * p_CS_m_;
  }
}

void RhythmController::AddCommand(const ModelView& model, int actuator, std::size_t role) {
  commands_[role] = {model.ControlOf(actuator)};
}

void RhythmController::AddServo(const ModelView& model, int actuator, std::size_t role,
                                const RhythmConfig& config) {
  const int joint = model.actuator_trnid[2 * actuator];
  const bool is_translation = role >= kTranslationRole;
  const char* const kind = is_translation ? "slide" : "hinge";
  if (model.actuator_trntype[actuator] != model.engine->transmission_joint ||
      model.jnt_type[joint] !=
          (is_translation ? model.engine->joint_slide : model.engine->joint_hinge)) {
    throw std::runtime_error(ActuatorName(model, actuator) + " does not act on a " + kind +
                             ". Give it joint=\"" + SidedName(kServoRoles[role], side_) + "\", a " +
                             kind);
  }
  const int output = model.OutputOf(actuator);
  if (model.actuator_gear[6 * output] != 1) {
    throw std::runtime_error(ActuatorName(model, actuator) + " has gear " +
                             std::to_string(model.actuator_gear[6 * output]) +
                             ", expected 1 (or 0 for a command). Remove gear and set kp instead");
  }
  // Coordinates in their order, AC's or the scapula's on the thorax in the same places; then the
  // scapula's place.
  const std::size_t slot = role < kScapulothoracicRole ? role
                           : is_translation            ? kCoordinateCount + role - kTranslationRole
                                                       : kJointCount + role - kScapulothoracicRole;
  servos_[slot] = {
      model.jnt_qposadr[joint],
      model.jnt_dofadr[joint],
      output,
      {model.ControlOf(actuator)},
      is_translation ? config.translation_stiffness_N_per_m : config.stiffness_N_m_per_rad[slot],
      model.actuator_group[actuator]};
  // The first hinge of SC turns the clavicle in the thorax, the last of GH the humerus.
  if (role == 0) {
    thorax_body_ = model.body_parentid[model.jnt_bodyid[joint]];
  } else if (role == kGhAxialIndex) {
    humerus_body_ = model.jnt_bodyid[joint];
  }
}

void RhythmController::FindSensors(const ModelView& model, int instance) {
  for (int sensor = 0; sensor < model.nsensor; ++sensor) {
    if (model.sensor_type[sensor] == model.engine->sensor_plugin_type &&
        model.sensor_plugin[sensor] == instance) {
      sensors_.push_back({model.sensor_adr[sensor], model.sensor_cutoff[sensor]});
    }
  }
}

JointRanges RhythmController::RangesOf(const ModelView& model) const noexcept {
  JointRanges ranges = ShoulderRhythm::Unbounded();
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    const int joint = model.dof_jntid[servos_[k].dof_address];
    if (model.jnt_limited[joint] != 0) {
      ranges[k] = {model.jnt_range[2 * joint], model.jnt_range[2 * joint + 1]};
    }
  }
  return ranges;
}

ArmCommand RhythmController::ReadCommand(const ModelView& model,
                                         const DataView& data) const noexcept {
  return {commands_[0].Read(model, data), commands_[1].Read(model, data),
          commands_[2].Read(model, data), commands_[3].Read(model, data),
          commands_[4].Read(model, data)};
}

ArmAngles RhythmController::Reached(const DataView& data) const noexcept {
  const Quaternion q_TH =
      glm::conjugate(BodyRotation(data, thorax_body_)) * BodyRotation(data, humerus_body_);
  return ArmAnglesFromRotation(side_ == Side::kRight ? q_TH : Mirrored(q_TH));
}

const RhythmController::Aim& RhythmController::AimFor(const ModelView& model,
                                                      const DataView& data) noexcept {
  const ArmCommand command = ReadCommand(model, data);
  if (command == solved_command_) {
    return solved_;
  }
  if (!IsNumber(command)) {
    const ArmAngles reached = Reached(data);
    holding_ = {{reached.elevation_rad, reached.plane_rad}, {}, {0, 0, 0}, true};
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      holding_.target_rad[k] = data.qpos[servos_[k].qpos_address];
    }
    return holding_;
  }
  SolveAim(command);
  return solved_;
}

// d target / dt = (d target / d elevation) elevation_rate + (d target / d plane) plane_rate; an
// axial turn adds to the last coordinate. A command that is held back by its range does not move.
JointAngles RhythmController::TargetRates(const ModelView& model, const DataView& data,
                                          const Aim& aim) const noexcept {
  const ArmCommand command = ReadCommand(model, data);
  const std::array<double, kRateCount> read = {command.elevation_rad, command.plane_rad,
                                               command.axial_rad};
  std::array<double, kRateCount> command_rate{};
  for (std::size_t i = 0; i < kRateCount; ++i) {
    if (commands_[i].Raw(data) == read[i]) {
      command_rate[i] = commands_[kCommandCount + kOffsetCount + i].ReadFinite(model, data);
    }
  }
  const auto [elevation_rate, plane_rate, axial_rate] = command_rate;
  JointAngles rates{};
  if (elevation_rate != 0 || plane_rate != 0) {
    const std::optional<AngleRates> angles = rhythm_->rhythm().SolveAngleRates(command);
    for (std::size_t k = 0; angles && k < kCoordinateCount; ++k) {
      rates[k] = angles->by_elevation[k] * elevation_rate + angles->by_plane[k] * plane_rate;
    }
  }
  // At the end of its range the humerus does not turn further.
  if (aim.used.axial_rad == command.axial_rad) {
    rates[kGhAxialIndex] += axial_rate;
  }
  return rates;
}

bool RhythmController::FeedsForward(const ModelView& model) const noexcept {
  return has_rates_ && !model.Disables(model.engine->disable_damper);
}

void RhythmController::Actuate(const ModelView& model, const DataView& data) noexcept {
  const Aim& aim = AimFor(model, data);
  JointAngles rates{};
  if (FeedsForward(model) && !aim.holds) {
    rates = TargetRates(model, data, aim);
  }
  const auto drive = [&](const Servo& servo, double target, double rate) {
    const double error =
        target + servo.trim.ReadFinite(model, data) - data.qpos[servo.qpos_address];
    const double force = servo.stiffness * error + model.dof_damping[servo.dof_address] * rate;
    data.actuator_force[servo.force_address] =
        std::isfinite(force) && !aim.holds && !servo.IsDisabled(model) ? force : 0;
  };
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    drive(servos_[k], aim.target_rad[k], rates[k]);
  }
  for (int i = 0; has_translations_ && i < 3; ++i) {
    drive(servos_[kCoordinateCount + static_cast<std::size_t>(i)], aim.target_p_TS_m[i], 0);
  }
  if (!sensors_.empty() && !model.Disables(model.engine->disable_sensor) &&
      !SensorsShow(data, aim)) {
    WriteSensors(data, aim);
  }
}

void RhythmController::Sense(const ModelView& model, const DataView& data) noexcept {
  const Aim& aim = AimFor(model, data);
  WriteSensors(data, aim);
  const ArmAngles reached = Reached(data);
  for (const Sensor& sensor : sensors_) {
    mjtNum* values = data.sensordata + sensor.address;
    values[sensor_layout::kReached] = sensor.Cut(reached.elevation_rad);
    values[sensor_layout::kReached + 1] = sensor.Cut(reached.plane_rad);
  }
}

// What follows from the commands; where the arm is does not.
void RhythmController::WriteSensors(const DataView& data, const Aim& aim) const noexcept {
  const double distance_rad = DistanceOf(data, aim);
  for (const Sensor& sensor : sensors_) {
    mjtNum* values = data.sensordata + sensor.address;
    values[sensor_layout::kCommanded] = sensor.Cut(aim.used.elevation_rad);
    values[sensor_layout::kCommanded + 1] = sensor.Cut(aim.used.plane_rad);
    values[sensor_layout::kCommanded + 2] = sensor.Cut(aim.used.axial_rad);
    double error_rad = 0;
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      error_rad = aim.target_rad[k] - data.qpos[servos_[k].qpos_address];
      values[sensor_layout::kTarget + k] = sensor.Cut(aim.target_rad[k]);
      values[sensor_layout::kError + k] = sensor.Cut(error_rad);
    }
    // The axial turn reached on top of the measured one: what was commanded less what the last
    // coordinate is still missing.
    values[sensor_layout::kReached + 2] = sensor.Cut(aim.used.axial_rad - error_rad);
    values[sensor_layout::kDistance] = sensor.Cut(distance_rad);
  }
}

// Measured from the controls themselves: their ranges may be narrower.
double RhythmController::DistanceOf(const DataView& data, const Aim& aim) const noexcept {
  const double elevation_rad = commands_[0].Raw(data);
  const double plane_rad = commands_[1].Raw(data);
  return std::isnan(elevation_rad) || std::isnan(plane_rad)
             ? rhythm_->rhythm().DistanceOutside(aim.used.elevation_rad, aim.used.plane_rad)
             : rhythm_->rhythm().DistanceOutside(elevation_rad, plane_rad);
}

bool RhythmController::SensorsShow(const DataView& data, const Aim& aim) const noexcept {
  const double distance_rad = DistanceOf(data, aim);
  return std::all_of(sensors_.begin(), sensors_.end(), [&](const Sensor& sensor) {
    const mjtNum* values = data.sensordata + sensor.address;
    return values[sensor_layout::kCommanded] == sensor.Cut(aim.used.elevation_rad) &&
           values[sensor_layout::kCommanded + 1] == sensor.Cut(aim.used.plane_rad) &&
           values[sensor_layout::kCommanded + 2] == sensor.Cut(aim.used.axial_rad) &&
           values[sensor_layout::kDistance] == sensor.Cut(distance_rad) &&
           std::equal(
               aim.target_rad.begin(), aim.target_rad.end(), values + sensor_layout::kTarget,
               [&sensor](double target, mjtNum value) { return value == sensor.Cut(target); });
  });
}

}  // namespace girdle
