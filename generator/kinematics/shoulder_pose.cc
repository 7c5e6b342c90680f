// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/shoulder_pose.h"

#include <glm/gtc/quaternion.hpp>

#include "kinematics/euler_angles.h"

namespace girdle {

ShoulderPose PoseFromAngles(const JointAngles& angles_rad) noexcept {
  const auto rotation = [&angles_rad](std::size_t joint) {
    const std::size_t first = 3 * joint;
    return QuaternionFromEuler(kJointSequences[joint],
                               {angles_rad[first], angles_rad[first + 1], angles_rad[first + 2]});
  };
  return {rotation(0), rotation(1), rotation(2)};
}

// The angles of SC and AC (Y-X'-Z'') are computed side by side. GH (X-Z'-Y'') is alone; its half
// sum and half difference of euler_angles.h are computed side by side.
JointAngles AnglesFromPose(const ShoulderPose& pose) noexcept {
  const auto positive = [](const Quaternion& q) { return q.w < 0 ? -q : q; };
  const Quaternion sc = positive(pose.q_TC);
  const Quaternion ac = positive(pose.q_CS);
  const Quaternion gh = positive(pose.q_SH);
  const VectorOf<Pair> girdle_rad =
      EulerAngles(Pair(sc.w, ac.w), Pair(sc.y, ac.y), Pair(sc.x, ac.x), Pair(sc.z, ac.z));

  const Pair sine{gh.y + gh.x, gh.x - gh.y};
  const Pair cosine{gh.w - gh.z, gh.z + gh.w};
  const Pair half_rad = Atan2(sine, cosine);
  const Pair squared = sine * sine + cosine * cosine;
  const double flexion_rad =
      Atan2(Pair(0.5 * (squared[1] - squared[0])), Pair(Sqrt(squared[0] * squared[1])))[0];
  const double axial_rad = WithinHalfTurn(half_rad[0] - half_rad[1] - kGhAxialMiddle_rad);
  return {girdle_rad[0][0],
          girdle_rad[1][0],
          girdle_rad[2][0],
          girdle_rad[0][1],
          girdle_rad[1][1],
          girdle_rad[2][1],
          WithinHalfTurn(half_rad[0] + half_rad[1]),
          flexion_rad,
          axial_rad + kGhAxialMiddle_rad};
}

ShoulderPose FrozenGirdle(const ShoulderPose& pose, const ShoulderPose& at) noexcept {
  return {at.q_TC, at.q_CS, glm::conjugate(at.q_TS()) * pose.q_TH()};
}

// Computed as in EulerFromQuaternion, with the two half angles side by side.
ArmAngles ArmAnglesFromRotation(const Quaternion& q_TH_any_sign) noexcept {
  const Quaternion q_TH = q_TH_any_sign.w < 0 ? -q_TH_any_sign : q_TH_any_sign;
  const Pair sine{q_TH.y, q_TH.z};
  const Pair cosine{q_TH.w, -q_TH.x};
  const Pair half_rad = Atan2(sine, cosine);
  const Pair length = Sqrt(sine * sine + cosine * cosine);
  return {2 * Atan2(Pair(length[1]), Pair(length[0]))[0], WithinHalfTurn(half_rad[0] + half_rad[1]),
          WithinHalfTurn(half_rad[0] - half_rad[1])};
}

}  // namespace girdle
