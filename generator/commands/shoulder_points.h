// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The points of a shoulder that `girdle solve --landmarks` prints: their names and where they are.
#pragma once

#include <string>
#include <vector>

#include "anatomy/anatomy.h"
#include "kinematics/shoulder_pose.h"

namespace girdle {

/// A point in the thorax frame: x anterior, y up, z to the right, origin IJ [mm].
struct ShoulderPoint {
  std::string name;  ///< in lower case, as in names of columns
  Vector3 p_mm;
};

/// Returns the elbow (middle of the epicondyles) and the landmarks on clavicle, scapula and humerus
/// in a pose. The order is that of the output: `elbow`, then SC and the others in the order of
/// kLandmarks. The names do not depend on pose and anatomy.
[[nodiscard]] std::vector<ShoulderPoint> ShoulderPoints(const Anatomy& anatomy,
                                                        const ShoulderPose& pose);

}  // namespace girdle
