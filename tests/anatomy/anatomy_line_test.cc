// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "anatomy/anatomy_line.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

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

// The numbers of an anatomy: landmarks, segments, ranges of joints and of the scapula, ellipsoids,
// ligaments, the height of the notch, and whether the proportions are an adult's.
constexpr std::size_t kNumbers = 3 * kLandmarkCount + 7 * kSegmentCount + 2 * kCoordinateCount +
                                 2 * 3 + 2 * 6 + 11 * kLigamentCount + 1 + 1;

TEST(AnatomyLine, ReadsAndWritesEveryNumber) {
  std::istringstream words(AnatomyAsLine(BuiltInAnatomy()));
  std::vector<std::string> line;
  std::vector<std::size_t> numbers;
  for (std::string word; words >> word;) {
    if (word.find_first_not_of("-+.0123456789e;") == std::string::npos) {
      numbers.push_back(line.size());
    }
    line.push_back(word);
  }
  ASSERT_EQ(numbers.size(), kNumbers);
  const auto text = [&line] {
    std::string all;
    for (const std::string& word : line) {
      all += (all.empty() ? "" : " ") + word;
    }
    return all;
  };
  for (const std::size_t number : numbers) {
    const std::string before = line[number];
    const bool is_last_word = number + 1 == line.size();
    line[number] = is_last_word ? "0" : "0.015625" + std::string(before.back() == ';' ? ";" : "");
    EXPECT_EQ(AnatomyAsLine(AnatomyFromLine(text(), "model.xml")), text()) << number;
    EXPECT_FALSE(IsSame(AnatomyFromLine(text(), "model.xml"), BuiltInAnatomy())) << number;
    line[number] = before;
  }
}

TEST(AnatomyLine, IsSameButForRounding) {
  Anatomy other = BuiltInAnatomy();
  EXPECT_TRUE(IsSame(other, BuiltInAnatomy()));
  other.gliding.radii_m.x += 5e-10;
  EXPECT_TRUE(IsSame(other, BuiltInAnatomy()));
  other.gliding.radii_m.x += 5e-9;
  EXPECT_FALSE(IsSame(other, BuiltInAnatomy()));
  other = BuiltInAnatomy();
  other.ligaments[0].stiffness_N_per_m *= 1 + 5e-10;
  EXPECT_TRUE(IsSame(other, BuiltInAnatomy()));
  other.ligaments[0].stiffness_N_per_m *= 1 + 5e-9;
  EXPECT_FALSE(IsSame(other, BuiltInAnatomy()));
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

std::string Changed(void (*change)(Anatomy& anatomy)) {
  Anatomy anatomy = BuiltInAnatomy();
  change(anatomy);
  return AnatomyAsLine(anatomy);
}

TEST_P(BadAnatomyLine, IsRefusedWithThePlaceAndWhatIsExpected) {
  try {
    static_cast<void>(AnatomyFromLine(GetParam().line, "arm.xml"));
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()), std::string("arm.xml: ") + GetParam().message +
                                             ". Generate the model again with girdle generate");
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, BadAnatomyLine,
    testing::Values(
        BadLine{"Empty", "", "expected IJ with 3 numbers"},
        BadLine{"AnotherName", Replaced("IJ 0 0 0", "XY 0 0 0"), "expected IJ with 3 numbers"},
        BadLine{"ANumberMissing", Replaced("IJ 0 0 0", "IJ 0 0"), "expected IJ with 3 numbers"},
        BadLine{"ANumberTooMuch", Replaced("IJ 0 0 0", "IJ 0 0 0 0"), "expected IJ with 3 numbers"},
        BadLine{"NotANumber", Replaced("IJ 0 0 0", "IJ 0 nan 0"), "expected IJ with 3 numbers"},
        BadLine{"NoEnd", Replaced("; adult_proportions 1", ""),
                "expected adult_proportions with 1 number"},
        BadLine{"TooLong", std::string(1'000'000, 'x'), "is longer than any anatomy"},
        BadLine{"Far", Replaced("IJ 0 0 0", "IJ 0 1e200 0"), "IJ cannot be"},
        BadLine{"NoMass", Changed([](Anatomy& a) { a.segments[1].mass_kg = 0; }),
                "clavicle cannot be"},
        BadLine{"NoRadius", Changed([](Anatomy& a) { a.gliding.radii_m.y = -1; }),
                "gliding cannot be"},
        BadLine{"NoStiffness", Changed([](Anatomy& a) { a.ligaments[0].stiffness_N_per_m = 0; }),
                "conoid cannot be"},
        BadLine{"FarCenter", Changed([](Anatomy& a) { a.segments[2].center_of_mass_m.x = 11; }),
                "scapula cannot be"},
        BadLine{"NoInertia", Changed([](Anatomy& a) { a.segments[2].inertia_kg_m2.z = 0; }),
                "scapula cannot be"},
        BadLine{"FarEllipsoid", Changed([](Anatomy& a) { a.ribcage.center_m.z = -11; }),
                "ribcage cannot be"},
        BadLine{"LargeEllipsoid", Changed([](Anatomy& a) { a.ribcage.radii_m.z = 11; }),
                "ribcage cannot be"},
        BadLine{"FarLigament", Changed([](Anatomy& a) { a.ligaments[1].scapula_m.y = 11; }),
                "trapezoid cannot be"},
        BadLine{"NoSlack", Changed([](Anatomy& a) { a.ligaments[1].slack_m = 0; }),
                "trapezoid cannot be"},
        BadLine{"LongSlack", Changed([](Anatomy& a) { a.ligaments[1].slack_m = 11; }),
                "trapezoid cannot be"},
        BadLine{"TooHigh", Changed([](Anatomy& a) { a.jugular_notch_height_m = 11; }),
                "jugular_notch_height cannot be"},
        BadLine{"NoHeight", Changed([](Anatomy& a) { a.jugular_notch_height_m = 0; }),
                "jugular_notch_height cannot be"}),
    [](const testing::TestParamInfo<BadLine>& bad) { return bad.param.what; });

}  // namespace
}  // namespace girdle::anatomy_line_test
