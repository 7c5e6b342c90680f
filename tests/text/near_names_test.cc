// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "text/near_names.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace girdle::near_names_test
