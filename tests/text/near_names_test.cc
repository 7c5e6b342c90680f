// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "text/near_names.h"

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace girdle::near_names_test {
namespace {

TEST(IsNearly, IsTrueOfTheSameStemWithAnotherUnitOrNone) {
  for (const char* const name :
       {"axial", "Axial", "AXIAL_DEG", "axial_rad", "axial (deg)", "axialDegrees", "axial_degree",
        "axial_radian", "axials", "axial_"}) {
    EXPECT_TRUE(IsNearly(name, "axial_deg")) << name;
  }
  EXPECT_TRUE(IsNearly("time", "time_s"));
}

TEST(IsNearly, IsTrueOfOneSlip) {
  for (const char* const name : {"plan_deg", "planne_deg", "plank_deg", "palne_deg", "plane_dge",
                                 "lane_deg", "plane_degs", "plane_de"}) {
    EXPECT_TRUE(IsNearly(name, "plane_deg")) << name;
  }
}

TEST(IsNearly, IsFalseOfTheNameItselfAndOfOthers) {
  for (const char* const name : {"plane_deg", "frame", "place", "elevation_deg", "used_plane_deg",
                                 "lan_deg", "", "deg", "plna_ed"}) {
    EXPECT_FALSE(IsNearly(name, "plane_deg")) << name;
  }
  EXPECT_FALSE(IsNearly("frame", "time_s"));
  EXPECT_FALSE(IsNearly("y_m", "x_m"));
  EXPECT_FALSE(IsNearly("gh_elevation_deg", "elevation_deg"));
}

constexpr std::array<std::string_view, 5> kVerbs = {"solve", "simulate", "smoothness",
                                                    "smooth-table", "fit-thorax"};

TEST(NearestWord, IsTheWordThatIsASlipAway) {
  for (const auto& [typed, meant] :
       {std::pair("slove", "solve"), std::pair("solv", "solve"), std::pair("Simulate", "simulate"),
        std::pair("simulat", "simulate"), std::pair("smoothnes", "smoothness"),
        std::pair("smooth_table", "smooth-table"), std::pair("fit", "fit-thorax"),
        std::pair("fitthroax", "fit-thorax"), std::pair("simualte", "simulate")}) {
    EXPECT_EQ(NearestWord(typed, kVerbs), meant) << typed;
  }
}

TEST(NearestWord, IsNothingIfNoWordOrTwoAreNear) {
  for (const char* const typed : {"", "s", "thorax", "solution", "smooth", "verify"}) {
    EXPECT_EQ(NearestWord(typed, kVerbs), std::nullopt) << typed;
  }
  EXPECT_EQ(NearestWord(std::string(1'000'000, 's'), kVerbs), std::nullopt);
}

TEST(DidYouMean, IsASentenceOrNothing) {
  EXPECT_EQ(DidYouMean("slove", kVerbs), "Did you mean 'solve'? ");
  EXPECT_EQ(DidYouMean("verify", kVerbs), "");
}

}  // namespace
}  // namespace girdle::near_names_test
