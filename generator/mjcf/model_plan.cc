// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "mjcf/model_plan.h"

#include <stdexcept>
#include <string>

#include "anatomy/posed_bones.h"
#include "names/joint_dynamics.h"
#include "rhythm_tables/rhythm_table_csv.h"
#include "text/number_text.h"

namespace girdle {
namespace {

void CheckOptions(const ModelPlan& plan) {
  const ShoulderModelOptions& options = plan.options;
  if (options.has_rates && plan.rhythm().options().interpolation != Interpolation::kSmooth) {
    throw std::invalid_argument("rate commands need the interpolation smooth");
  }
  if (options.has_rates && plan.is_loop()) {
    throw std::invalid_argument("rate commands need the assembly tree");
  }
  if (!plan.has_plugin() && (options.has_offsets || options.has_rates)) {
    throw std::invalid_argument(
        "commands for offsets and rates need the plugin: position servos are given joint angles");
  }
  if (!plan.has_plugin() && options.axial_from != AxialFrom::kRhythm) {
    throw std::invalid_argument(
        "another zero of axial turns needs the plugin: position servos are given joint angles");
  }
  if (!plan.is_loop() && options.lead != Lead::kClavicle) {
    throw std::invalid_argument("in a tree nothing but the clavicle can lead");
  }
  if (options.skin && options.skin->landmarks.size() != plan.sides.size()) {
    throw std::invalid_argument("a skin needs landmarks of every side of the model");
  }
  if (options.has_thorax_contact && options.lead == Lead::kScapula) {
    throw std::invalid_argument("thorax contact needs a clavicle that leads");
  }
}

// Throws if the options name another table than the rhythm's: the model would load and be wrong.
void CheckTable(const ModelPlan& plan) {
  if (plan.options.table && RhythmTableToLine(plan.rhythm().table()) !=
                                RhythmTableToLine(BuiltInRhythmTable(*plan.options.table))) {
    throw std::invalid_argument("the rhythm's table is not the built-in table " +
                                std::string(Name(*plan.options.table)) +
                                ". Name the one that it is, or none");
  }
}

void CheckRanges(const ModelPlan& plan, const ArmCommand& used, const JointAngles& angles_rad) {
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    const CoordinateRange& range = plan.RangeOf(k);
    // Rounding may move an angle past the range that its table ends at.
    constexpr double kRounding_rad = 1e-9;
    if (angles_rad[k] < range.lower_rad - kRounding_rad ||
        angles_rad[k] > range.upper_rad + kRounding_rad) {
      const auto degrees = [](double angle_rad) {
        return RoundedText(DegreesFromRadians(angle_rad), 6);
      };
      throw std::invalid_argument(std::string(plan.coordinates[k]) + " is " +
                                  degrees(angles_rad[k]) + " deg at plane " +
                                  degrees(used.plane_rad) + ", elevation " +
                                  degrees(used.elevation_rad) + ", outside the joint's range " +
                                  degrees(range.lower_rad) + " to " + degrees(range.upper_rad) +
                                  " deg. Check the signs and the sequence of the table's angles");
    }
  }
}

// Checks the ranges and returns the ligaments' slack, both over all that the rhythm answers. Most
// of the time of writing is spent here.
LigamentLengths SurveyRhythm(const ModelPlan& plan) {
  return SlackFor_m(plan.anatomy, plan.assembled,
                    [&plan](const ArmCommand& used, const ShoulderPose& pose) {
                      CheckRanges(plan, used, DrivenAngles(plan.options.assembly, pose));
                    });
}

}  // namespace

ModelPlan::ModelPlan(const Anatomy& model_anatomy, const ShoulderRhythm& rhythm,
                     const ShoulderModelOptions& model_options)
    : anatomy(model_anatomy),
      options(model_options),
      assembled(rhythm, model_options.assembly),
      sides(SidesOf(model_options.sides)),
      coordinates(DrivenCoordinates(model_options.assembly)),
      rest(assembled.SolvePose({.axial_from = model_options.axial_from})),
      rest_rad(DrivenAngles(model_options.assembly, rest)) {
  CheckOptions(*this);
  CheckTable(*this);
  slack_m = SurveyRhythm(*this);
}

const CoordinateRange& ModelPlan::RangeOf(std::size_t coordinate) const noexcept {
  return is_loop() && coordinate / 3 == 1 ? anatomy.scapulothoracic_ranges[coordinate - 3]
                                          : anatomy.ranges[coordinate];
}

double ModelPlan::StiffnessOf(std::size_t coordinate) const noexcept {
  const bool follows = drives_place() && coordinate < 2;
  return follows ? 0 : kJointDynamics[coordinate / 3].stiffness_N_m_per_rad;
}

Vector3 ModelPlan::PlaceOfScapula(const ShoulderPose& pose) const noexcept {
  return LandmarkInThorax_m(anatomy, pose, Landmark::kPAC);
}

}  // namespace girdle
