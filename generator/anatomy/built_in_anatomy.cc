// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "anatomy/built_in_anatomy.h"

#include <sstream>
#include <string>

#include "anatomy/built_in_files.h"

namespace girdle {

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

Posture RelaxedStanding() {
  std::istringstream postures{std::string(built_in_files::kPostures)};
  return ReadPosture(postures, "data/postures.csv", "relaxed");
}

}  // namespace girdle
