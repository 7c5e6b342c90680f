// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "anatomy/body_size.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <limits>
#include <ostream>
#include <stdexcept>
#include <string>

#include "anatomy/built_in_anatomy.h"
#include "kinematics/random_rotations.h"
#include "text/csv_text.h"

namespace girdle::body_size_test {
namespace {

// A few roundings, as a share of the number.
constexpr double kRounding = 1e-14;

const Anatomy& Adult() {
  static const Anatomy kAnatomy = BuiltInAnatomy();
  return kAnatomy;
}

double ClavicleLength_m(const Anatomy& anatomy) {
  return glm::length(anatomy.landmark_m(Landmark::kPAC));
}
double ScapulaLength_m(const Anatomy& anatomy) {
  return glm::length(anatomy.landmark_m(Landmark::kTS));
}
double HumerusLength_m(const Anatomy& anatomy) { return glm::length(anatomy.elbow_m()); }

// Largest difference of two vectors as a share of the first.
double RelativeDifference(const Vector3& a, const Vector3& b) {
  return glm::length(a - b) / (glm::length(a) + std::numeric_limits<double>::min());
}

// Expects `segment` to have grown `scale` times in all directions at the same density.
void ExpectGrown(const Anatomy& anatomy, Segment segment, double scale) {
  const auto& name = Name(segment);
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    if (kLandmarks.at(i).segment == segment) {
      EXPECT_LT(RelativeDifference(anatomy.landmarks_m.at(i), scale * Adult().landmarks_m.at(i)),
                kRounding)
          << kLandmarks.at(i).name;
    }
  }
  const SegmentInertia& grown = anatomy.segment(segment);
  const SegmentInertia& adult = Adult().segment(segment);
  EXPECT_NEAR(grown.mass_kg / (std::pow(scale, 3) * adult.mass_kg), 1, kRounding) << name;
  EXPECT_LT(RelativeDifference(grown.center_of_mass_m, scale * adult.center_of_mass_m), kRounding)
      << name;
  EXPECT_LT(RelativeDifference(grown.inertia_kg_m2, std::pow(scale, 5) * adult.inertia_kg_m2),
            kRounding)
      << name;
}

void ExpectGrown(const Ellipsoid& ellipsoid, const Ellipsoid& adult, double scale) {
  EXPECT_LT(RelativeDifference(ellipsoid.center_m, scale * adult.center_m), kRounding);
  EXPECT_LT(RelativeDifference(ellipsoid.radii_m, scale * adult.radii_m), kRounding);
}

TEST(ScaledAnatomy, OfNoMeasureIsTheSameBitByBit) {
  const Anatomy same = ScaledAnatomy(Adult(), {});
  EXPECT_EQ(same.landmarks_m, Adult().landmarks_m);
  for (std::size_t i = 0; i < kSegmentCount; ++i) {
    EXPECT_EQ(same.segments.at(i).mass_kg, Adult().segments.at(i).mass_kg);
    EXPECT_EQ(same.segments.at(i).center_of_mass_m, Adult().segments.at(i).center_of_mass_m);
    EXPECT_EQ(same.segments.at(i).inertia_kg_m2, Adult().segments.at(i).inertia_kg_m2);
  }
  EXPECT_EQ(same.gliding.center_m, Adult().gliding.center_m);
  EXPECT_EQ(same.gliding.radii_m, Adult().gliding.radii_m);
  EXPECT_EQ(same.ribcage.radii_m, Adult().ribcage.radii_m);
  EXPECT_EQ(same.jugular_notch_height_m, Adult().jugular_notch_height_m);
  EXPECT_TRUE(same.has_adult_proportions);
}

TEST(ScaledAnatomy, GrowsAsAWholeWithStature) {
  constexpr double kScale = 1.1;
  const Anatomy tall = ScaledAnatomy(Adult(), {.stature_m = kScale * kAdultStature_m});
  for (const Segment segment :
       {Segment::kThorax, Segment::kClavicle, Segment::kScapula, Segment::kHumerus}) {
    ExpectGrown(tall, segment, kScale);
  }
  ExpectGrown(tall.ribcage, Adult().ribcage, kScale);
  ExpectGrown(tall.gliding, Adult().gliding, kScale);
  EXPECT_TRUE(tall.has_adult_proportions);
}

TEST(ScaledAnatomy, StandsWithItsNotchAtAShareOfStature) {
  // Drillis and Contini 1966, to their rounding.
  EXPECT_NEAR(ScaledAnatomy(Adult(), {.stature_m = 2}).jugular_notch_height_m, 2 * 0.82, kRounding);
}

// A length scales its own bone; the others stay.
TEST(ScaledAnatomy, GivesTheClavicleItsLength) {
  const Anatomy anatomy = ScaledAnatomy(Adult(), {.clavicle_length_m = 0.14});
  EXPECT_NEAR(ClavicleLength_m(anatomy), 0.14, kRounding);
  ExpectGrown(anatomy, Segment::kClavicle, 0.14 / ClavicleLength_m(Adult()));
  for (const Segment segment : {Segment::kThorax, Segment::kScapula, Segment::kHumerus}) {
    ExpectGrown(anatomy, segment, 1);
  }
}

TEST(ScaledAnatomy, GivesTheScapulaItsLength) {
  const Anatomy anatomy = ScaledAnatomy(Adult(), {.scapula_length_m = 0.14});
  EXPECT_NEAR(ScapulaLength_m(anatomy), 0.14, kRounding);
  ExpectGrown(anatomy, Segment::kScapula, 0.14 / ScapulaLength_m(Adult()));
  for (const Segment segment : {Segment::kThorax, Segment::kClavicle, Segment::kHumerus}) {
    ExpectGrown(anatomy, segment, 1);
  }
}

TEST(ScaledAnatomy, GivesTheHumerusItsLength) {
  const Anatomy anatomy = ScaledAnatomy(Adult(), {.humerus_length_m = 0.33});
  EXPECT_NEAR(HumerusLength_m(anatomy), 0.33, kRounding);
  ExpectGrown(anatomy, Segment::kHumerus, 0.33 / HumerusLength_m(Adult()));
  for (const Segment segment : {Segment::kThorax, Segment::kClavicle, Segment::kScapula}) {
    ExpectGrown(anatomy, segment, 1);
  }
}

TEST(ScaledAnatomy, LetsALengthWinOverStature) {
  constexpr double kScale = 1.1;
  const Anatomy anatomy =
      ScaledAnatomy(Adult(), {.clavicle_length_m = 0.14, .stature_m = kScale * kAdultStature_m});
  EXPECT_NEAR(ClavicleLength_m(anatomy), 0.14, kRounding);
  ExpectGrown(anatomy, Segment::kScapula, kScale);
  ExpectGrown(anatomy, Segment::kThorax, kScale);
  ExpectGrown(anatomy.gliding, Adult().gliding, kScale);
}

// TS and AI are carried by clavicle and scapula; what was fitted to them is fitted no more.
TEST(ScaledAnatomy, DoesNotClaimAFitForBonesOfOtherProportions) {
  EXPECT_FALSE(ScaledAnatomy(Adult(), {.clavicle_length_m = 0.14}).has_adult_proportions);
  EXPECT_FALSE(ScaledAnatomy(Adult(), {.scapula_length_m = 0.14}).has_adult_proportions);
  EXPECT_TRUE(ScaledAnatomy(Adult(), {.humerus_length_m = 0.33}).has_adult_proportions);
}

TEST(ScaledAnatomy, KeepsTheJointRanges) {
  const Anatomy tall = ScaledAnatomy(Adult(), {.stature_m = 2});
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    EXPECT_EQ(tall.ranges.at(k).lower_rad, Adult().ranges.at(k).lower_rad);
    EXPECT_EQ(tall.ranges.at(k).upper_rad, Adult().ranges.at(k).upper_rad);
  }
}

