// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Bone frames from bony landmarks, by the definitions of the ISB (Wu et al., J Biomech
/// 2005;38:981-992).
///
/// Landmarks are given in any one frame A, in any unit of length; the result is the bone's frame in
/// A. x points forward, y up, z to the right of a right shoulder. If landmarks lie on a line the
/// result is not finite.
#pragma once

#include "kinematics/rotation.h"

namespace girdle {

/// Thorax: y from the middle of PX and T8 to that of IJ and C7, z perpendicular to the plane
/// through IJ, C7 and the middle of PX and T8, to the right (ISB 2.3.1). Its origin is IJ.
[[nodiscard]] Quaternion ThoraxFrame(const Vector3& ij, const Vector3& px, const Vector3& c7,
                                     const Vector3& t8) noexcept;

/// Scapula: z from TS to PAC, x perpendicular to the plane AI-PAC-TS, forward (ISB 2.3.3 with PAC
/// for AA).
[[nodiscard]] Quaternion ScapulaFrame(const Vector3& pac, const Vector3& ts,
                                      const Vector3& ai) noexcept;

/// Humerus: y from the epicondyles' midpoint to GH, x perpendicular to the plane GH-EM-EL, forward
/// (ISB 2.3.4).
[[nodiscard]] Quaternion HumerusFrame(const Vector3& gh, const Vector3& em,
                                      const Vector3& el) noexcept;

/// Clavicle's long axis, unit vector from SC to PAC: its z. Its turn about this axis cannot be told
/// from landmarks.
[[nodiscard]] Vector3 ClavicleAxis(const Vector3& sc, const Vector3& pac) noexcept;

}  // namespace girdle
