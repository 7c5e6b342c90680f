// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "simulation/trace.h"

#include <algorithm>

#include "text/number_text.h"

namespace girdle {
namespace {

// The way to degrees and back moves an angle by at most a few units in the last place, always in
// one direction, and ends at an angle that it leaves alone.
double ReplayableAngle(double angle_rad) noexcept {
  constexpr int kMostRounds = 8;
  for (int round = 0; round < kMostRounds; ++round) {
    const double again_rad = RadiansFromDegrees(DegreesFromRadians(angle_rad));
    if (again_rad == angle_rad) {
      break;
    }
    angle_rad = again_rad;
  }
  return angle_rad;
}

}  // namespace

ArmCommand ReplayableCommand(const ArmCommand& command) noexcept {
  return {ReplayableAngle(command.elevation_rad), ReplayableAngle(command.plane_rad),
          ReplayableAngle(command.axial_rad), ReplayableAngle(command.shrug_rad),
          ReplayableAngle(command.protraction_rad)};
}

std::string TraceHeader(Assembly assembly) {
  std::string text = "time_s";
  for (const std::string_view command : kCommandNames) {
    text += "," + std::string(command) + "_deg";
  }
  for (const std::string_view offset : kOffsetNames) {
    text += "," + std::string(offset) + "_deg";
  }
  text += ",distance_deg";
  for (const char* prefix : {",target_", ","}) {
    for (const std::string_view coordinate : DrivenCoordinates(assembly)) {
      text += prefix + std::string(coordinate) + "_deg";
    }
  }
  for (const Segment segment : {Segment::kClavicle, Segment::kScapula, Segment::kHumerus}) {
    for (const char* component : {"_qw", "_qx", "_qy", "_qz"}) {
      text += "," + std::string(kSegmentNames[static_cast<std::size_t>(segment)]) + component;
    }
  }
  for (std::size_t site = 0; site < kSiteCount; ++site) {
    for (const char* component : {"_x_m", "_y_m", "_z_m"}) {
      text += "," + std::string(SiteStem(site)) + component;
    }
  }
  return text + "\n";
}

void AppendTraceRow(std::string& text, const ShoulderState& state) {
  AppendNumber(text, state.time_s);
  const auto append = [&text](double number) {
    text += ',';
    AppendNumber(text, number);
  };
  append(DegreesFromRadians(state.command.elevation_rad));
  append(DegreesFromRadians(state.command.plane_rad));
  append(DegreesFromRadians(state.command.axial_rad));
  append(DegreesFromRadians(state.command.shrug_rad));
  append(DegreesFromRadians(state.command.protraction_rad));
  append(DegreesFromRadians(state.distance_rad));
  for (const JointAngles& angles_rad : {state.target_rad, state.position_rad}) {
    for (const double angle_rad : angles_rad) {
      append(DegreesFromRadians(angle_rad));
    }
  }
  for (const Segment segment : {Segment::kClavicle, Segment::kScapula, Segment::kHumerus}) {
    const Quaternion& q = state.rotation(segment);
    append(q.w);
    append(q.x);
    append(q.y);
    append(q.z);
  }
  for (const Vector3& position : state.site_m) {
    append(position.x);
    append(position.y);
    append(position.z);
  }
  text += '\n';
}

std::string ControlsHeader(const std::vector<std::string>& actuators) {
  std::string text = "time_s";
  for (const std::string& actuator : actuators) {
    const bool is_slide =
        std::any_of(kTranslationNames.begin(), kTranslationNames.end(),
                    [&actuator](std::string_view name) { return actuator.starts_with(name); });
    text += "," + actuator + (is_slide ? "_m" : "_rad");
  }
  return text + "\n";
}

void AppendControlsRow(std::string& text, double time_s, const std::vector<double>& targets) {
  AppendNumber(text, time_s);
  for (const double target : targets) {
    text += ',';
    AppendNumber(text, target);
  }
  text += '\n';
}

}  // namespace girdle
