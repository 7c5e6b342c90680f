// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The groups of the residual report, each in a file of its own, with its equation and its
/// tolerances.
#pragma once

#include <memory>
#include <vector>

#include "residuals/residual_group.h"
#include "simulation/girdle_motion.h"

namespace girdle {

using ResidualGroupPointer = std::unique_ptr<ResidualGroup>;

/// Checks whether the bones meet in their joints.
[[nodiscard]] ResidualGroupPointer MakeJointConstraintGroup(const MeasuredShoulder& shoulder);
/// Checks whether the bones are those of the anatomy.
[[nodiscard]] ResidualGroupPointer MakeBonesGroup(const MeasuredShoulder& shoulder);
/// Checks whether the bones are rotated as the splines give.
[[nodiscard]] ResidualGroupPointer MakeKinematicConsistencyGroup(const MeasuredShoulder& shoulder);
/// Checks whether the joints follow their targets.
[[nodiscard]] ResidualGroupPointer MakeTrackingGroup(const MeasuredShoulder& shoulder);
/// Checks whether the arm points in the direction of the command.
[[nodiscard]] ResidualGroupPointer MakeClosureGroup(const MeasuredShoulder& shoulder);
/// States how far the arm was from measured data.
[[nodiscard]] ResidualGroupPointer MakeRangeGroup(const MeasuredShoulder& shoulder);
/// Checks whether the scapula is rotated in the thorax as published.
[[nodiscard]] ResidualGroupPointer MakeScapulothoracicGroup(const MeasuredShoulder& shoulder);
/// Checks the AC rotation that results in a loop, where servos drive SC and ST. For loops only.
[[nodiscard]] ResidualGroupPointer MakeEmergentAcGroup();
/// Checks whether the scapula's medial border glides on the thorax.
[[nodiscard]] ResidualGroupPointer MakeGlidingGroup(const MeasuredShoulder& shoulder);
/// Checks the contact forces of the thorax. For models with thorax contact only.
[[nodiscard]] ResidualGroupPointer MakeThoraxContactGroup(const MeasuredShoulder& shoulder);
/// Checks whether the ligaments are slack and as long as between the anatomy's bones.
[[nodiscard]] ResidualGroupPointer MakeLigamentsGroup(const MeasuredShoulder& shoulder);
/// Checks the skin, on a girdle that moves as `girdle` says. For models with a skin only. It moves
/// the simulation when it adds its lines. Throws InputError as SkinMeter.
[[nodiscard]] ResidualGroupPointer MakeSkinGroup(ShoulderSimulation& simulation,
                                                 const MeasuredShoulder& shoulder,
                                                 GirdleMotion girdle);

/// Returns all groups that apply to a shoulder, in the order of the report.
[[nodiscard]] std::vector<ResidualGroupPointer> MakeResidualGroups(ShoulderSimulation& simulation,
                                                                   const MeasuredShoulder& shoulder,
                                                                   GirdleMotion girdle);

}  // namespace girdle
