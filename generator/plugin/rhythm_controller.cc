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

namespace girdle {
namespace {

std::string ActuatorName(const mjModel& model, int actuator) {
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
std::size_t TakeRole(const mjModel& model, int actuator,
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

// The first `needed` roles have to be taken.
template <std::size_t N>
void CheckTaken(const std::array<std::string_view, N>& roles, const std::array<bool, N>& taken,
                std::size_t needed, const char* kind, const char* example_attributes) {
  for (std::size_t role = 0; role < needed; ++role) {
    if (!taken[role]) {
      const std::string name(roles[role]);
      throw std::runtime_error("no " + std::string(kind) + " for " + name +
                               ". Add <plugin name=\"" + name + "_r\" instance=\"...\" " +
                               example_attributes + "/> to <actuator>");
    }
  }
}

bool IsCommand(const mjModel& model, int actuator) {
  const mjtNum* gear = model.actuator_gear + 6 * model.actuator_outadr[actuator];
  return std::all_of(gear, gear + 6, [](mjtNum value) { return value == 0; });
}

Quaternion BodyRotation(const mjData& data, int body) noexcept {
  const mjtNum* q = data.xquat + 4 * body;
  return {q[0], q[1], q[2], q[3]};
}

bool IsNumber(const ArmCommand& command) noexcept {
  return !std::isnan(command.elevation_rad) && !std::isnan(command.plane_rad) &&
         !std::isnan(command.axial_rad) && !std::isnan(command.shrug_rad) &&
         !std::isnan(command.protraction_rad);
}

}  // namespace

double RhythmController::Control::Read(const mjModel& model, const mjData& data) const noexcept {
  const double value = Raw(data);
  if (!exists() || model.actuator_ctrllimited[address] == 0 ||
      (model.opt.disableflags & mjDSBL_CLAMPCTRL) != 0) {
    return value;
  }
  const mjtNum* range = model.actuator_ctrlrange + 2 * address;
  return std::clamp(value, range[0], range[1]);
}

double RhythmController::Control::ReadFinite(const mjModel& model,
                                             const mjData& data) const noexcept {
  const double value = Read(model, data);
  return std::isfinite(value) ? value : 0;
}

// The bits of the option stand for the first groups; other groups cannot be disabled.
bool RhythmController::Servo::IsDisabled(const mjModel& model) const noexcept {
  constexpr int kBits = 31;
  return group >= 0 && group < kBits && ((model.opt.disableactuator >> group) & 1) != 0;
}

RhythmController::RhythmController(const mjModel& model, int instance, const RhythmConfig& config) {
  std::array<bool, kAllCommandCount> has_command{};
  std::array<bool, kCoordinateCount> has_servo{};
  for (int actuator = 0; actuator < model.nactuator; ++actuator) {
    if (model.actuator_plugin[actuator] != instance) {
      continue;
    }
    if (IsCommand(model, actuator)) {
      AddCommand(
          model, actuator,
          TakeRole(model, actuator, kAllCommandNames, has_command, "command actuator (gear 0)"));
    } else {
      AddServo(model, actuator, TakeRole(model, actuator, kCoordinateNames, has_servo, "servo"),
               config);
    }
  }
  CheckTaken(kAllCommandNames, has_command, kCommandCount, "command actuator",
             "joint=\"...\" gear=\"0\"");
  CheckTaken(kCoordinateNames, has_servo, kCoordinateCount, "servo", "joint=\"...\"");
  FindSensors(model, instance);
  const auto first_rate = has_command.begin() + kCommandCount + kOffsetCount;
  has_rates_ = std::any_of(first_rate, has_command.end(), [](bool has) { return has; });
  if (has_rates_ && config.options.interpolation != Interpolation::kSmooth) {
    throw std::runtime_error(
        "there are rate commands (elevation_rate and so on), and the interpolation is " +
        std::string(Name(config.options.interpolation)) +
        ", which has no rates. Remove them, or use the interpolation smooth");
  }
  rhythm_ = ConfiguredRhythm(config, RangesOf(model));
  solved_.target_rad = AnglesFromPose(rhythm_->SolvePose(solved_command_, &solved_.used));
}

void RhythmController::AddCommand(const mjModel& model, int actuator, std::size_t role) {
  commands_[role] = {model.actuator_ctrladr[actuator]};
}

void RhythmController::AddServo(const mjModel& model, int actuator, std::size_t role,
                                const RhythmConfig& config) {
  const int joint = model.actuator_trnid[2 * actuator];
  if (model.actuator_trntype[actuator] != mjTRN_JOINT || model.jnt_type[joint] != mjJNT_HINGE) {
    throw std::runtime_error(ActuatorName(model, actuator) +
                             " does not act on a hinge. Give it joint=\"" +
                             std::string(kCoordinateNames[role]) + "_r\", a hinge");
  }
  const int output = model.actuator_outadr[actuator];
  if (model.actuator_gear[6 * output] != 1) {
    throw std::runtime_error(ActuatorName(model, actuator) + " has gear " +
                             std::to_string(model.actuator_gear[6 * output]) +
                             ", expected 1 (or 0 for a command). Remove gear and set kp instead");
  }
  servos_[role] = {model.jnt_qposadr[joint],
                   model.jnt_dofadr[joint],
                   output,
                   {model.actuator_ctrladr[actuator]},
                   config.stiffness_N_m_per_rad[role],
                   model.actuator_group[actuator]};
  // The first hinge of SC turns the clavicle in the thorax, the last of GH the humerus.
  if (role == 0) {
    thorax_body_ = model.body_parentid[model.jnt_bodyid[joint]];
  } else if (role == kGhAxialIndex) {
    humerus_body_ = model.jnt_bodyid[joint];
  }
}

void RhythmController::FindSensors(const mjModel& model, int instance) {
  for (int sensor = 0; sensor < model.nsensor; ++sensor) {
    if (model.sensor_type[sensor] == mjSENS_PLUGIN && model.sensor_plugin[sensor] == instance) {
      sensors_.push_back({model.sensor_adr[sensor], model.sensor_cutoff[sensor]});
    }
  }
}

JointRanges RhythmController::RangesOf(const mjModel& model) const noexcept {
  JointRanges ranges = ShoulderRhythm::Unbounded();
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    const int joint = model.dof_jntid[servos_[k].dof_address];
    if (model.jnt_limited[joint] != 0) {
      ranges[k] = {model.jnt_range[2 * joint], model.jnt_range[2 * joint + 1]};
    }
  }
  return ranges;
}

ArmCommand RhythmController::ReadCommand(const mjModel& model, const mjData& data) const noexcept {
  return {commands_[0].Read(model, data), commands_[1].Read(model, data),
          commands_[2].Read(model, data), commands_[3].Read(model, data),
          commands_[4].Read(model, data)};
}

ArmAngles RhythmController::Reached(const mjData& data) const noexcept {
  return ArmAnglesFromRotation(glm::conjugate(BodyRotation(data, thorax_body_)) *
                               BodyRotation(data, humerus_body_));
}

const RhythmController::Aim& RhythmController::AimFor(const mjModel& model,
                                                      const mjData& data) noexcept {
  const ArmCommand command = ReadCommand(model, data);
  if (command == solved_command_) {
    return solved_;
  }
  if (!IsNumber(command)) {
    const ArmAngles reached = Reached(data);
    holding_ = {{reached.elevation_rad, reached.plane_rad}, {}, true};
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      holding_.target_rad[k] = data.qpos[servos_[k].qpos_address];
    }
    return holding_;
  }
  solved_command_ = command;
  solved_.target_rad = AnglesFromPose(rhythm_->SolvePose(command, &solved_.used));
  return solved_;
}

// d target / dt = (d target / d elevation) elevation_rate + (d target / d plane) plane_rate; an
// axial turn adds to the last coordinate. A command that is held back by its range does not move.
JointAngles RhythmController::TargetRates(const mjModel& model, const mjData& data,
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
    const std::optional<AngleRates> angles = rhythm_->SolveAngleRates(command);
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

bool RhythmController::FeedsForward(const mjModel& model) const noexcept {
  return has_rates_ && (model.opt.disableflags & mjDSBL_DAMPER) == 0;
}

void RhythmController::Actuate(const mjModel& model, mjData& data) noexcept {
  const Aim& aim = AimFor(model, data);
  JointAngles rates{};
  if (FeedsForward(model) && !aim.holds) {
    rates = TargetRates(model, data, aim);
  }
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    const Servo& servo = servos_[k];
    const double error_rad =
        aim.target_rad[k] + servo.trim.ReadFinite(model, data) - data.qpos[servo.qpos_address];
    const double force_N_m =
        servo.stiffness_N_m_per_rad * error_rad + model.dof_damping[servo.dof_address] * rates[k];
    data.actuator_force[servo.force_address] =
        std::isfinite(force_N_m) && !aim.holds && !servo.IsDisabled(model) ? force_N_m : 0;
  }
  if (!sensors_.empty() && (model.opt.disableflags & mjDSBL_SENSOR) == 0 &&
      !SensorsShow(data, aim)) {
    WriteSensors(data, aim);
  }
}

void RhythmController::Sense(const mjModel& model, mjData& data) noexcept {
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
void RhythmController::WriteSensors(mjData& data, const Aim& aim) const noexcept {
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
double RhythmController::DistanceOf(const mjData& data, const Aim& aim) const noexcept {
  const double elevation_rad = commands_[0].Raw(data);
  const double plane_rad = commands_[1].Raw(data);
  return std::isnan(elevation_rad) || std::isnan(plane_rad)
             ? rhythm_->DistanceOutside(aim.used.elevation_rad, aim.used.plane_rad)
             : rhythm_->DistanceOutside(elevation_rad, plane_rad);
}

bool RhythmController::SensorsShow(const mjData& data, const Aim& aim) const noexcept {
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
