// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "anatomy/posed_bones.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "anatomy/built_in_anatomy.h"
#include "rhythm_tables/built_in_tables.h"

namespace girdle::posed_bones_test {
namespace {

// Of sums and products of numbers of the size of a shoulder.
constexpr double kRounding_m = 1e-15;
constexpr double kMillimetersPerMeter = 1000;

// Three bones, one along each axis in their own frames.
Anatomy ThreeRods() {
  Anatomy anatomy;
  const auto put = [&anatomy](Landmark landmark, const Vector3& position_m) {
    anatomy.landmarks_m[static_cast<std::size_t>(landmark)] = position_m;
  };
  put(Landmark::kSC, {0.01, 0.02, 0.03});
  put(Landmark::kPAC, {0, 0, 0.2});
  put(Landmark::kTS, {0, 0, -0.1});
  put(Landmark::kGH, {0.05, 0, 0});
  put(Landmark::kEL, {0, -0.3, 0});
  return anatomy;
}

// Quarter turns about y: z to x, x to -z.
const Quaternion kStraight{1, 0, 0, 0};
const Quaternion kQuarter{std::sqrt(0.5), 0, std::sqrt(0.5), 0};
const Quaternion kQuarterAboutX{std::sqrt(0.5), std::sqrt(0.5), 0, 0};  // y to z, z to -y

void ExpectAt(const Vector3& position_m, const Vector3& expected_m) {
  EXPECT_LT(glm::distance(position_m, expected_m), kRounding_m)
      << position_m.x << " " << position_m.y << " " << position_m.z;
}

// However the thorax stands, and for a left shoulder, which is the right one's mirror image, too.
TEST(PoseOfBones, IsThePoseThatTurnedThem) {
  const ShoulderPose pose = BuiltInRhythm().SolvePose({1.9, 0.4});
  const Quaternion q_WT = Exp({0.4, -1.1, 0.7});
  const std::array<Quaternion, kSegmentCount> q_TB = {Quaternion(1, 0, 0, 0), pose.q_TC,
                                                      pose.q_TS(), pose.q_TH()};
  for (const Side side : {Side::kRight, Side::kLeft}) {
    std::array<Quaternion, kSegmentCount> q_WB{};
    std::transform(q_TB.begin(), q_TB.end(), q_WB.begin(), [&](const Quaternion& q) {
      return q_WT * (side == Side::kRight ? q : Mirrored(q));
    });
    const ShoulderPose found = PoseOfBones(side, q_WB);
    constexpr double kRounding_rad = 1e-13;
    EXPECT_LT(AngleBetween(found.q_TC, pose.q_TC), kRounding_rad);
    EXPECT_LT(AngleBetween(found.q_CS, pose.q_CS), kRounding_rad);
    EXPECT_LT(AngleBetween(found.q_SH, pose.q_SH), kRounding_rad);
  }
}

TEST(LandmarkInThorax, ChainsTheBones) {
  const Anatomy anatomy = ThreeRods();
  const ShoulderPose pose{kQuarter, kQuarter, kQuarterAboutX};
  ExpectAt(LandmarkInThorax_m(anatomy, pose, Landmark::kSC), {0.01, 0.02, 0.03});
  // The clavicle turned by a quarter: its z is the thorax's x.
  ExpectAt(LandmarkInThorax_m(anatomy, pose, Landmark::kPAC), {0.21, 0.02, 0.03});
  // The scapula turned by a half in all: z to -z, x to -x.
  ExpectAt(LandmarkInThorax_m(anatomy, pose, Landmark::kTS), {0.21, 0.02, 0.13});
  ExpectAt(LandmarkInThorax_m(anatomy, pose, Landmark::kGH), {0.16, 0.02, 0.03});
  // The humerus's -y is the scapula's -z, the thorax's z.
  ExpectAt(LandmarkInThorax_m(anatomy, pose, Landmark::kEL), {0.16, 0.02, 0.33});
}

TEST(LigamentLength, IsTheDistanceOfItsAttachments) {
  const Anatomy anatomy = ThreeRods();
  Ligament ligament;
  ligament.clavicle_m = {0, 0, 0.17};  // 30 mm before PAC
  ligament.scapula_m = {0.04, 0, 0};   // 40 mm in front of it
  const auto length_m = [&](const Quaternion& q_TC, const Quaternion& q_CS) {
    return LigamentLength_m(ligament, anatomy, {q_TC, q_CS, kStraight});
  };
  EXPECT_NEAR(length_m(kStraight, kStraight), 0.05, kRounding_m);
  // The scapula's x along the clavicle's -z: both on one line, on the same side of PAC.
  EXPECT_NEAR(length_m(kStraight, kQuarter), 0.01, kRounding_m);
  // A turn of the clavicle takes both along.
  EXPECT_NEAR(length_m(kQuarter, kStraight), 0.05, kRounding_m);
}

struct LengthCase {
  LigamentName ligament;
  double shortest_mm;  // of elevation 30 to 120, planes 0 to 90
  double longest_mm;
};

class LigamentOverTheTable : public testing::TestWithParam<LengthCase> {};

TEST_P(LigamentOverTheTable, HasThePublishedModelsLengths) {
  // The attachments are those of published models to 0.1 mm each.
  constexpr double kRounded_mm = 0.2;
  const Anatomy anatomy = BuiltInAnatomy();
  const RhythmTable table = BuiltInRhythmTable(BuiltInTable::kMeasured);
  std::vector<double> lengths_mm;
  for (std::size_t plane = 0; plane < table.planes_rad().size(); ++plane) {
    for (std::size_t elevation = 0; elevation < table.elevations_rad().size(); ++elevation) {
      const RhythmPosition& position = table.position(plane, elevation);
      if (position.measured) {
        lengths_mm.push_back(kMillimetersPerMeter *
                             LigamentLength_m(anatomy.ligament(GetParam().ligament), anatomy,
                                              PoseFromAngles(position.angles_rad)));
      }
    }
  }
  EXPECT_NEAR(*std::min_element(lengths_mm.begin(), lengths_mm.end()), GetParam().shortest_mm,
              kRounded_mm);
  EXPECT_NEAR(*std::max_element(lengths_mm.begin(), lengths_mm.end()), GetParam().longest_mm,
              kRounded_mm);
}

TEST_P(LigamentOverTheTable, IsJustSlackWhereItIsLongest) {
  const Anatomy anatomy = BuiltInAnatomy();
  const Ligament& ligament = anatomy.ligament(GetParam().ligament);
  double longest_m = 0;
  for (const BuiltInTable table : {BuiltInTable::kMeasured, BuiltInTable::kSmoothed}) {
    for (const Interpolation interpolation :
         {Interpolation::kSmooth, Interpolation::kSquad, Interpolation::kSlerp}) {
      RhythmOptions options;
      options.interpolation = interpolation;
      options.range = Range::kClamp;
      const ShoulderRhythm rhythm(BuiltInRhythmTable(table), options, anatomy.ranges);
      for (int elevation_deg = 15; elevation_deg <= 120; ++elevation_deg) {
        for (int plane_deg = 0; plane_deg <= 90; plane_deg += 2) {
          const ShoulderPose pose =
              rhythm.SolvePose({RadiansFromDegrees(elevation_deg), RadiansFromDegrees(plane_deg)});
          longest_m = std::max(longest_m, LigamentLength_m(ligament, anatomy, pose));
        }
      }
    }
  }
  // The file rounds up to 0.1 mm.
  constexpr double kRounding_up_m = 0.0001;
  EXPECT_LE(longest_m, ligament.slack_m);
  EXPECT_GT(longest_m, ligament.slack_m - kRounding_up_m);
}

INSTANTIATE_TEST_SUITE_P(Both, LigamentOverTheTable,
                         testing::Values(LengthCase{LigamentName::kConoid, 18.7, 23.8},
                                         LengthCase{LigamentName::kTrapezoid, 19.4, 21.7}),
                         [](const testing::TestParamInfo<LengthCase>& test) {
                           return std::string(Name(test.param.ligament));
                         });

}  // namespace
}  // namespace girdle::posed_bones_test
