// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "simulation/trace.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "text/number_text.h"
#include "text/output_columns.h"

namespace girdle {
namespace {

// Returns an angle near `angle_rad` that the conversion to degrees and back does not change. A
// conversion moves an angle by a few units in the last place at most, always in one direction, so
// that repeated conversions end at such an angle.
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

using Stems = std::vector<std::string>;
using TraceColumns = WrittenColumns<ShoulderState, ExactNumbers>;

constexpr std::array kMovingBones = {Segment::kClavicle, Segment::kScapula, Segment::kHumerus};
constexpr std::array<const char*, 4> kQuaternionParts = {"_qw", "_qx", "_qy", "_qz"};
constexpr std::array<const char*, 3> kAxes = {"_x", "_y", "_z"};

Stems CommandStems(const Assembly& /*assembly*/) {
  Stems stems(kCommandNames.begin(), kCommandNames.end());
  stems.insert(stems.end(), kOffsetNames.begin(), kOffsetNames.end());
  return stems;
}

Cell CommandAngle(const ShoulderState& state, std::size_t k) {
  constexpr std::array kAngles = {&ArmCommand::elevation_rad, &ArmCommand::plane_rad,
                                  &ArmCommand::axial_rad, &ArmCommand::shrug_rad,
                                  &ArmCommand::protraction_rad};
  static_assert(kAngles.size() == kCommandCount + kOffsetCount);
  return DegreesFromRadians(state.command.*kAngles[k]);
}

Stems AngleStems(const Assembly& assembly) {
  const auto coordinates = DrivenCoordinates(assembly);
  return {coordinates.begin(), coordinates.end()};
}

Stems TargetStems(const Assembly& assembly) {
  Stems stems = AngleStems(assembly);
  for (std::string& stem : stems) {
    stem.insert(0, "target_");
  }
  return stems;
}

Stems RotationStems(const Assembly& /*assembly*/) {
  Stems stems;
  for (const Segment bone : kMovingBones) {
    for (const char* part : kQuaternionParts) {
      stems.push_back(std::string(Name(bone)) + part);
    }
  }
  return stems;
}

Cell RotationPart(const ShoulderState& state, std::size_t k) {
  const Quaternion& q = state.rotation(kMovingBones[k / kQuaternionParts.size()]);
  return std::array{q.w, q.x, q.y, q.z}[k % kQuaternionParts.size()];
}

Stems SiteStems(const Assembly& /*assembly*/) {
  Stems stems;
  for (std::size_t site = 0; site < kSiteCount; ++site) {
    for (const char* axis : kAxes) {
      stems.push_back(std::string(SiteStem(site)) + axis);
    }
  }
  return stems;
}

// Stems in the order of AxialFrom.
Stems UsedAxialStems(const Assembly& /*assembly*/) {
  return {std::string(kUsedAxialNames[0]), std::string(kUsedAxialNames[1])};
}

// The columns in the order of the trace. A further column is one more line here.
constexpr std::array<OutputColumns<ShoulderState, Assembly>, 10> kTraceColumns = {{
    {[](const Assembly&) { return Stems{"time"}; }, kSeconds,
     [](const ShoulderState& state, std::size_t) -> Cell { return state.time_s; }},
    {CommandStems, kDegrees, CommandAngle},
    {[](const Assembly&) {
       return Stems{"used_elevation", "used_plane"};
     },
     kDegrees,
     [](const ShoulderState& state, std::size_t k) -> Cell {
       return DegreesFromRadians(k == 0 ? state.used.elevation_rad : state.used.plane_rad);
     }},
    {[](const Assembly&) { return Stems{"distance"}; }, kDegrees,
     [](const ShoulderState& state, std::size_t) -> Cell {
       return DegreesFromRadians(state.distance_rad);
     }},
    {UsedAxialStems, kDegrees,
     [](const ShoulderState& state, std::size_t k) -> Cell {
       return DegreesFromRadians(k == 0 ? state.used.axial_rad : state.used_axial_isb_rad);
     }},
    {[](const Assembly&) {
       return Stems{kUsedOffsetNames.begin(), kUsedOffsetNames.end()};
     },
     kDegrees,
     [](const ShoulderState& state, std::size_t k) -> Cell {
       return DegreesFromRadians(k == 0 ? state.used.shrug_rad : state.used.protraction_rad);
     }},
    {TargetStems, kDegrees,
     [](const ShoulderState& state, std::size_t k) -> Cell {
       return DegreesFromRadians(state.target_rad[k]);
     }},
    {AngleStems, kDegrees,
     [](const ShoulderState& state, std::size_t k) -> Cell {
       return DegreesFromRadians(state.position_rad[k]);
     }},
    {RotationStems, kNoUnit, RotationPart},
    {SiteStems, kMeters,
     [](const ShoulderState& state, std::size_t k) -> Cell {
       return state.site_m[k / kAxes.size()][static_cast<int>(k % kAxes.size())];
     }},
}};

}  // namespace

ArmCommand ReplayableCommand(const ArmCommand& command) noexcept {
  return {ReplayableAngle(command.elevation_rad),   ReplayableAngle(command.plane_rad),
          ReplayableAngle(command.axial_rad),       ReplayableAngle(command.shrug_rad),
          ReplayableAngle(command.protraction_rad), command.axial_from};
}

std::string TraceHeader(Assembly assembly) {
  return TraceColumns(kTraceColumns, assembly).Header() + "\n";
}

std::uintmax_t SizeOfRows(const std::string& header, std::uintmax_t rows) noexcept {
  // A double has at most 17 digits, a sign and a point, and a comma follows it.
  constexpr std::uintmax_t kBytesOfNumber = 20;
  const auto commas = static_cast<std::uintmax_t>(std::count(header.begin(), header.end(), ','));
  return header.size() + rows * (commas + 1) * kBytesOfNumber;
}

void AppendTraceRow(std::string& text, const ShoulderState& state) {
  // Only the names of the columns depend on the assembly.
  static const TraceColumns kColumns(kTraceColumns, Assembly::kTree);
  kColumns.Append(text, state);
  text += '\n';
}

std::string ControlsHeader(const std::vector<std::string>& actuators) {
  std::string text = ColumnName("time", kSeconds);
  for (const std::string& actuator : actuators) {
    const bool is_slide =
        std::any_of(kTranslationNames.begin(), kTranslationNames.end(),
                    [&actuator](std::string_view name) { return actuator.starts_with(name); });
    text += "," + ColumnName(actuator, is_slide ? kMeters : kRadians);
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
