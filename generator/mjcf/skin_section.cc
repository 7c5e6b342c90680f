// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "mjcf/model_sections.h"

#include <array>
#include <vector>

namespace girdle {
namespace {

constexpr std::array<double, 4> kSkinColor = {0.82, 0.71, 0.62, 1};

}  // namespace

void WriteSkin(const ModelPlan& plan, XmlElement root) {
  if (!plan.options.skin) {
    return;
  }
  XmlElement custom = root.Add("custom");
  root.Add("deformable")
      .Add("skin")
      .Set("name", kSkinName)
      .Set("file", plan.options.skin->file)
      .Set("rgba", kSkinColor);
  for (std::size_t i = 0; i < plan.sides.size(); ++i) {
    for (std::size_t k = 0; k < kSkinLandmarkCount; ++k) {
      const std::vector<int>& vertices = plan.options.skin->landmarks[i][k];
      custom.Add("numeric")
          .Set("name", SidedName(kSkinLandmarkNames[k], plan.sides[i]))
          .Set("data", std::vector<double>(vertices.begin(), vertices.end()));
    }
  }
}

}  // namespace girdle
