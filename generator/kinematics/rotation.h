// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Rotations as unit quaternions and as intrinsic Euler angles.
///
/// Frames are in the names: `q_AB` is the rotation of frame B in frame A. So `v_A = q_AB * v_B`,
/// and adjacent letters match in a product: `q_AC = q_AB * q_BC`. All angles are radians. Functions
/// are total: they accept a unit quaternion of either sign, never fail and never allocate.
#pragma once

#include <cstddef>
#include <glm/ext/matrix_double3x3.hpp>
#include <glm/ext/quaternion_double.hpp>
#include <glm/ext/vector_double3.hpp>
#include <numbers>
#include <type_traits>

// GLM's switches change its types. Girdle's library was compiled with one set of switches.
#if defined(GLM_FORCE_QUAT_CTOR_XYZW) || defined(GLM_FORCE_QUAT_DATA_XYZW)
#error \
    "Girdle constructs quaternions from w, x, y, z, and the GLM switch GLM_FORCE_QUAT_CTOR_XYZW \
(or GLM_FORCE_QUAT_DATA_XYZW) changes that order in some versions of GLM. Remove the switch from \
the sources that include Girdle."
#endif

namespace girdle {

/// GLM's types without alignment. They are glm::dquat, glm::dvec3 and glm::dmat3, unless the
/// switches GLM_FORCE_DEFAULT_ALIGNED_GENTYPES and GLM_FORCE_INTRINSICS make those larger. An
/// explicit constructor converts one kind into the other.
using Quaternion = glm::qua<double, glm::packed_highp>;
using Vector3 = glm::vec<3, double, glm::packed_highp>;
using Matrix3 = glm::mat<3, 3, double, glm::packed_highp>;

static_assert(offsetof(Quaternion, x) == 0 && offsetof(Quaternion, w) == 3 * sizeof(double),
              "Girdle's library keeps quaternions in memory as x, y, z, w, and here GLM keeps them "
              "as w, x, y, z: all numbers would be wrong. Remove the GLM switch "
              "GLM_FORCE_QUAT_DATA_WXYZ from the sources that include Girdle, and read quaternions "
              "by component: q.w, q.x, q.y, q.z");
static_assert(
    std::is_same_v<glm::length_t, int>,
    "Girdle's library was compiled with GLM's sizes as int: with others its functions are "
    "not found. Remove the GLM switch GLM_FORCE_SIZE_T_LENGTH from the sources that "
    "include Girdle");
static_assert(sizeof(Quaternion) == 4 * sizeof(double) && sizeof(Vector3) == 3 * sizeof(double) &&
                  sizeof(Matrix3) == 9 * sizeof(double) && alignof(Quaternion) == alignof(double) &&
                  alignof(Vector3) == alignof(double) && alignof(Matrix3) == alignof(double),
              "Girdle's library keeps vectors, quaternions and matrices in memory as doubles side "
              "by side, and here GLM aligns them. Remove GLM's switches for alignment from the "
              "sources that include Girdle");

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kRadiansPerDegree = kPi / 180.0;
inline constexpr double kDegreesPerRadian = 180.0 / kPi;
inline constexpr double kHalfCircle_deg = 180;
inline constexpr double kFullCircle_deg = 360;

[[nodiscard]] constexpr double RadiansFromDegrees(double angle_deg) noexcept {
  return angle_deg * kRadiansPerDegree;
}
[[nodiscard]] constexpr double DegreesFromRadians(double angle_rad) noexcept {
  return angle_rad * kDegreesPerRadian;
}

/// Returns an angle [deg] as a person types it, without the rounding errors of the way to radians
/// and back.
[[nodiscard]] double TypedDegrees(double angle_rad) noexcept;

/// Returns the rotation by `angle_rad` about the y axis.
[[nodiscard]] Quaternion AboutY(double angle_rad) noexcept;

/// Order of three turns about the moving axes. The first letter turns first.
enum class EulerSequence {
  kYXZ,  ///< Y-X'-Z'': sternoclavicular, acromioclavicular, scapulothoracic
  kXZY,  ///< X-Z'-Y'': glenohumeral
  kYXY,  ///< Y-X'-Y'': humerothoracic (plane, minus elevation, axial)
};

/// Returns the unit quaternion of three intrinsic turns [rad], given in the order of `sequence`.
[[nodiscard]] Quaternion QuaternionFromEuler(EulerSequence sequence,
                                             const Vector3& angles_rad) noexcept;

/// Returns the three intrinsic angles [rad] of a unit quaternion. It is the inverse of
/// QuaternionFromEuler.
///
/// The first and third angle are in (-pi, pi]. The second is in [-pi/2, pi/2] for kYXZ and kXZY,
/// and in [-pi, 0] for kYXY, where raising an arm is a negative turn about x. At the ends of the
/// second range the first and the third axis coincide. Only the sum or the difference of their
/// angles is then determined, and the result is one pair of angles that gives the rotation.
[[nodiscard]] Vector3 EulerFromQuaternion(EulerSequence sequence, const Quaternion& q_AB) noexcept;

/// Returns the rates of intrinsic angles about three different axes (kYXZ, kXZY). `w_AB` is the
/// angular velocity of B in A, in A's axes. Rates and `w_AB` are derivatives by one variable. The
/// result is not finite at gimbal lock, where the second angle is pi/2 or -pi/2.
[[nodiscard]] Vector3 EulerRates(EulerSequence sequence, const Vector3& angles_rad,
                                 const Vector3& w_AB) noexcept;

/// Returns the mirror image in the plane z = 0 of a rotation of B in A. It is the rotation between
/// the mirror images of both frames: from a right shoulder's bones it makes those of a left
/// shoulder.
[[nodiscard]] inline Quaternion Mirrored(const Quaternion& q_AB) noexcept {
  return {q_AB.w, -q_AB.x, -q_AB.y, q_AB.z};
}
/// Returns the mirror image in the plane z = 0 of a position or of another vector that is not an
/// axis of rotation.
[[nodiscard]] inline Vector3 Mirrored(const Vector3& p_A) noexcept {
  return {p_A.x, p_A.y, -p_A.z};
}

/// Returns the rotation vector [rad] of a unit quaternion: axis times angle, angle in [0, pi].
[[nodiscard]] Vector3 Log(const Quaternion& q_AB) noexcept;

/// Returns the unit quaternion of a rotation vector [rad] of any length.
[[nodiscard]] Quaternion Exp(const Vector3& rotation_vector_rad) noexcept;

/// Returns the angle [rad] in [0, pi] between two rotations of the same frames, precise near 0.
[[nodiscard]] double AngleBetween(const Quaternion& a, const Quaternion& b) noexcept;

/// Returns `q_AB` or its negative: the one whose dot product with `reference` is not negative.
[[nodiscard]] Quaternion AlignedWith(const Quaternion& q_AB, const Quaternion& reference) noexcept;

}  // namespace girdle
