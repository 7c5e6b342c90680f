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

/// Whether the bones meet in their joints.
[[nodiscard]] ResidualGroupPointer MakeJointConstraintGroup(const MeasuredShoulder& shoulder);
/// Whether the bones are those of the anatomy.
[[nodiscard]] ResidualGroupPointer MakeBonesGroup(const MeasuredShoulder& shoulder);
/// Whether the bones are turned as the splines say.
[[nodiscard]] ResidualGroupPointer MakeKinematicConsistencyGroup(const MeasuredShoulder& shoulder);
/// Whether the joints follow their targets.
[[nodiscard]] ResidualGroupPointer MakeTrackingGroup(const MeasuredShoulder& shoulder);
/// Whether the arm points where it is told to.
[[nodiscard]] ResidualGroupPointer MakeClosureGroup(const MeasuredShoulder& shoulder);
/// How far from measured data the arm was.
[[nodiscard]] ResidualGroupPointer MakeRangeGroup(const MeasuredShoulder& shoulder);
/// Whether the scapula is turned in the thorax as published.
[[nodiscard]] ResidualGroupPointer MakeScapulothoracicGroup(const MeasuredShoulder& shoulder);
/// What AC comes to in a loop, which drives SC and ST. Of a loop alone.
[[nodiscard]] ResidualGroupPointer MakeEmergentAcGroup();
/// Whether the scapula's medial border glides on the thorax.
[[nodiscard]] ResidualGroupPointer MakeGlidingGroup(const MeasuredShoulder& shoulder);
/// Whether the thorax pushes as it should. Of models with thorax contact alone.
[[nodiscard]] ResidualGroupPointer MakeThoraxContactGroup(const MeasuredShoulder& shoulder);
/// Whether the ligaments are as long as between the anatomy's bones, and slack.
[[nodiscard]] ResidualGroupPointer MakeLigamentsGroup(const MeasuredShoulder& shoulder);
/// The skin, as `girdle` has the girdle move. Of a model with a skin alone; moves the simulation
/// when it adds its lines. Throws InputError as SkinMeter.
[[nodiscard]] ResidualGroupPointer MakeSkinGroup(ShoulderSimulation& simulation,
                                                 const MeasuredShoulder& shoulder,
                                                 GirdleMotion girdle);

/// Returns all groups that a shoulder has, in the order of the report.
[[nodiscard]] std::vector<ResidualGroupPointer> MakeResidualGroups(ShoulderSimulation& simulation,
                                                                   const MeasuredShoulder& shoulder,
                                                                   GirdleMotion girdle);

}  // namespace girdle
