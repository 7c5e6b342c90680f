// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "anatomy/bone_frames.h"

#include <cstddef>

#include "kinematics/isb_frames.h"

namespace girdle {

Quaternion BoneRotation(Segment segment, const LandmarkPositions& p_A_m) noexcept {
  const auto at = [&](Landmark landmark) -> const Vector3& {
    return p_A_m[static_cast<std::size_t>(landmark)];
  };
  const auto thorax = [&] {
    return ThoraxFrame(at(Landmark::kIJ), at(Landmark::kPX), at(Landmark::kC7), at(Landmark::kT8));
  };
  switch (segment) {
    case Segment::kThorax:
      return thorax();
    case Segment::kClavicle:
      return ClavicleFrame(at(Landmark::kSC), at(Landmark::kPAC), thorax() * Vector3(0, 1, 0));
    case Segment::kScapula:
      return ScapulaFrame(at(Landmark::kPAC), at(Landmark::kTS), at(Landmark::kAI));
    case Segment::kHumerus:
      break;
  }
  return HumerusFrame(at(Landmark::kGH), at(Landmark::kEM), at(Landmark::kEL));
}

BoneFrames BoneFramesOf(const LandmarkPositions& p_A_m) noexcept {
  constexpr std::array<Landmark, kSegmentCount> kOrigins = {Landmark::kIJ, Landmark::kSC,
                                                            Landmark::kPAC, Landmark::kGH};
  BoneFrames frames;
  for (std::size_t i = 0; i < kSegmentCount; ++i) {
    frames.q_AB[i] = BoneRotation(static_cast<Segment>(i), p_A_m);
    frames.p_AB_m[i] = p_A_m[static_cast<std::size_t>(kOrigins[i])];
  }
  return frames;
}

}  // namespace girdle
