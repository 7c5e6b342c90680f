// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "mjcf/model_sections.h"

#include <array>

#include "names/joint_dynamics.h"

namespace girdle {

// Writes the contact pairs. Nothing else collides, so that these pairs are the only contacts.
void WriteContacts(const ModelPlan& plan, XmlElement root) {
  if (!plan.options.has_thorax_contact) {
    return;
  }
  XmlElement contact = root.Add("contact");
  const std::array<double, 2>& solref = plan.options.assembly == Assembly::kTree
                                            ? kTreeThoraxContactSolref
                                            : kLoopThoraxContactSolref;
  for (const Side side : plan.sides) {
    for (const Landmark landmark : kGlidingLandmarks) {
      contact.Add("pair")
          .Set("name", SidedName(DefinitionOf(landmark).name, side))
          .Set("geom1", SidedName(kGlidingName, side))
          .Set("geom2", SidedName(DefinitionOf(landmark).name, side))
          .Set("condim", 1)
          .Set("solref", solref)
          .Set("solimp", kThoraxContactSolimp)
          .Set("class", kDefaultsName);
    }
  }
}

void WriteEqualities(const ModelPlan& plan, XmlElement root) {
  if (!plan.is_loop()) {
    return;
  }
  XmlElement equality = root.Add("equality");
  for (const Side side : plan.sides) {
    equality.Add("connect")
        .Set("name", SidedName(kConnectName, side))
        .Set("site1", SidedName(kJointSites[1].parent, side))
        .Set("site2", SidedName(kJointSites[1].child, side))
        .Set("solref", kConnectSolref)
        .Set("solimp", kConnectSolimp)
        .Set("class", kDefaultsName);
  }
}

}  // namespace girdle
