// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Interpolation of unit quaternions as Kim et al. use it: slerp and squad.
///
/// Quaternions are taken with the sign they have: the curve from `a` to `b` takes the long way
/// round when a . b < 0. Align signs first (AlignedWith). Parameters t are in [0, 1].
#pragma once

#include <array>

#include "kinematics/rotation.h"

namespace girdle {

/// Returns the point at t on the great arc from a to b, equation (1). At t = 0 and t = 1 it is a
/// and b exactly. Opposite quaternions (a = -b) have no unique arc; the result is then a finite
/// unit quaternion.
[[nodiscard]] Quaternion Slerp(const Quaternion& a, const Quaternion& b, double t) noexcept;

/// Returns the inner control point s_i of knot q_i between its neighbours, equation (5).
[[nodiscard]] Quaternion SquadControl(const Quaternion& q_previous, const Quaternion& q_i,
                                      const Quaternion& q_next) noexcept;

/// Returns the point at t on the spherical quadrangle curve from q_i to q_next, equation (4), with
/// the inner control points s_i and s_next.
[[nodiscard]] Quaternion Squad(const Quaternion& q_i, const Quaternion& q_next,
                               const Quaternion& s_i, const Quaternion& s_next, double t) noexcept;

/// Three rotations that are interpolated with the same t: the joints of a shoulder.
using JointRotations = std::array<Quaternion, 3>;

/// As above for each of three; evaluated together, which takes little longer than one.
[[nodiscard]] JointRotations Slerp(const JointRotations& a, const JointRotations& b,
                                   double t) noexcept;
[[nodiscard]] JointRotations SquadControl(const JointRotations& q_previous,
                                          const JointRotations& q_i,
                                          const JointRotations& q_next) noexcept;
[[nodiscard]] JointRotations Squad(const JointRotations& q_i, const JointRotations& q_next,
                                   const JointRotations& s_i, const JointRotations& s_next,
                                   double t) noexcept;

}  // namespace girdle
