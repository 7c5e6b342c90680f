// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Turns of the humerus about its long axis, and the zeros that they are counted from.
///
/// The humerus in the thorax with the direction (theta, psi) is q_TH = S(theta, psi) Ry(T), S the
/// smallest rotation that takes the hanging arm there (humerus_rotation.h). T is its whole turn. An
/// axial rotation is counted from a zero T_0:
///
///     q_TH = S Ry(T_0) Ry(axial),   T = T_0 + axial
///
/// The zero of the rhythm is tau, its own turn. That of ISB's third angle is psi, because
/// Y(psi) X(-theta) Y(gamma) = S Ry(psi + gamma). That of the swing is SwingZero.
///
/// T is double or a Jet of jet.h, whose derivatives go through.
#pragma once

#include "kinematics/arm_directions.h"
#include "kinematics/bump.h"
#include "kinematics/humerus_rotation.h"
#include "kinematics/rotation_algebra.h"

namespace girdle {

/// Returns the turn about y [rad], in [-2 pi, 2 pi], of a rotation = (a rotation about an axis
/// across y) Ry(turn). The quaternion may have any length; one that turns y around has no such
/// turn.
template <typename T>
[[nodiscard]] T TurnAboutY(const QuaternionOf<T>& q) noexcept {
  return 2.0 * Atan2(q.y, q.w);
}

/// Returns the humerus's y, from the elbow up, in the thorax.
template <typename T>
[[nodiscard]] VectorOf<T> UpTheArm(const ArmDirectionOf<T>& direction) noexcept {
  const SineAndCosine<T> theta = SineAndCosineOf(direction.elevation_rad);
  const SineAndCosine<T> psi = SineAndCosineOf(direction.plane_rad);
  return {-(theta.sine * psi.sine), theta.cosine, -(theta.sine * psi.cosine)};
}

/// Returns how much the whole turn T grows [rad] when the smallest rotation M takes the arm from
/// one direction to another:
///
///     M S(from) Ry(T) = S(to) Ry(T + carried),   M ~ (1 + a.b, a x b), a and b the arm before and
///                                                after
///
/// Opposite directions have no smallest rotation; the result is then any number, and round a
/// direction that is answered by its opposite it grows by two turns. ShareOfCarried makes up for
/// it.
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

/// Returns the share of a carried turn that counts, in [0, 1]: all of it while the direction that
/// answers is at most 60 deg from the one that was asked for, and nothing where they are opposite.
/// The humerus then does not depend on which way the smallest rotation takes it:
///
///     share = Bump((cos 60 - a.b) / (cos 60 + 1))
template <typename T>
[[nodiscard]] T ShareOfCarried(const ArmDirectionOf<T>& from,
                               const ArmDirectionOf<T>& to) noexcept {
  constexpr double kWholeFrom = 0.5;  // cos 60
  return Bump(T((1 / (kWholeFrom + 1)) * (T(kWholeFrom) - Dot(UpTheArm(from), UpTheArm(to)))));
}

/// The middle of the reach, which swings start from.
inline constexpr ArmDirectionOf<double> kSwingStart = {kPi / 2, 20 * kRadiansPerDegree};

/// Returns the swing's zero [rad]: the humerus that has ISB's zero in the middle of the reach,
/// taken from there by the smallest rotation. It has one value for a direction, hanging and
/// straight up as well, and is continuous everywhere but in the opposite direction, (90, -160),
/// which no arm reaches.
template <typename T>
[[nodiscard]] T SwingZero(const ArmDirectionOf<T>& direction) noexcept {
  const ArmDirectionOf<T> start = {T(kSwingStart.elevation_rad), T(kSwingStart.plane_rad)};
  return T(kSwingStart.plane_rad) + CarriedTurn(start, direction);
}

}  // namespace girdle
