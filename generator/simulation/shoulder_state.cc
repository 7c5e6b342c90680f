// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "simulation/shoulder_state.h"

namespace girdle {

ShoulderState MirroredToRight(const ShoulderState& left) noexcept {
  // The mirror takes y of the world to -y. A body's own frame is mirrored in z in addition
  // (rotation.h). Both mirrors are expressed as half turns about y and z: R_right = Ry(pi) R_left
  // Rz(pi).
  const Quaternion about_y{0, 0, 1, 0};
  const Quaternion about_z{0, 0, 0, 1};
  ShoulderState right = left;
  for (Quaternion& q_WB : right.q_WB) {
    q_WB = about_y * q_WB * about_z;
  }
  for (Vector3& p_m : right.site_m) {
    p_m.y = -p_m.y;
  }
  return right;
}

}  // namespace girdle
