// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// What several groups read from a state, and the tolerance of what is exact.
#pragma once

#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "kinematics/isb_frames.h"
#include "simulation/shoulder_simulation.h"

namespace girdle {

/// Rounding in double precision leaves 1e-13 of a radian or a meter at most. A millionth of a
/// degree or a millimeter is far above that and far below anything that can be measured.
inline constexpr double kExact_deg = 1e-6;
inline constexpr double kExact_mm = 1e-6;

/// Difference of two angles in [-pi, pi].
[[nodiscard]] inline double AngleDifference_rad(double a_rad, double b_rad) noexcept {
  return std::remainder(a_rad - b_rad, 2 * kPi);
}

/// A point of the world in the thorax frame [m].
[[nodiscard]] inline Vector3 InThorax_m(const ShoulderState& state, const Vector3& point_W_m) {
  return glm::conjugate(state.rotation(Segment::kThorax)) *
         (point_W_m - state.landmark_m(Landmark::kIJ));
}

/// q_WH rebuilt from landmarks: GH and the epicondyles.
[[nodiscard]] inline Quaternion HumerusFromLandmarks(const ShoulderState& state) {
  return HumerusFrame(state.child_site_m(2), state.landmark_m(Landmark::kEM),
                      state.landmark_m(Landmark::kEL));
}

}  // namespace girdle
