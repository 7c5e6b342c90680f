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

template <std::size_t N>
void CheckAllTaken(const std::array<std::string_view, N>& roles, const std::array<bool, N>& taken,
                   const char* kind, const char* example_attributes) {
  for (std::size_t role = 0; role < N; ++role) {
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

}  // namespace

double RhythmController::Control::Raw(const mjData& data) const noexcept {
  const mjtNum value = data.ctrl[address];
  return std::isfinite(value) ? value : 0;
}

double RhythmController::Control::Read(const mjModel& model, const mjData& data) const noexcept {
  const double value = Raw(data);
  if (model.actuator_ctrllimited[address] == 0 ||
      (model.opt.disableflags & mjDSBL_CLAMPCTRL) != 0) {
    return value;
  }
  const mjtNum* range = model.actuator_ctrlrange + 2 * address;
  return std::clamp(value, range[0], range[1]);
}

RhythmController::RhythmController(const mjModel& model, int instance, const RhythmConfig& config)
    : rhythm_(config.rhythm) {
  std::array<bool, kCommandCount> has_command{};
  std::array<bool, kCoordinateCount> has_servo{};
  for (int actuator = 0; actuator < model.nactuator; ++actuator) {
    if (model.actuator_plugin[actuator] != instance) {
      continue;
    }
    if (IsCommand(model, actuator)) {
      AddCommand(
          model, actuator,
          TakeRole(model, actuator, kCommandNames, has_command, "command actuator (gear 0)"));
    } else {
      AddServo(model, actuator, TakeRole(model, actuator, kCoordinateNames, has_servo, "servo"),
               config);
    }
  }
  CheckAllTaken(kCommandNames, has_command, "command actuator", "joint=\"...\" gear=\"0\"");
  CheckAllTaken(kCoordinateNames, has_servo, "servo", "joint=\"...\"");
  solved_target_rad_ = AnglesFromPose(rhythm_.Solve(solved_command_).pose);
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
                   output,
                   {model.actuator_ctrladr[actuator]},
                   config.stiffness_N_m_per_rad[role]};
  // The first hinge of SC turns the clavicle in the thorax, the last of GH the humerus.
  if (role == 0) {
    thorax_body_ = model.body_parentid[model.jnt_bodyid[joint]];
  } else if (role == kGhAxialIndex) {
    humerus_body_ = model.jnt_bodyid[joint];
  }
}

ArmCommand RhythmController::ReadCommand(const mjModel& model, const mjData& data) const noexcept {
  return {commands_[0].Read(model, data), commands_[1].Read(model, data),
          commands_[2].Read(model, data)};
}

const JointAngles& RhythmController::TargetsFor(const ArmCommand& command) noexcept {
  if (command.elevation_rad != solved_command_.elevation_rad ||
      command.plane_rad != solved_command_.plane_rad ||
      command.axial_rad != solved_command_.axial_rad) {
    solved_command_ = command;
    solved_target_rad_ = AnglesFromPose(rhythm_.Solve(command).pose);
  }
  return solved_target_rad_;
}

void RhythmController::Actuate(const mjModel& model, mjData& data) noexcept {
  const JointAngles& target_rad = TargetsFor(ReadCommand(model, data));
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    const Servo& servo = servos_[k];
    data.actuator_force[servo.force_address] =
        servo.stiffness_N_m_per_rad *
        (target_rad[k] + servo.trim.Read(model, data) - data.qpos[servo.qpos_address]);
  }
}

void RhythmController::Sense(const mjModel& model, mjData& data, int instance) noexcept {
  const ArmCommand command = ReadCommand(model, data);
  const JointAngles& target_rad = TargetsFor(command);
  const Quaternion q_TH =
      glm::conjugate(BodyRotation(data, thorax_body_)) * BodyRotation(data, humerus_body_);
  const ArmAngles reached = ArmAnglesFromRotation(q_TH);

  std::array<double, sensor_layout::kSize> values{};
  values[sensor_layout::kCommanded] = command.elevation_rad;
  values[sensor_layout::kCommanded + 1] = command.plane_rad;
  values[sensor_layout::kCommanded + 2] = command.axial_rad;
  values[sensor_layout::kReached] = reached.elevation_rad;
  values[sensor_layout::kReached + 1] = reached.plane_rad;
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    values[sensor_layout::kTarget + k] = target_rad[k];
    values[sensor_layout::kError + k] = target_rad[k] - data.qpos[servos_[k].qpos_address];
  }
  // The axial turn reached on top of the measured one: what was commanded less what is still
  // missing.
  values[sensor_layout::kReached + 2] =
      command.axial_rad - values[sensor_layout::kError + kGhAxialIndex];
  // Measured from the control itself: its range usually is the measured domain.
  values[sensor_layout::kDistance] =
      rhythm_.DistanceOutside(commands_[0].Raw(data), commands_[1].Raw(data));

  for (int sensor = 0; sensor < model.nsensor; ++sensor) {
    if (model.sensor_type[sensor] == mjSENS_PLUGIN && model.sensor_plugin[sensor] == instance) {
      std::copy(values.begin(), values.end(), data.sensordata + model.sensor_adr[sensor]);
    }
  }
}

}  // namespace girdle
