// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Turns of the humerus about its long axis, and their zeros.
///
/// The humerus in the thorax with the direction (theta, psi) is q_TH = S(theta, psi) Ry(T). S is
/// the smallest rotation that takes the hanging arm to the direction (humerus_rotation.h). T is the
/// whole turn of the humerus. An axial rotation is counted from a zero T_0:
///
///     q_TH = S Ry(T_0) Ry(axial),   T = T_0 + axial
///
/// There are three zeros. The rhythm's is tau, the rhythm's own turn. ISB's third angle has the
/// zero psi, because Y(psi) X(-theta) Y(gamma) = S Ry(psi + gamma). The swing's is SwingZero.
///
/// T, as a type, is double or a Jet of jet.h; a Jet's derivatives are kept.
#pragma once

#include "kinematics/arm_directions.h"
#include "kinematics/bump.h"
#include "kinematics/humerus_rotation.h"
#include "kinematics/rotation_algebra.h"

namespace girdle {

/// Returns the turn about y [rad], in [-2 pi, 2 pi], of a rotation that is (a rotation about an
/// axis perpendicular to y) Ry(turn). The quaternion may have any length. If the rotation reverses
/// y, no such turn exists.
template <typename T>
[[nodiscard]] T TurnAboutY(const QuaternionOf<T>& q) noexcept {
  return 2.0 * Atan2(q.y, q.w);
}

/// Returns the y axis of the humerus, from the elbow up, in the thorax.
template <typename T>
[[nodiscard]] VectorOf<T> UpTheArm(const ArmDirectionOf<T>& direction) noexcept {
  const SineAndCosine<T> theta = SineAndCosineOf(direction.elevation_rad);
  const SineAndCosine<T> psi = SineAndCosineOf(direction.plane_rad);
  return {-(theta.sine * psi.sine), theta.cosine, -(theta.sine * psi.cosine)};
}

/// Returns the growth of the whole turn T [rad] when the smallest rotation M takes the arm from one
/// direction to another. With a and b the arm before and after:
///
///     M S(from) Ry(T) = S(to) Ry(T + carried),   M ~ (1 + a.b, a x b)
///
/// Opposite directions have no smallest rotation, so the result is then arbitrary. On a small
/// circle round the direction opposite to `to` it grows by two turns. ShareOfCarried removes that
/// effect.
template <typename T>
[[nodiscard]] T CarriedTurn(const ArmDirectionOf<T>& from, const ArmDirectionOf<T>& to) noexcept {
  const VectorOf<T> a = UpTheArm(from);
  const VectorOf<T> b = UpTheArm(to);
  const VectorOf<T> across = Cross(a, b);
  const QuaternionOf<T> smallest{T(1.0) + Dot(a, b), across[0], across[1], across[2]};
  const auto swing = [](const ArmDirectionOf<T>& direction) {
    return HumerusRotation(direction.elevation_rad, direction.plane_rad, T(0.0));
  };
  return TurnAboutY(Inverse(swing(to)) * smallest * swing(from));
}

/// Returns the share of a carried turn that counts, in [0, 1]. It is 1 if the two directions are at
/// most 60 deg apart, and 0 if they are opposite. The humerus therefore does not depend on the way
/// that the smallest rotation takes near the opposite direction:
///
///     share = Bump((cos 60 - a.b) / (cos 60 + 1))
template <typename T>
[[nodiscard]] T ShareOfCarried(const ArmDirectionOf<T>& from,
                               const ArmDirectionOf<T>& to) noexcept {
  constexpr double kWholeFrom = 0.5;  // cos 60
  return Bump(T((1 / (kWholeFrom + 1)) * (T(kWholeFrom) - Dot(UpTheArm(from), UpTheArm(to)))));
}

/// The middle of the reach, where swings start.
inline constexpr ArmDirectionOf<double> kSwingStart = {kPi / 2, 20 * kRadiansPerDegree};

/// Returns the swing's zero [rad]. It belongs to this humerus: start in the middle of the reach
/// with ISB's zero, then take the smallest rotation to the direction. Every direction has one such
/// zero, also hanging and straight up. It is continuous except at the opposite direction, (90,
/// -160), which no arm reaches.
template <typename T>
[[nodiscard]] T SwingZero(const ArmDirectionOf<T>& direction) noexcept {
  const ArmDirectionOf<T> start = {T(kSwingStart.elevation_rad), T(kSwingStart.plane_rad)};
  return T(kSwingStart.plane_rad) + CarriedTurn(start, direction);
}

}  // namespace girdle
