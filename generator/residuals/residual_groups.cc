// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "residuals/residual_groups.h"

#include "simulation/model_skin.h"

namespace girdle {

std::vector<ResidualGroupPointer> MakeResidualGroups(ShoulderSimulation& simulation,
                                                     const MeasuredShoulder& shoulder,
                                                     GirdleMotion girdle) {
  std::vector<ResidualGroupPointer> groups;
  groups.push_back(MakeJointConstraintGroup(shoulder));
  groups.push_back(MakeBonesGroup(shoulder));
  groups.push_back(MakeKinematicConsistencyGroup(shoulder));
  groups.push_back(MakeTrackingGroup(shoulder));
  groups.push_back(MakeClosureGroup(shoulder));
  groups.push_back(MakeRangeGroup(shoulder));
  groups.push_back(MakeScapulothoracicGroup(shoulder));
  if (shoulder.is_loop()) {
    groups.push_back(MakeEmergentAcGroup());
  }
  groups.push_back(MakeGlidingGroup(shoulder));
  if (shoulder.has_thorax_contact()) {
    groups.push_back(MakeThoraxContactGroup(shoulder));
  }
  groups.push_back(MakeLigamentsGroup(shoulder));
  if (HasSkin(simulation.model())) {
    groups.push_back(MakeSkinGroup(simulation, shoulder, girdle));
  }
  return groups;
}

}  // namespace girdle