// Dempster's share of the upper arm, in Winter's book; the others by the built-in anatomy.
TEST(ScaledAnatomy, SharesOutTheBodyMass) {
  constexpr double kBodyMass_kg = 90;
  constexpr double kUpperArm = 0.028;
  const Anatomy anatomy = ScaledAnatomy(Adult(), {.body_mass_kg = kBodyMass_kg});
  EXPECT_NEAR(anatomy.segment(Segment::kHumerus).mass_kg, kUpperArm * kBodyMass_kg, kRounding);
  for (std::size_t i = 0; i < kSegmentCount; ++i) {
    const double times = kUpperArm * kBodyMass_kg / Adult().segment(Segment::kHumerus).mass_kg;
    EXPECT_NEAR(anatomy.segments.at(i).mass_kg / (times * Adult().segments.at(i).mass_kg), 1,
                kRounding);
    EXPECT_LT(RelativeDifference(anatomy.segments.at(i).inertia_kg_m2,
                                 times * Adult().segments.at(i).inertia_kg_m2),
              kRounding);
    EXPECT_EQ(anatomy.segments.at(i).center_of_mass_m, Adult().segments.at(i).center_of_mass_m);
  }
}

// I = m L^2, whatever makes the mass.
TEST(ScaledAnatomy, HasMomentsOfInertiaOfMassTimesLengthSquared) {
  const Anatomy anatomy =
      ScaledAnatomy(Adult(), {.humerus_length_m = 0.33, .body_mass_kg = 55, .stature_m = 1.6});
  const double scales[] = {1.6 / kAdultStature_m, 1.6 / kAdultStature_m, 1.6 / kAdultStature_m,
                           0.33 / HumerusLength_m(Adult())};
  for (std::size_t i = 0; i < kSegmentCount; ++i) {
    const double mass_scale = anatomy.segments.at(i).mass_kg / Adult().segments.at(i).mass_kg;
    EXPECT_LT(RelativeDifference(
                  anatomy.segments.at(i).inertia_kg_m2,
                  mass_scale * scales[i] * scales[i] * Adult().segments.at(i).inertia_kg_m2),
              kRounding)
        << kSegmentNames.at(i);
  }
}

