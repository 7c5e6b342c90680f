// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "anatomy/ligament_slack.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "anatomy/built_in_anatomy.h"
#include "anatomy/posed_bones.h"
#include "anatomy/postures.h"
#include "kinematics/lengths.h"

namespace girdle {
namespace {

// Calls `visit(command)` over the whole domain, in steps of a degree.
template <typename Visit>
void ForEachCommand(const ArmRectangle& domain, const Visit& visit) {
  constexpr double kStep_rad = kRadiansPerDegree;
  const auto steps = [](double from_rad, double to_rad) {
    return static_cast<int>(std::ceil((to_rad - from_rad) / kStep_rad - 0.5));
  };
  const int planes = steps(domain.first_plane_rad, domain.last_plane_rad);
  const int elevations = steps(domain.lowest_elevation_rad, domain.highest_elevation_rad);
  for (int j = 0; j <= planes; ++j) {
    for (int i = 0; i <= elevations; ++i) {
      visit(ArmCommand{domain.lowest_elevation_rad + i * kStep_rad,
                       domain.first_plane_rad + j * kStep_rad});
    }
  }
}

void TakeLonger(const Anatomy& anatomy, const ShoulderPose& pose, LigamentLengths& longest_m) {
  for (std::size_t i = 0; i < kLigamentCount; ++i) {
    longest_m[i] = std::max(longest_m[i], LigamentLength_m(anatomy.ligaments[i], anatomy, pose));
  }
}

}  // namespace

LigamentLengths SlackFor_m(const Anatomy& anatomy, const AssembledRhythm& rhythm,
                           const AskedPoseVisit& visit) {
  LigamentLengths longest_m{};
  TakeLonger(anatomy, HangingIn(RelaxedStanding(), rhythm.rhythm()), longest_m);
  ForEachCommand(rhythm.rhythm().domain(), [&](const ArmCommand& command) {
    ArmCommand used;
    const ShoulderPose pose = rhythm.SolvePose(command, &used);
    visit(used, pose);
    TakeLonger(anatomy, pose, longest_m);
  });
  LigamentLengths slack_m{};
  for (std::size_t i = 0; i < kLigamentCount; ++i) {
    slack_m[i] = std::max(anatomy.ligaments[i].slack_m, RoundedUpLength_m(longest_m[i]));
  }
  return slack_m;
}

double TearingLength_m(const Ligament& ligament, double slack_m) noexcept {
  return RoundedLength_m(slack_m + ligament.failure_elongation_m);
}

}  // namespace girdle
