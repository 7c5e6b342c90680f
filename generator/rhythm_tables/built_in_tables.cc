// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "rhythm_tables/built_in_tables.h"

#include <sstream>
#include <string>

#include "anatomy/built_in_anatomy.h"
#include "rhythm_tables/built_in_files.h"
#include "rhythm_tables/rhythm_choice.h"
#include "rhythm_tables/rhythm_table_csv.h"

namespace girdle {

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
  return MakeRhythm(Resolve({options.interpolation, options.closure, options.range}),
                    BuiltInAnatomy().ranges);
}

}  // namespace girdle
