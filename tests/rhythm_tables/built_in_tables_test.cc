// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "rhythm_tables/built_in_tables.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <fstream>
#include <glm/geometric.hpp>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "anatomy/built_in_anatomy.h"
#include "fits/table_smoothing.h"
#include "kinematics/shipped_data.h"
#include "rhythm_tables/built_in_files.h"
#include "rhythm_tables/rhythm_table_csv.h"
#include "text/text_in_data.h"

namespace girdle::built_in_tables_test {
namespace {

TEST(BuiltInTableFiles, AreThoseOfDataByteForByte) {
  EXPECT_EQ(built_in_files::kLudewig2009, TextInData("ludewig2009.csv"));
  EXPECT_EQ(built_in_files::kLudewig2009Smoothed, TextInData("ludewig2009_smoothed.csv"));
}

TEST(BuiltInRhythmTable, IsTheShippedTable) {
  const RhythmTable table = BuiltInRhythmTable(BuiltInTable::kMeasured);
  const RhythmTable expected = TableOf(MeasuredRows());
  EXPECT_EQ(table.planes_rad(), expected.planes_rad());
  EXPECT_EQ(table.elevations_rad(), expected.elevations_rad());
  for (std::size_t plane = 0; plane < 3; ++plane) {
    for (std::size_t elevation = 0; elevation < 22; ++elevation) {
      EXPECT_EQ(table.position(plane, elevation).angles_rad,
                expected.position(plane, elevation).angles_rad)
          << "plane " << plane << ", elevation " << elevation;
    }
  }
}

TEST(BuiltInTable, HasAWordThatReadsBack) {
  for (const auto& [table, word] : {std::pair(BuiltInTable::kMeasured, "measured"),
                                    std::pair(BuiltInTable::kSmoothed, "smoothed")}) {
    EXPECT_EQ(Name(table), word);
    EXPECT_EQ(FromName<BuiltInTable>(word), table);
  }
}

TEST(BuiltInTable, HasNoOtherWords) {
  for (const char* const word : {"", "Measured", "measured ", "measure", "ludewig2009"}) {
    EXPECT_EQ(FromName<BuiltInTable>(word), std::nullopt) << word;
  }
}

// A smooth curve swings where people dropped out; squad and slerp are as published.
TEST(DefaultTable, IsWithoutStepsForSmoothAlone) {
  EXPECT_EQ(DefaultTable(Interpolation::kSmooth), BuiltInTable::kSmoothed);
  EXPECT_EQ(DefaultTable(Interpolation::kSquad), BuiltInTable::kMeasured);
  EXPECT_EQ(DefaultTable(Interpolation::kSlerp), BuiltInTable::kMeasured);
}

TEST(BuiltInRhythm, HasTheDefaultTableOfItsInterpolation) {
  for (const Interpolation interpolation :
       {Interpolation::kSmooth, Interpolation::kSquad, Interpolation::kSlerp}) {
    const ShoulderRhythm rhythm = BuiltInRhythm({.interpolation = interpolation});
    EXPECT_EQ(rhythm.options().interpolation, interpolation);
    EXPECT_EQ(RhythmTableToLine(rhythm.table()),
              RhythmTableToLine(BuiltInRhythmTable(DefaultTable(interpolation))))
        << Name(interpolation);
  }
}

TEST(BuiltInRhythm, IsSmoothAndExactOverTheWholeRangeUnlessToldOtherwise) {
  const ShoulderRhythm rhythm = BuiltInRhythm();
  EXPECT_EQ(rhythm.options().interpolation, Interpolation::kSmooth);
  EXPECT_EQ(rhythm.options().closure, Closure::kExact);
  EXPECT_EQ(rhythm.options().range, Range::kWhole);
  const ArmRectangle& domain = rhythm.domain();
  EXPECT_EQ(domain.lowest_elevation_rad, 0);
  EXPECT_EQ(domain.highest_elevation_rad, kPi);
  EXPECT_EQ(domain.first_plane_rad, RadiansFromDegrees(-95));
  EXPECT_EQ(domain.last_plane_rad, RadiansFromDegrees(135));
}

TEST(BuiltInRhythm, IsBoundedByTheBuiltInJointRanges) {
  const ShoulderRhythm rhythm = BuiltInRhythm();
  const Anatomy anatomy = BuiltInAnatomy();
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    EXPECT_EQ(rhythm.ranges()[k].lower_rad, anatomy.ranges[k].lower_rad) << kCoordinateNames[k];
    EXPECT_EQ(rhythm.ranges()[k].upper_rad, anatomy.ranges[k].upper_rad) << kCoordinateNames[k];
  }
}

// Ludewig et al. 2009, relaxed standing.
TEST(RelaxedStanding, HasThePublishedAngles) {
  constexpr double kRounding = 1e-14;
  const Posture posture = RelaxedStanding();
  const JointAngles published_rad = Radians({-19.2, -5.9, 0, 60, -2.5, -8.4, 0, 0, 0});
  const ShoulderPose published = PoseFromAngles(published_rad);
  EXPECT_LT(AngleBetween(posture.q_TC, published.q_TC), kRounding);
  EXPECT_LT(AngleBetween(posture.q_CS, published.q_CS), kRounding);
}

// The file is the fit rounded to its decimals.
TEST(BuiltInRhythmTable, HasTheMeasuredTableWithoutItsSteps) {
  constexpr double kHalfOfTheLastDecimal_deg = 0.5e-4;
  constexpr double kRounding_deg = 1e-9;
  const RhythmTable measured = BuiltInRhythmTable(BuiltInTable::kMeasured);
  const RhythmTable smoothed = BuiltInRhythmTable(BuiltInTable::kSmoothed);
  const RhythmTable expected = Smoothed(measured);
  ASSERT_EQ(smoothed.planes_rad(), measured.planes_rad());
  ASSERT_EQ(smoothed.elevations_rad(), measured.elevations_rad());
  for (std::size_t plane = 0; plane < 3; ++plane) {
    for (std::size_t elevation = 0; elevation < 22; ++elevation) {
      const RhythmPosition& position = smoothed.position(plane, elevation);
      for (std::size_t k = 0; k < kCoordinateCount; ++k) {
        EXPECT_NEAR(DegreesFromRadians(position.angles_rad[k]),
                    DegreesFromRadians(expected.position(plane, elevation).angles_rad[k]),
                    kHalfOfTheLastDecimal_deg + kRounding_deg)
            << kCoordinateNames[k] << ", plane " << plane << ", elevation " << elevation;
      }
      EXPECT_EQ(position.measured, measured.position(plane, elevation).measured);
      EXPECT_EQ(position.scapulothoracic_rad,
                measured.position(plane, elevation).scapulothoracic_rad);
    }
  }
}

TEST(BuiltInAnatomy, HasTheShippedLandmarks) {
  const Anatomy anatomy = BuiltInAnatomy();
  const auto shipped_m = ShippedLandmarks();
  ASSERT_EQ(shipped_m.size(), kLandmarkCount);
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    EXPECT_EQ(anatomy.landmarks_m[i], shipped_m.at(std::string(kLandmarks[i].name)))
        << kLandmarks[i].name;
  }
}

