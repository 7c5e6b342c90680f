// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "plugin/rhythm_controller.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <stdexcept>
#include <string>

namespace girdle {
namespace {

Quaternion BodyRotation(const DataView& data, int body) noexcept {
  const mjtNum* q = data.xquat + 4 * body;
  return {q[0], q[1], q[2], q[3]};
}

bool IsNumber(const ArmCommand& command) noexcept {
  return !std::isnan(command.elevation_rad) && !std::isnan(command.plane_rad) &&
         !std::isnan(command.axial_rad) && !std::isnan(command.shrug_rad) &&
         !std::isnan(command.protraction_rad);
}

// Returns the rhythm of a configuration, in the assembly of the model's servos.
AssembledRhythm BoundRhythm(const RhythmConfig& config, const RhythmBinding& binding) {
  const JointRanges& ranges = binding.ranges;
  try {
    return {MakeRhythm(Resolve(config.rhythm), ranges, "config: "),
            binding.assembly,
            {ranges[3], ranges[4], ranges[5]}};
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error("st_ servos: " + std::string(error.what()));
  }
}

}  // namespace

RhythmController::RhythmController(const ModelView& model, int instance, const RhythmConfig& config)
    : binding_(BindRhythm(model, instance, config)),
      rhythm_(BoundRhythm(config, binding_)),
      axial_from_(config.axial_from) {
  SolveAim(solved_command_);
}

void RhythmController::SolveAim(const ArmCommand& command) noexcept {
  solved_command_ = command;
  const ShoulderPose pose = rhythm_.SolvePose(command, &solved_.used);
  solved_.target_rad = DrivenAngles(rhythm_.assembly(), pose);
  solved_.axial_isb_rad = rhythm_.rhythm().AxialOf(AxialFrom::kIsb, pose, solved_.used);
  if (binding_.has_place_servos) {
    solved_.target_p_TS_m = binding_.p_TC_m + pose.q_TC * *binding_.p_CS_m;
  }
}

ArmCommand RhythmController::ReadCommand(const ModelView& model,
                                         const DataView& data) const noexcept {
  const BoundControl& axial = binding_.commands[2];
  return {
      binding_.commands[0].Read(model, data), binding_.commands[1].ReadAngle(model, data),
      // Counted from the rhythm's own turn, the axial command is an amount. Otherwise it is an
      // angle, from which whole turns are taken.
      axial_from_ == AxialFrom::kRhythm ? axial.Read(model, data) : axial.ReadAngle(model, data),
      binding_.commands[3].Read(model, data), binding_.commands[4].Read(model, data), axial_from_};
}

bool RhythmController::FirstMisses(const DataView& data) noexcept {
  const mjtNum* const q = data.xquat + 4 * binding_.thorax_body;
  if (misses_pose_ || q[0] != 0 || q[1] != 0 || q[2] != 0 || q[3] != 0) {
    return false;
  }
  misses_pose_ = true;
  return true;
}

ArmAngles RhythmController::Reached(const DataView& data) const noexcept {
  const Quaternion q_TH = glm::conjugate(BodyRotation(data, binding_.thorax_body)) *
                          BodyRotation(data, binding_.humerus_body);
  return ArmAnglesFromRotation(OnSide(binding_.side, q_TH));
}

const RhythmController::Aim& RhythmController::AimFor(const ModelView& model,
                                                      const DataView& data) noexcept {
  const ArmCommand command = ReadCommand(model, data);
  if (command == solved_command_) {
    return solved_;
  }
  if (!IsNumber(command)) {
    const ArmAngles reached = Reached(data);
    holding_ = {{reached.elevation_rad, reached.plane_rad}, {}, {0, 0, 0}, reached.axial_rad, true};
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      holding_.target_rad[k] = data.qpos[binding_.servos[k].qpos_address];
    }
    return holding_;
  }
  SolveAim(command);
  return solved_;
}

// d target / dt = (d target / d elevation) elevation_rate + (d target / d plane) plane_rate. An
// axial turn adds to the last coordinate. A command that its range limits has no rate.
JointAngles RhythmController::TargetRates(const ModelView& model, const DataView& data,
                                          const Aim& aim) const noexcept {
  const ArmCommand command = ReadCommand(model, data);
  const std::array<double, kRateCount> read = {command.elevation_rad, command.plane_rad,
                                               command.axial_rad};
  std::array<double, kRateCount> command_rate{};
  constexpr double kRounding = 1e-9;
  // ReadCommand takes whole turns from the commands that are angles.
  const std::array<bool, kRateCount> is_angle = {false, true, axial_from_ != AxialFrom::kRhythm};
  for (std::size_t i = 0; i < kRateCount; ++i) {
    const double held_back = binding_.commands[i].Raw(data) - read[i];
    if (std::abs(is_angle[i] ? std::remainder(held_back, 2 * kPi) : held_back) < kRounding) {
      command_rate[i] = binding_.commands[kCommandCount + kOffsetCount + i].ReadFinite(model, data);
    }
  }
  const auto [elevation_rate, plane_rate, axial_rate] = command_rate;
  JointAngles rates{};
  if (elevation_rate != 0 || plane_rate != 0) {
    const std::optional<AngleRates> angles = rhythm_.rhythm().SolveAngleRates(command);
    for (std::size_t k = 0; angles && k < kCoordinateCount; ++k) {
      rates[k] = angles->by_elevation[k] * elevation_rate + angles->by_plane[k] * plane_rate;
    }
  }
  // At the end of its range the humerus does not rotate further.
  if (aim.used.axial_rad == rhythm_.rhythm().AxialCountedFrom(AxialFrom::kRhythm, command)) {
    rates[kGhAxialIndex] += rhythm_.rhythm().AxialShare(command) * axial_rate;
  }
  return rates;
}

