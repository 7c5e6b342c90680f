// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/shoulder_points.h"

#include "anatomy/posed_bones.h"
#include "kinematics/lengths.h"
#include "text/small_letters.h"

namespace girdle {

std::vector<ShoulderPoint> ShoulderPoints(const Anatomy& anatomy, const ShoulderPose& pose) {
  std::vector<ShoulderPoint> points = {
      {"elbow",
       kMillimetersPerMeter * InThorax_m(anatomy, pose, Segment::kHumerus, anatomy.elbow_m())}};
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    if (kLandmarks[i].sided) {  // the other landmarks are on the thorax and do not move
      points.push_back(
          {InSmallLetters(kLandmarks[i].name),
           kMillimetersPerMeter * LandmarkInThorax_m(anatomy, pose, static_cast<Landmark>(i))});
    }
  }
  return points;
}

}  // namespace girdle
