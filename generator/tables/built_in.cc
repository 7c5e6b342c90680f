// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "tables/built_in.h"

#include <algorithm>
#include <sstream>
#include <string>

#include "tables/built_in_files.h"
#include "tables/rhythm_table_csv.h"

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

Anatomy BuiltInAnatomy() {
  Anatomy anatomy;
  std::istringstream landmarks{std::string(built_in_files::kLandmarks)};
  ReadLandmarks(landmarks, "data/landmarks.csv", anatomy);
  std::istringstream segments{std::string(built_in_files::kSegments)};
  ReadSegments(segments, "data/segments.csv", anatomy);
  std::istringstream ranges{std::string(built_in_files::kJointRanges)};
  ReadJointRanges(ranges, "data/joint_ranges.csv", anatomy);
  std::istringstream ellipsoids{std::string(built_in_files::kThoraxEllipsoids)};
  ReadThoraxEllipsoids(ellipsoids, "data/thorax_ellipsoids.csv", anatomy);
  std::istringstream ligaments{std::string(built_in_files::kLigaments)};
  ReadLigaments(ligaments, "data/ligaments.csv", anatomy);
  return anatomy;
}

ShoulderRhythm BuiltInRhythm(const RhythmOptions& options) {
  return ShoulderRhythm(BuiltInRhythmTable(DefaultTable(options.interpolation)), options,
                        BuiltInAnatomy().ranges);
}

Posture RelaxedStanding() {
  std::istringstream postures{std::string(built_in_files::kPostures)};
  return ReadPosture(postures, "data/postures.csv", "relaxed");
}

}  // namespace girdle
