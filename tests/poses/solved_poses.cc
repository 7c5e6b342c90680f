// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Reads a rhythm table and prints what every interpolation makes of it over the whole range, in
/// all digits, so that builds by different compilers can be held against each other.
#include <cstdio>
#include <exception>
#include <fstream>
#include <optional>
#include <string>

#include "anatomy/built_in_anatomy.h"
#include "kinematics/shoulder_rhythm.h"
#include "rhythm_tables/rhythm_table_csv.h"
#include "text/number_text.h"
#include "text/text_file.h"

namespace girdle {
namespace {

void Append(std::string& line, double number) {
  line += ' ';
  AppendNumber(line, number);
}

void Append(std::string& line, const Vector3& vector) {
  Append(line, vector.x);
  Append(line, vector.y);
  Append(line, vector.z);
}

void PrintPoses(const ShoulderRhythm& rhythm) {
  constexpr double kStep_deg = 7.5;
  for (double elevation_deg = 0; elevation_deg <= kHalfCircle_deg; elevation_deg += kStep_deg) {
    for (double plane_deg = -60; plane_deg <= 135; plane_deg += kStep_deg) {
      const ArmCommand command{RadiansFromDegrees(elevation_deg), RadiansFromDegrees(plane_deg),
                               0.1, 0.05, -0.05};
      const ShoulderSolution solution = rhythm.Solve(command);
      std::string line(Name(rhythm.options().interpolation));
      for (const double angle_rad : AnglesFromPose(solution.pose)) {
        Append(line, angle_rad);
      }
      Append(line, solution.distance_rad);
      if (const std::optional<ShoulderRates> rates = rhythm.SolveRates(command)) {
        for (const AngularRate& rate : rates->joints) {
          Append(line, rate.by_elevation);
          Append(line, rate.by_plane);
        }
      }
      std::puts(line.c_str());
    }
  }
}

}  // namespace
}  // namespace girdle

int main(int argc, char** argv) {
  try {
    if (argc != 2) {
      std::fputs("usage: solved_poses TABLE\n", stderr);
      return 2;
    }
    std::ifstream in = girdle::OpenTextFile(argv[1]);
    const girdle::RhythmTable table = girdle::ReadRhythmTable(in, argv[1]);
    const girdle::JointRanges ranges = girdle::BuiltInAnatomy().ranges;
    for (const auto interpolation : {girdle::Interpolation::kSmooth, girdle::Interpolation::kSquad,
                                     girdle::Interpolation::kSlerp}) {
      girdle::PrintPoses(girdle::ShoulderRhythm(table, {interpolation}, ranges));
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
