// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include <girdle/kinematics/shoulder_rhythm.h>
#include <girdle/mjcf/shoulder_model.h>
#include <girdle/tables/built_in.h>

#include <cstdio>

int main() {
  // The published method, at one of the table's own positions.
  const girdle::ShoulderRhythm published =
      girdle::BuiltInRhythm({girdle::Interpolation::kSquad, girdle::Closure::kTable});
  const auto solution = published.Solve({girdle::RadiansFromDegrees(90)});
  std::printf("%.6f\n", girdle::DegreesFromRadians(girdle::AnglesFromPose(solution.pose)[0]));
  const girdle::ShoulderRhythm rhythm = girdle::BuiltInRhythm();
  return girdle::ShoulderModelXml(girdle::BuiltInAnatomy(), rhythm).empty() ? 1 : 0;
}
