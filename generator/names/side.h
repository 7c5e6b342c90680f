// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The two sides of a body: the names of their elements, and how they mirror each other.
///
/// A left shoulder is the mirror image of a right one in the sagittal plane, which is the plane z =
/// 0 of the thorax frame. Frames are mirrored with the bones, so joint coordinates are equal on
/// both sides.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "kinematics/rotation.h"
#include "kinematics/words.h"

namespace girdle {

enum class Side { kRight, kLeft };

/// Words for the sides and suffixes of their elements' names, in the order of the enumerators.
inline constexpr std::array<std::string_view, 2> kSideNames = {"right", "left"};
constexpr const auto& WordsOf(Side /*which*/) noexcept { return kSideNames; }
inline constexpr std::array<std::string_view, 2> kSideSuffixes = {"_r", "_l"};

/// Returns the name of an element of one side, for example `scapula_r`.
[[nodiscard]] inline std::string SidedName(std::string_view stem, Side side) {
  return std::string(stem) + std::string(kSideSuffixes[static_cast<std::size_t>(side)]);
}

/// Takes a rotation `q_AB` or a position `p_A` of a right shoulder to `side`. It returns the mirror
/// image for the left side and the unchanged value for the right side. Two calls with the same side
/// give the value back, so OnSide also takes a value of `side` to the right side.
[[nodiscard]] inline Quaternion OnSide(Side side, const Quaternion& q_AB) noexcept {
  return side == Side::kRight ? q_AB : Mirrored(q_AB);
}
[[nodiscard]] inline Vector3 OnSide(Side side, const Vector3& p_A) noexcept {
  return side == Side::kRight ? p_A : Mirrored(p_A);
}
/// Takes an axis of rotation to `side`. A mirror reverses the sense of a rotation.
[[nodiscard]] inline Vector3 AxisOnSide(Side side, const Vector3& axis) noexcept {
  return side == Side::kRight ? axis : -Mirrored(axis);
}

}  // namespace girdle
