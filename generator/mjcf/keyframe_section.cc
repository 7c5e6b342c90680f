// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "mjcf/model_sections.h"

#include <vector>

#include "anatomy/built_in_anatomy.h"
#include "anatomy/postures.h"

namespace girdle {
namespace {

// Appends the joints of one side, body by body.
void AppendPositions(const ModelPlan& plan, std::vector<double>& positions,
                     const ShoulderPose& pose) {
  const JointAngles angles_rad = DrivenAngles(plan.options.assembly, pose);
  positions.insert(positions.end(), angles_rad.begin(), angles_rad.begin() + 3);
  if (plan.is_loop()) {
    const Vector3 p_m = plan.PlaceOfScapula(pose);
    positions.insert(positions.end(), {p_m.x, p_m.y, p_m.z});
  }
  positions.insert(positions.end(), angles_rad.begin() + 3, angles_rad.end());
}

// Appends the controls of one side's position servos that hold the joints at `pose`.
void AppendServoControls(const ModelPlan& plan, std::vector<double>& controls,
                         const ShoulderPose& pose) {
  const JointAngles angles_rad = DrivenAngles(plan.options.assembly, pose);
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    if (plan.StiffnessOf(k) > 0) {
      controls.push_back(angles_rad[k]);
    }
  }
  if (plan.drives_place()) {
    const Vector3 p_m = plan.PlaceOfScapula(pose);
    controls.insert(controls.end(), {p_m.x, p_m.y, p_m.z});
  }
}

// Appends the controls of one side's plugin that hold the joints at `pose`. The command leads to
// `target`, and trims add the difference from `target` to `pose`.
void AppendPluginControls(const ModelPlan& plan, std::vector<double>& controls,
                          const ArmCommand& command, const ShoulderPose& target,
                          const ShoulderPose& pose) {
  controls.insert(controls.end(), {command.elevation_rad, command.plane_rad, command.axial_rad});
  controls.resize(controls.size() + (plan.options.has_offsets ? kOffsetCount : 0) +
                  (plan.options.has_rates ? kRateCount : 0));
  const JointAngles target_rad = DrivenAngles(plan.options.assembly, target);
  const JointAngles angles_rad = DrivenAngles(plan.options.assembly, pose);
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    controls.push_back(angles_rad[k] - target_rad[k]);
  }
  if (plan.drives_place()) {
    const Vector3 trim_m = plan.PlaceOfScapula(pose) - plan.PlaceOfScapula(target);
    controls.insert(controls.end(), {trim_m.x, trim_m.y, trim_m.z});
  }
}

}  // namespace

void WriteKeyframes(const ModelPlan& plan, XmlElement root) {
  XmlElement keyframe = root.Add("keyframe");
  for (const NamedPose& named : kKeyframes) {
    const ShoulderSolution solution = plan.rhythm().Solve(
        {RadiansFromDegrees(named.elevation_deg), RadiansFromDegrees(named.plane_deg)});
    // Only `hanging` may be a pose that is the nearest to its name. A keyframe of another name is
    // exactly the pose of that name or is left out.
    if (named.name != kHangingName && solution.clamped) {
      continue;
    }
    // Controls of zero lead to `hanging`. The other keyframes have the rhythm's own axial turn.
    ArmCommand command = solution.used;
    command.axial_rad = named.name == kHangingName
                            ? 0
                            : plan.rhythm().AxialCountedFrom(plan.options.axial_from, command);
    command.axial_from = plan.options.axial_from;
    const ShoulderPose target = plan.assembled.SolvePose(command);
    const ShoulderPose pose =
        named.name == kRelaxedName ? HangingIn(RelaxedStanding(), plan.rhythm()) : target;
    std::vector<double> positions;
    std::vector<double> controls;
    for (std::size_t side = 0; side < plan.sides.size(); ++side) {
      AppendPositions(plan, positions, pose);
      if (plan.has_plugin()) {
        AppendPluginControls(plan, controls, command, target, pose);
      } else {
        AppendServoControls(plan, controls, pose);
      }
    }
    keyframe.Add("key").Set("name", named.name).Set("qpos", positions).Set("ctrl", controls);
  }
}

}  // namespace girdle
