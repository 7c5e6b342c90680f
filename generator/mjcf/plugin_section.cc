// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "mjcf/model_sections.h"

#include <string>
#include <string_view>

#include "names/joint_dynamics.h"
#include "rhythm_tables/rhythm_table_csv.h"
#include "text/number_text.h"

namespace girdle {
namespace {

void WriteInstance(const ModelPlan& plan, XmlElement plugin, Side side) {
  XmlElement instance = plugin.Add("instance").Set("name", SidedName(kRhythmName, side));
  const auto configure = [&instance](const char* key, std::string_view value) {
    instance.Add("config").Set("key", key).Set("value", value);
  };
  configure(kInterpolationKey, Name(plan.rhythm().options().interpolation));
  configure(kClosureKey, Name(plan.rhythm().options().closure));
  configure(kRangeKey, Name(*plan.rhythm().options().range));
  if (plan.options.axial_from != AxialFrom::kRhythm) {
    configure(kAxialFromKey, Name(plan.options.axial_from));
  }
  if (plan.options.table) {
    configure(kTableKey, Name(*plan.options.table));
  }
  std::string stiffness;
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    stiffness += (stiffness.empty() ? "" : " ") + NumberText(plan.StiffnessOf(k));
  }
  configure(kStiffnessKey, stiffness);
  if (plan.drives_place()) {
    configure(kTranslationStiffnessKey, NumberText(kLeadingTranslation.stiffness_N_per_m));
  }
  if (side == Side::kLeft) {
    configure(kSideKey, Name(side));
  }
  if (!plan.options.table) {
    configure(kTableKey, RhythmTableToLine(plan.rhythm().table()));
  }
}

}  // namespace

void WriteExtension(const ModelPlan& plan, XmlElement root) {
  if (!plan.has_plugin()) {
    return;
  }
  const XmlElement plugin = root.Add("extension").Add("plugin").Set("plugin", kPluginName);
  for (const Side side : plan.sides) {
    WriteInstance(plan, plugin, side);
  }
}

void WriteSensors(const ModelPlan& plan, XmlElement root) {
  if (!plan.has_plugin()) {
    return;
  }
  XmlElement sensor = root.Add("sensor");
  for (const Side side : plan.sides) {
    sensor.Add("plugin")
        .Set("name", SidedName(kRhythmName, side))
        .Set("instance", SidedName(kRhythmName, side));
  }
}

}  // namespace girdle
