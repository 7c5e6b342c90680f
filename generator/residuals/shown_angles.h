// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Quantities that several groups compute from a state, and the tolerance of exact values.
#pragma once

#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "anatomy/bone_frames.h"
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

/// q_WB of scapula or humerus, rebuilt from landmarks of that bone only (BoneRotation).
[[nodiscard]] inline Quaternion FromLandmarks(const ShoulderState& state, Segment segment) {
  LandmarkPositions p_W_m{};
  for (const Landmark landmark : {Landmark::kTS, Landmark::kAI, Landmark::kEM, Landmark::kEL}) {
    p_W_m[static_cast<std::size_t>(landmark)] = state.landmark_m(landmark);
  }
  // At a joint, the point on the child bone is used.
  p_W_m[static_cast<std::size_t>(Landmark::kPAC)] = state.child_site_m(1);
  p_W_m[static_cast<std::size_t>(Landmark::kGH)] = state.child_site_m(2);
  return BoneRotation(segment, p_W_m);
}

}  // namespace girdle
