// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "motions/axial_names.h"

#include <gtest/gtest.h>

namespace girdle::axial_names_test {
namespace {

TEST(MeansAxialTurn, IsTrueOfWhatPeopleCallIt) {
  for (const char* const name : {"axial_rotation_deg",
                                 "axial_isb_deg",
                                 "axial_rot_deg",
                                 "internal_rotation_deg",
                                 "external_rotation_deg",
                                 "humeral_rotation_deg",
                                 "humeral_axial_rotation",
                                 "Axial Rotation (deg)",
                                 "axialRotation",
                                 "internal/external rotation",
                                 "rotation_deg",
                                 "shoulder_rot",
                                 "axial_rotation_r",
                                 "right_humerus_axial_angle_rad",
                                 "IR_deg",
                                 "lateral rotation [degrees]",
                                 "HT_axial_rotation_degree",
                                 "long-axis rotation",
                                 "isb_third_angle",
                                 "axial_rotaton_deg",
                                 "axail_isb_deg",
                                 "humerothoracic_rotation",
                                 "internal_rottation_deg"}) {
    EXPECT_TRUE(MeansAxialTurn(name)) << name;
  }
}

TEST(MeansAxialTurn, IsFalseOfOthersAndOfWhatTheProgramWrites) {
  for (const char* const name : {"used_axial_deg",
                                 "used_axial_isb_deg",
                                 "gh_axial_deg",
                                 "target_gh_axial_deg",
                                 "ac_internal_rotation_deg",
                                 "st_upward_rotation_deg",
                                 "sc_rotation_deg",
                                 "trunk_rotation_deg",
                                 "scapula_internal_rotation",
                                 "axial_force_n",
                                 "axial_rate",
                                 "frame",
                                 "internal_deg",
                                 "shoulder_angle",
                                 "rotation_x",
                                 "deg",
                                 "",
                                 "upward_rotation_deg",
                                 "forward_rotation",
                                 "lower_arm_rotation_deg",
                                 "axes",
                                 "rational",
                                 "ankle_rotation_deg",
                                 "thoracic_rotation",
                                 "rotations_per_s"}) {
    EXPECT_FALSE(MeansAxialTurn(name)) << name;
  }
}

}  // namespace
}  // namespace girdle::axial_names_test
