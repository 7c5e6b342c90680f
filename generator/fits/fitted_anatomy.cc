// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "fits/fitted_anatomy.h"

#include <algorithm>

#include "anatomy/posed_bones.h"
#include "fits/gliding_fit.h"
#include "kinematics/lengths.h"
#include "rhythm_tables/built_in_tables.h"

namespace girdle {
namespace {

double LongestLength_m(const Ligament& ligament, const Anatomy& anatomy, const RhythmTable& table) {
  double longest_m = 0;
  for (std::size_t plane = 0; plane < table.planes_rad().size(); ++plane) {
    for (std::size_t elevation = 0; elevation < table.elevations_rad().size(); ++elevation) {
      const ShoulderPose pose = PoseFromAngles(table.position(plane, elevation).angles_rad);
      longest_m = std::max(longest_m, LigamentLength_m(ligament, anatomy, pose));
    }
  }
  return longest_m;
}

}  // namespace

void FitGliding(Anatomy& anatomy) {
  anatomy.gliding =
      FitGlidingEllipsoid(anatomy, BuiltInRhythmTable(BuiltInTable::kSmoothed)).ellipsoid;
}

void FitLigaments(Anatomy& anatomy) {
  const RhythmTable measured = BuiltInRhythmTable(BuiltInTable::kMeasured);
  const RhythmTable smoothed = BuiltInRhythmTable(BuiltInTable::kSmoothed);
  for (Ligament& ligament : anatomy.ligaments) {
    ligament.slack_m = RoundedUpLength_m(std::max(LongestLength_m(ligament, anatomy, measured),
                                                  LongestLength_m(ligament, anatomy, smoothed)));
  }
}

}  // namespace girdle