TEST(BuiltInAnatomy, HasAMassForEverySegment) {
  for (const SegmentInertia& segment : BuiltInAnatomy().segments) {
    EXPECT_GT(segment.mass_kg, 0);
  }
}

// The published lengths of the specimen, to the millimetre's tenth that is printed.
TEST(BuiltInAnatomy, HasThePublishedLengths) {
  constexpr double kPrinted_m = 0.00005;
  constexpr double kPrintedWhole_m = 0.0005;
  const Anatomy anatomy = BuiltInAnatomy();
  const auto length_m = [&](Landmark a, Landmark b) {
    return glm::length(anatomy.landmark_m(a) - anatomy.landmark_m(b));
  };
  EXPECT_NEAR(glm::length(anatomy.landmark_m(Landmark::kPAC)), 0.1575, kPrinted_m);
  EXPECT_NEAR(glm::length(anatomy.landmark_m(Landmark::kTS)), 0.129, kPrintedWhole_m);
  EXPECT_NEAR(length_m(Landmark::kTS, Landmark::kAI), 0.118, kPrintedWhole_m);
  EXPECT_NEAR(glm::length(anatomy.elbow_m()), 0.2871, kPrinted_m);
}

TEST(BuiltInAnatomy, HasRangesThatHoldTheMeasuredRhythmWithRoomToSpare) {
  constexpr double kRoom_deg = 5;
  const Anatomy anatomy = BuiltInAnatomy();
  for (const MeasuredRow& row : MeasuredRows()) {
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      EXPECT_GT(row.angles_deg[k], DegreesFromRadians(anatomy.ranges[k].lower_rad) + kRoom_deg)
          << kCoordinateNames[k] << ", plane " << row.plane_deg << ", elevation "
          << row.elevation_deg;
      EXPECT_LT(row.angles_deg[k], DegreesFromRadians(anatomy.ranges[k].upper_rad) - kRoom_deg)
          << kCoordinateNames[k] << ", plane " << row.plane_deg << ", elevation "
          << row.elevation_deg;
    }
  }
}

}  // namespace
}  // namespace girdle::built_in_tables_test
