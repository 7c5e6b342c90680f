// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "anatomy/anatomy_line.h"

#include <gtest/gtest.h>

#include <string>

#include "anatomy/body_size.h"
#include "anatomy/built_in_anatomy.h"
#include "text/input_error.h"

namespace girdle::anatomy_line_test {
namespace {

TEST(AnatomyLine, ReadsBackAsItIs) {
  BodySize size;
  size.stature_m = 1.853;
  for (const Anatomy& anatomy : {BuiltInAnatomy(), ScaledAnatomy(BuiltInAnatomy(), size)}) {
    const std::string line = AnatomyAsLine(anatomy);
    const Anatomy read = AnatomyFromLine(line, "model.xml");
    EXPECT_EQ(AnatomyAsLine(read), line);
    EXPECT_EQ(read.landmark_m(Landmark::kEL), anatomy.landmark_m(Landmark::kEL));
    EXPECT_EQ(read.segment(Segment::kHumerus).mass_kg, anatomy.segment(Segment::kHumerus).mass_kg);
    EXPECT_EQ(read.gliding.radii_m, anatomy.gliding.radii_m);
    EXPECT_EQ(read.ligament(LigamentName::kTrapezoid).slack_m,
              anatomy.ligament(LigamentName::kTrapezoid).slack_m);
    EXPECT_EQ(read.jugular_notch_height_m, anatomy.jugular_notch_height_m);
    EXPECT_EQ(read.has_adult_proportions, anatomy.has_adult_proportions);
  }
}

TEST(AnatomyLine, KeepsWhetherTheBonesAreThoseOfAnAdult) {
  Anatomy anatomy = BuiltInAnatomy();
  anatomy.has_adult_proportions = false;
  EXPECT_FALSE(AnatomyFromLine(AnatomyAsLine(anatomy), "model.xml").has_adult_proportions);
}

TEST(AnatomyLine, DiffersForAnotherAnatomyInEveryNumber) {
  // One number of each row, the last.
  const std::string line = AnatomyAsLine(BuiltInAnatomy());
  Anatomy other = BuiltInAnatomy();
  other.ligaments.back().published_sd_m += 1e-9;
  EXPECT_NE(AnatomyAsLine(other), line);
  other = BuiltInAnatomy();
  other.ranges.front().lower_rad += 1e-9;
  EXPECT_NE(AnatomyAsLine(other), line);
  other = BuiltInAnatomy();
  other.segments.back().inertia_kg_m2.z += 1e-9;
  EXPECT_NE(AnatomyAsLine(other), line);
}

struct BadLine {
  const char* what;
  std::string line;
  const char* message;
};

class BadAnatomyLine : public testing::TestWithParam<BadLine> {};

std::string Replaced(const std::string& from, const std::string& to) {
  std::string line = AnatomyAsLine(BuiltInAnatomy());
  const std::size_t at = line.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return line.replace(at, from.size(), to);
}

TEST_P(BadAnatomyLine, IsRefusedWithThePlaceAndWhatIsExpected) {
  try {
    static_cast<void>(AnatomyFromLine(GetParam().line, "arm.xml"));
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()), std::string("arm.xml: expected ") + GetParam().message +
                                             ". Generate the model again with girdle generate");
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, BadAnatomyLine,
    testing::Values(
        BadLine{"Empty", "", "IJ with 3 numbers"},
        BadLine{"AnotherName", Replaced("IJ 0 0 0", "XY 0 0 0"), "IJ with 3 numbers"},
        BadLine{"ANumberMissing", Replaced("IJ 0 0 0", "IJ 0 0"), "IJ with 3 numbers"},
        BadLine{"ANumberTooMuch", Replaced("IJ 0 0 0", "IJ 0 0 0 0"), "IJ with 3 numbers"},
        BadLine{"NotANumber", Replaced("IJ 0 0 0", "IJ 0 nan 0"), "IJ with 3 numbers"},
        BadLine{"NoEnd", Replaced("; adult_proportions 1", ""), "adult_proportions with 1 number"},
        BadLine{"TooLong", std::string(1'000'000, 'x'), "IJ with 3 numbers"}),
    [](const testing::TestParamInfo<BadLine>& bad) { return bad.param.what; });

}  // namespace
}  // namespace girdle::anatomy_line_test
