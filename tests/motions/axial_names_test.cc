// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "motions/axial_names.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace girdle::axial_names_test {
namespace {

// Names, a line each.
void ExpectAll(const std::string& names, bool means_axial_turn) {
  std::istringstream lines(names);
  int count = 0;
  for (std::string name; std::getline(lines, name); ++count) {
    EXPECT_EQ(MeansAxialTurn(name), means_axial_turn) << name;
  }
  EXPECT_GT(count, 5);
}

TEST(MeansAxialTurn, IsTrueOfWhatPeopleCallIt) {
  ExpectAll(R"(axial_rotation_deg
axial_isb_deg
axial_rot_deg
internal_rotation_deg
external_rotation_deg
humeral_rotation_deg
humeral_axial_rotation
humerothoracic_rotation
Axial Rotation (deg)
axialRotation
internal/external rotation
rotation_deg
shoulder_rot
axial_rotation_r
right_humerus_axial_angle_rad
IR_deg
lateral rotation [degrees]
HT_axial_rotation_degree
long-axis rotation
isb_third_angle)",
            true);
}

TEST(MeansAxialTurn, SeesASlip) {
  ExpectAll(R"(axial_rotaton_deg
axail_isb_deg
axia_rotation
axial_rotatio_deg
internal_rottation_deg
exernal_rotation_deg
humerel_rotation)",
            true);
}

TEST(MeansAxialTurn, IsFalseOfOthersAndOfWhatTheProgramWrites) {
  ExpectAll(R"(used_axial_deg
used_axial_isb_deg
gh_axial_deg
target_gh_axial_deg
ac_internal_rotation_deg
st_upward_rotation_deg
sc_rotation_deg
upward_rotation_deg
forward_rotation
trunk_rotation_deg
thoracic_rotation
ankle_rotation_deg
hip_rotation
lower_arm_rotation_deg
radial_rotation
radial_deg
notation
rational
err
scapula_internal_rotation
axial_force_n
axial_rate
rotations_per_s
rotation_x
axes
frame
internal_deg
shoulder_angle
deg

)",
            false);
}

TEST(MeansAxialTurn, IsFalseOfLongTexts) {
  std::string name = "axial";
  EXPECT_TRUE(MeansAxialTurn(name));
  while (name.size() <= 128) name += "axial";
  EXPECT_FALSE(MeansAxialTurn(name));
}

}  // namespace
}  // namespace girdle::axial_names_test
