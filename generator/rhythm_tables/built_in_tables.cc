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
  return interpolation == Interpolation::kSmooth ? BuiltInTable::kSmoothed
                                                 : BuiltInTable::kMeasured;
}

RhythmTable BuiltInRhythmTable(BuiltInTable table) {
  const bool is_smoothed = table == BuiltInTable::kSmoothed;
  std::istringstream in{std::string(is_smoothed ? built_in_files::kLudewig2009Smoothed
                                                : built_in_files::kLudewig2009)};
  return ReadRhythmTable(in,
                         is_smoothed ? "data/ludewig2009_smoothed.csv" : "data/ludewig2009.csv");
}

ShoulderRhythm BuiltInRhythm(const RhythmOptions& options) {
  return MakeRhythm(Resolve({options.interpolation, options.closure, options.range}),
                    BuiltInAnatomy().ranges);
}

}  // namespace girdle
