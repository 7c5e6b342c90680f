// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "anatomy/anatomy_line.h"
#include "mjcf/model_sections.h"

namespace girdle {

void WriteAnatomy(const ModelPlan& plan, XmlElement root) {
  root.Add("custom").Add("text").Set("name", kAnatomyName).Set("data", AnatomyAsLine(plan.anatomy));
}

}  // namespace girdle
