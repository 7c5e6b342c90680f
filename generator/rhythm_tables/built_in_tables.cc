// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "rhythm_tables/built_in_tables.h"

#include <algorithm>
#include <sstream>
#include <string>

#include "anatomy/built_in_anatomy.h"
#include "rhythm_tables/built_in_files.h"
#include "rhythm_tables/rhythm_table_csv.h"

namespace girdle {

std::optional<BuiltInTable> BuiltInTableFromName(std::string_view name) noexcept {
  const auto found = std::find(kBuiltInTableNames.begin(), kBuiltInTableNames.end(), name);
  if (found == kBuiltInTableNames.end()) {
    return std::nullopt;
  }
  return static_cast<BuiltInTable>(found - kBuiltInTableNames.begin());
}

std::string_view Name(BuiltInTable table) noexcept {
  return kBuiltInTableNames[static_cast<std::size_t>(table)];
}

BuiltInTable DefaultTable(Interpolation interpolation) noexcept {
  return interpolation == Interpolation::kSmooth ? BuiltInTable::kDestepped
                                                 : BuiltInTable::kMeasured;
}

RhythmTable BuiltInRhythmTable(BuiltInTable table) {
  const bool is_destepped = table == BuiltInTable::kDestepped;
  std::istringstream in{std::string(is_destepped ? built_in_files::kLudewig2009Destepped
                                                 : built_in_files::kLudewig2009)};
  return ReadRhythmTable(in,
                         is_destepped ? "data/ludewig2009_destepped.csv" : "data/ludewig2009.csv");
}

ShoulderRhythm BuiltInRhythm(const RhythmOptions& options) {
  return ShoulderRhythm(BuiltInRhythmTable(DefaultTable(options.interpolation)), options,
                        BuiltInAnatomy().ranges);
}

}  // namespace girdle
