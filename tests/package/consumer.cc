// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include <girdle/kinematics/shoulder_rhythm.h>
#include <girdle/mjcf/shoulder_model.h>
#include <girdle/rhythm_tables/built_in_tables.h>

#include <cstdio>

int main() {
  const girdle::ShoulderRhythm rhythm(girdle::BuiltInRhythmTable(girdle::BuiltInTable::kMeasured));
  const auto solution = rhythm.Solve({girdle::RadiansFromDegrees(90), 0, 0});
  std::printf("%.6f\n", girdle::DegreesFromRadians(girdle::AnglesFromPose(solution.pose)[0]));
  return girdle::ShoulderModelXml(girdle::BuiltInAnatomy(), rhythm,
                                  {.table = girdle::BuiltInTable::kMeasured})
                 .empty()
             ? 1
             : 0;
}