RC_GTEST_PROP(ScaledAnatomy, HasTheMeasuresItWasMadeFor, ()) {
  const BodySize size = {*NumberWithin(0.1, 0.2), *NumberWithin(0.1, 0.2), *NumberWithin(0.2, 0.4),
                         *NumberWithin(20, 200), *NumberWithin(1, 2.2)};
  const Anatomy anatomy = ScaledAnatomy(Adult(), size);
  RC_ASSERT(std::abs(ClavicleLength_m(anatomy) - *size.clavicle_length_m) < kRounding);
  RC_ASSERT(std::abs(ScapulaLength_m(anatomy) - *size.scapula_length_m) < kRounding);
  RC_ASSERT(std::abs(HumerusLength_m(anatomy) - *size.humerus_length_m) < kRounding);
  const SegmentScales scales = ScalesOf(anatomy, Adult());
  RC_ASSERT(std::abs(scales[0] - *size.stature_m / kAdultStature_m) < kRounding);
}

TEST(ScalesOf, AreOneForTheAdult) {
  for (const double scale : ScalesOf(Adult(), Adult())) EXPECT_EQ(scale, 1);
}

struct BadSize {
  const char* name;
  BodySize size;
  const char* message;
};

void PrintTo(const BadSize& bad, std::ostream* out) { *out << bad.name; }

class BadBodySize : public testing::TestWithParam<BadSize> {};

TEST_P(BadBodySize, IsRefusedWithTheFix) {
  EXPECT_EQ(MessageOf<std::invalid_argument>(
                [] { static_cast<void>(ScaledAnatomy(Adult(), GetParam().size)); }),
            GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    OneEach, BadBodySize,
    testing::Values(
        BadSize{"centimeters",
                {.stature_m = 175},
                "stature 175: not within 0.5 to 2.8 m. Give meters, not centimeters: 1.75"},
        BadSize{"millimeters",
                {.clavicle_length_m = 157.5},
                "clavicle-length 157.5: not within 0.05 to 0.25 m. Give meters, not millimeters: "
                "0.1575"},
        BadSize{"length of zero",
                {.humerus_length_m = 0},
                "humerus-length 0: not within 0.1 to 0.5 m. Give one such as 0.287 m"},
        BadSize{"negative length",
                {.scapula_length_m = -0.13},
                "scapula-length -0.13: not within 0.04 to 0.25 m. Give one such as 0.129 m"},
        BadSize{"no mass",
                {.body_mass_kg = 0},
                "body-mass 0: not within 5 to 650 kg. Give one such as 71 kg"},
        BadSize{"negative mass",
                {.body_mass_kg = -70},
                "body-mass -70: not within 5 to 650 kg. Give one such as 71 kg"},
        BadSize{"grams",
                {.body_mass_kg = 70000},
                "body-mass 70000: not within 5 to 650 kg. Give kilograms, not grams: 70"},
        BadSize{"giant",
                {.stature_m = 4},
                "stature 4: not within 0.5 to 2.8 m. Give one such as 1.71 m"},
        BadSize{"not a number",
                {.stature_m = std::numeric_limits<double>::quiet_NaN()},
                "stature nan: not within 0.5 to 2.8 m. Give one such as 1.71 m"}));

}  // namespace
}  // namespace girdle::body_size_test