bool RhythmController::FeedsForward(const ModelView& model) const noexcept {
  return binding_.has_rates && !model.Disables(model.engine->disable_damper);
}

void RhythmController::Actuate(const ModelView& model, const DataView& data) noexcept {
  const Aim& aim = AimFor(model, data);
  JointAngles rates{};
  if (FeedsForward(model) && !aim.holds) {
    rates = TargetRates(model, data, aim);
  }
  const auto drive = [&](const BoundServo& servo, double target, double rate) {
    const double error =
        target + servo.trim.ReadFinite(model, data) - data.qpos[servo.qpos_address];
    const double force = servo.stiffness * error + model.dof_damping[servo.dof_address] * rate;
    data.actuator_force[servo.force_address] =
        std::isfinite(force) && !aim.holds && !servo.IsDisabled(model) ? force : 0;
  };
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    drive(binding_.servos[k], aim.target_rad[k], rates[k]);
  }
  for (int i = 0; binding_.has_place_servos && i < 3; ++i) {
    drive(binding_.place_servos[static_cast<std::size_t>(i)], aim.target_p_TS_m[i], 0);
  }
  if (!binding_.sensors.empty() && !model.Disables(model.engine->disable_sensor) &&
      !SensorsShow(data, aim)) {
    WriteSensors(data, aim);
  }
}

void RhythmController::Sense(const ModelView& model, const DataView& data) noexcept {
  const Aim& aim = AimFor(model, data);
  WriteSensors(data, aim);
  const ArmAngles reached = Reached(data);
  for (const BoundSensor& sensor : binding_.sensors) {
    mjtNum* values = data.sensordata + sensor.address;
    values[sensor_layout::kReached] = sensor.Cut(reached.elevation_rad);
    values[sensor_layout::kReached + 1] = sensor.Cut(reached.plane_rad);
    values[sensor_layout::kReachedIsb] = sensor.Cut(reached.axial_rad);
  }
}

// Writes the values that follow from the commands. Sense writes those of the simulated arm.
void RhythmController::WriteSensors(const DataView& data, const Aim& aim) const noexcept {
  const double distance_rad = DistanceOf(data, aim);
  for (const BoundSensor& sensor : binding_.sensors) {
    mjtNum* values = data.sensordata + sensor.address;
    values[sensor_layout::kCommanded] = sensor.Cut(aim.used.elevation_rad);
    values[sensor_layout::kCommanded + 1] = sensor.Cut(aim.used.plane_rad);
    values[sensor_layout::kCommanded + 2] = sensor.Cut(aim.used.axial_rad);
    double error_rad = 0;
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      error_rad = aim.target_rad[k] - data.qpos[binding_.servos[k].qpos_address];
      values[sensor_layout::kTarget + k] = sensor.Cut(aim.target_rad[k]);
      values[sensor_layout::kError + k] = sensor.Cut(error_rad);
    }
    // The axial turn reached, counted from the rhythm's own: the command minus the remaining error
    // of the last coordinate.
    values[sensor_layout::kReached + 2] = sensor.Cut(aim.used.axial_rad - error_rad);
    values[sensor_layout::kDistance] = sensor.Cut(distance_rad);
    values[sensor_layout::kCommandedIsb] = sensor.Cut(aim.axial_isb_rad);
  }
}

// Returns the distance of the raw controls, because commands are limited to the controls' ranges.
double RhythmController::DistanceOf(const DataView& data, const Aim& aim) const noexcept {
  const double elevation_rad = binding_.commands[0].Raw(data);
  const double plane_rad = binding_.commands[1].Raw(data);
  return std::isnan(elevation_rad) || std::isnan(plane_rad)
             ? rhythm_.rhythm().DistanceOutside(aim.used.elevation_rad, aim.used.plane_rad)
             : rhythm_.rhythm().DistanceOutside(elevation_rad, plane_rad);
}

bool RhythmController::SensorsShow(const DataView& data, const Aim& aim) const noexcept {
  const double distance_rad = DistanceOf(data, aim);
  return std::all_of(
      binding_.sensors.begin(), binding_.sensors.end(), [&](const BoundSensor& sensor) {
        const mjtNum* values = data.sensordata + sensor.address;
        return values[sensor_layout::kCommanded] == sensor.Cut(aim.used.elevation_rad) &&
               values[sensor_layout::kCommanded + 1] == sensor.Cut(aim.used.plane_rad) &&
               values[sensor_layout::kCommanded + 2] == sensor.Cut(aim.used.axial_rad) &&
               values[sensor_layout::kDistance] == sensor.Cut(distance_rad) &&
               values[sensor_layout::kCommandedIsb] == sensor.Cut(aim.axial_isb_rad) &&
               std::equal(
                   aim.target_rad.begin(), aim.target_rad.end(), values + sensor_layout::kTarget,
                   [&sensor](double target, mjtNum value) { return value == sensor.Cut(target); });
      });
}

}  // namespace girdle
