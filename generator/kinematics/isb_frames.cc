// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/isb_frames.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace girdle {

Quaternion ThoraxFrame(const Vector3& ij, const Vector3& px, const Vector3& c7,
                       const Vector3& t8) noexcept {
  const Vector3 y = glm::normalize((ij + c7) / 2.0 - (px + t8) / 2.0);
  const Vector3 z = glm::normalize(glm::cross(ij - c7, y));
  return glm::quat_cast(Matrix3(glm::cross(y, z), y, z));
}

Quaternion ScapulaFrame(const Vector3& pac, const Vector3& ts, const Vector3& ai) noexcept {
  const Vector3 z = glm::normalize(pac - ts);
  const Vector3 x = glm::normalize(glm::cross(pac - ai, z));
  return glm::quat_cast(Matrix3(x, glm::cross(z, x), z));
}

Quaternion HumerusFrame(const Vector3& gh, const Vector3& em, const Vector3& el) noexcept {
  const Vector3 y = glm::normalize(gh - (em + el) / 2.0);
  const Vector3 x = glm::normalize(glm::cross(y, el - em));
  return glm::quat_cast(Matrix3(x, y, glm::cross(x, y)));
}

Vector3 ClavicleAxis(const Vector3& sc, const Vector3& pac) noexcept {
  return glm::normalize(pac - sc);
}

}  // namespace girdle
