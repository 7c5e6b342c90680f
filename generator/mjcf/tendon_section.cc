// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "mjcf/model_sections.h"

#include <array>
#include <string_view>

#include "anatomy/ligament_slack.h"

namespace girdle {

// Writes the ligaments. They pull and never push: there is no force from length zero to slack.
void WriteLigaments(const ModelPlan& plan, XmlElement root) {
  XmlElement tendon = root.Add("tendon");
  for (std::size_t i = 0; i < kLigamentCount; ++i) {
    const Ligament& ligament = plan.anatomy.ligaments[i];
    for (const Side side : plan.sides) {
      XmlElement spatial =
          tendon.Add("spatial")
              .Set("name", SidedName(kLigamentNames[i], side))
              .Set("class", kDefaultsName)
              .Set("stiffness", ligament.stiffness_N_per_m)
              .Set("springlength", std::array{0.0, plan.slack_m[i]})
              .Set("range", std::array{0.0, TearingLength_m(ligament, plan.slack_m[i])});
      for (const Segment segment : {Segment::kClavicle, Segment::kScapula}) {
        const std::string_view bone = Name(segment);
        spatial.Add("site").Set("site", SidedName(LigamentEndName(kLigamentNames[i], bone), side));
      }
    }
  }
}

}  // namespace girdle
