// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "anatomy/built_in_anatomy.h"
#include "mjcf/parsed_xml.h"
#include "mjcf/shoulder_model.h"
#include "rhythm_tables/built_in_tables.h"

namespace girdle::skin_element_test {
namespace {

// Of one side: other vertices for every landmark, three for the acromion.
using VerticesOfOneSide = std::array<std::vector<int>, kSkinLandmarkCount>;
const VerticesOfOneSide kRightSkin = {{{11}, {12, 13, 14}, {15}, {16}, {17}}};
const VerticesOfOneSide kLeftSkin = {{{21}, {22, 23, 24}, {25}, {26}, {27}}};

ShoulderModelOptions WithSkin(Sides sides, std::vector<VerticesOfOneSide> landmarks) {
  ShoulderModelOptions options;
  options.sides = sides;
  options.skin = SkinElement{"some.skn", std::move(landmarks)};
  return options;
}

ParsedXml SkinnedModel(const ShoulderModelOptions& options) {
  return ParsedXml(ShoulderModelXml(BuiltInAnatomy(), BuiltInRhythm(), options));
}

TEST(SkinElement, NamesTheFile) {
  const ParsedXml model = SkinnedModel(WithSkin(Sides::kRight, {kRightSkin}));
  ASSERT_EQ(model.All("skin").size(), 1U);
  const tinyxml2::XMLElement& skin = model.Named("skin", "skin");
  EXPECT_EQ(ParsedXml::All(model.Child("deformable"), "skin"), model.All("skin"));
  EXPECT_EQ(TextOf(skin, "file"), "some.skn");
  EXPECT_EQ(NumbersOf(skin, "rgba").at(3), 1) << "nothing shines through";
}

TEST(SkinElement, HasTheLandmarksOfEachSideByName) {
  const ParsedXml model = SkinnedModel(WithSkin(Sides::kBoth, {kRightSkin, kLeftSkin}));
  EXPECT_EQ(model.All("numeric").size(), 10U);
  using Numbers = std::vector<double>;
  EXPECT_EQ(NumbersOf(model.Named("numeric", "skin_ac_r"), "data"), Numbers{11});
  EXPECT_EQ(NumbersOf(model.Named("numeric", "skin_acromion_r"), "data"), (Numbers{12, 13, 14}));
  EXPECT_EQ(NumbersOf(model.Named("numeric", "skin_mid_clavicle_r"), "data"), Numbers{15});
  EXPECT_EQ(NumbersOf(model.Named("numeric", "skin_scapular_spine_r"), "data"), Numbers{16});
  EXPECT_EQ(NumbersOf(model.Named("numeric", "skin_deltoid_r"), "data"), Numbers{17});
  EXPECT_EQ(NumbersOf(model.Named("numeric", "skin_ac_l"), "data"), Numbers{21});
  EXPECT_EQ(NumbersOf(model.Named("numeric", "skin_acromion_l"), "data"), (Numbers{22, 23, 24}));
  EXPECT_EQ(NumbersOf(model.Named("numeric", "skin_deltoid_l"), "data"), Numbers{27});
}

TEST(SkinElement, OfTheLeftAloneHasTheLeftsNames) {
  const ParsedXml model = SkinnedModel(WithSkin(Sides::kLeft, {kLeftSkin}));
  EXPECT_EQ(model.All("numeric").size(), kSkinLandmarkCount);
  EXPECT_EQ(NumberOf(model.Named("numeric", "skin_ac_l"), "data"), 21);
}

TEST(SkinElement, IsNotThereUnlessAskedFor) {
  const ParsedXml model = SkinnedModel({});
  EXPECT_TRUE(model.All("skin").empty());
  EXPECT_TRUE(model.All("numeric").empty());
  EXPECT_TRUE(model.All("deformable").empty());
}

TEST(SkinElement, ChangesNothingElse) {
  ShoulderModelOptions options = WithSkin(Sides::kRight, {kRightSkin});
  const std::size_t with_skin = SkinnedModel(options).All("").size();
  options.skin.reset();
  // <deformable>, <skin>, <custom> and a <numeric> for every landmark.
  EXPECT_EQ(with_skin, SkinnedModel(options).All("").size() + 3 + kSkinLandmarkCount);
}

TEST(SkinElement, NeedsLandmarksOfEverySide) {
  for (const auto& landmarks :
       {std::vector<VerticesOfOneSide>{}, std::vector<VerticesOfOneSide>{kRightSkin},
        std::vector<VerticesOfOneSide>(3, kRightSkin)}) {
    try {
      static_cast<void>(SkinnedModel(WithSkin(Sides::kBoth, landmarks)));
      ADD_FAILURE() << landmarks.size() << " were taken";
    } catch (const std::invalid_argument& error) {
      EXPECT_STREQ(error.what(), "a skin needs landmarks of every side of the model");
    }
  }
}

}  // namespace
}  // namespace girdle::skin_element_test
