// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/knot_crossings.h"
#include "mjcf/model_sections.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "names/joint_dynamics.h"

namespace girdle {
namespace {

// Largest trim that a user may add to a joint's target.
constexpr double kTrimRange_rad = 30 * kRadiansPerDegree;
constexpr double kTranslationTrimRange_m = 0.03;
// Limit for commands: a pitcher's humerus, the fastest arm, rotates at 120 rad/s.
constexpr double kFastestCommand_rad_per_s = 150;

// Returns the least and the largest axial turn that the joint's range allows at any place of a grid
// of 1 deg. Where the range allows less at a place, the rhythm limits the turn there. If turns are
// angles, the range is at least a whole turn, so that it excludes no angle.
CoordinateRange AxialRange(const ModelPlan& plan) {
  const AxialFrom zero = plan.options.axial_from;
  const ShoulderRhythm& rhythm = plan.rhythm();
  const ArmRectangle& domain = rhythm.domain();
  const CoordinateRange& joint = plan.anatomy.ranges[kGhAxialIndex];
  CoordinateRange range =
      zero == AxialFrom::kRhythm ? CoordinateRange{0, 0} : CoordinateRange{-kPi, kPi};
  for (const double elevation_rad :
       EvenSteps(domain.lowest_elevation_rad, domain.highest_elevation_rad)) {
    for (const double plane_rad :
         EvenSteps(rhythm.LowestPlaneAt(elevation_rad), domain.last_plane_rad)) {
      const ArmCommand own = {elevation_rad, plane_rad};
      const double from_joint_rad =
          rhythm.AxialCountedFrom(zero, own) - AnglesFromPose(rhythm.SolvePose(own))[kGhAxialIndex];
      range.lower_rad = std::min(range.lower_rad, joint.lower_rad + from_joint_rad);
      range.upper_rad = std::max(range.upper_rad, joint.upper_rad + from_joint_rad);
    }
  }
  return range;
}

void WritePluginActuators(const ModelPlan& plan, XmlElement& actuator, Side side) {
  const ArmRectangle& domain = plan.rhythm().domain();
  // A command makes no force itself, but MuJoCo requires an element that it acts on.
  const auto write_command = [&](std::string_view name, const CoordinateRange& range) {
    actuator.Add("plugin")
        .Set("name", SidedName(name, side))
        .Set("joint", SidedName(kCoordinateNames[kGhAxialIndex], side))
        .Set("instance", SidedName(kRhythmName, side))
        .Set("gear", 0)
        .Set("ctrlrange", std::array{range.lower_rad, range.upper_rad})
        .Set("class", kDefaultsName);
  };
  write_command(kCommandNames[0], {domain.lowest_elevation_rad, domain.highest_elevation_rad});
  // The plane is an angle and the rhythm answers every plane. MuJoCo clips controls to their ranges
  // first, so that the range must include every plane.
  write_command(kCommandNames[1], {-kPi, kPi});
  write_command(kCommandNames[2], AxialRange(plan));
  if (plan.options.has_offsets) {
    write_command(kOffsetNames[0], kShrugRange);
    write_command(kOffsetNames[1], kProtractionRange);
  }
  if (plan.options.has_rates) {
    for (const std::string_view rate : kRateNames) {
      write_command(rate, {-kFastestCommand_rad_per_s, kFastestCommand_rad_per_s});
    }
  }
  const auto write_servo = [&](std::string_view coordinate, double trim) {
    actuator.Add("plugin")
        .Set("name", SidedName(coordinate, side))
        .Set("joint", SidedName(coordinate, side))
        .Set("instance", SidedName(kRhythmName, side))
        .Set("ctrlrange", std::array{-trim, trim})
        .Set("class", kDefaultsName);
  };
  for (const std::string_view coordinate : plan.coordinates) {
    write_servo(coordinate, kTrimRange_rad);
  }
  if (plan.drives_place()) {
    for (const std::string_view translation : kTranslationNames) {
      write_servo(translation, kTranslationTrimRange_m);
    }
  }
}

void WritePositionActuators(const ModelPlan& plan, XmlElement& actuator, Side side) {
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    if (plan.StiffnessOf(k) > 0) {
      const CoordinateRange& range = plan.RangeOf(k);
      actuator.Add("position")
          .Set("name", SidedName(plan.coordinates[k], side))
          .Set("joint", SidedName(plan.coordinates[k], side))
          .Set("kp", plan.StiffnessOf(k))
          .Set("ctrlrange", std::array{range.lower_rad, range.upper_rad})
          .Set("class", kDefaultsName);
    }
  }
  if (plan.drives_place()) {
    for (const std::string_view translation : kTranslationNames) {
      actuator.Add("position")
          .Set("name", SidedName(translation, side))
          .Set("joint", SidedName(translation, side))
          .Set("kp", kLeadingTranslation.stiffness_N_per_m)
          .Set("class", kDefaultsName);
    }
  }
}

}  // namespace

void WriteActuators(const ModelPlan& plan, XmlElement root) {
  XmlElement actuator = root.Add("actuator");
  for (const Side side : plan.sides) {
    if (plan.has_plugin()) {
      WritePluginActuators(plan, actuator, side);
    } else {
      WritePositionActuators(plan, actuator, side);
    }
  }
}

}  // namespace girdle
