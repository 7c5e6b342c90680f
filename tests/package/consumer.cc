// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include <girdle/girdle.h>

#include <cstdio>
#include <sstream>

int main() {
  const girdle::ShoulderRhythm rhythm(girdle::BuiltInRhythmTable(girdle::BuiltInTable::kMeasured));
  const auto solution = rhythm.Solve({girdle::RadiansFromDegrees(90), 0, 0});
  std::printf("%.6f\n", girdle::DegreesFromRadians(girdle::AnglesFromPose(solution.pose)[0]));
  try {
    std::istringstream no_table("plane_deg\n");
    static_cast<void>(girdle::ReadRhythmTable(no_table, "table.csv"));
    return 1;
  } catch (const girdle::InputError& error) {
    std::puts(error.what());
  }
  const girdle::Anatomy anatomy = girdle::BuiltInAnatomy();
  const std::string model =
      girdle::ShoulderModelXml(anatomy, rhythm, {.table = girdle::BuiltInTable::kMeasured});
  const std::string name = girdle::SidedName(girdle::kCoordinateNames[0], girdle::Side::kRight);
  return model.find(name) == std::string::npos || girdle::SceneXml("model.xml", anatomy).empty();
}
