// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// What people call the axial turn of the humerus.
#pragma once

#include <string_view>

namespace girdle {

/// Returns whether the name of a column plainly means the humerus's turn about its long axis:
/// `axial_rotation_deg`, `axial_isb_deg`, `humeral_rotation`, `InternalRotation (deg)`. It is so if
/// the name is made of words for that alone, with a unit behind or none; capital letters,
/// characters between words and a slip in a longer word (`rotaton`) do not matter. A name
/// that says whose turn it is otherwise is not: `gh_axial_deg`, `ac_internal_rotation_deg`,
/// `used_axial_deg`, `trunk_rotation_deg`.
[[nodiscard]] bool MeansAxialTurn(std::string_view column);

}  // namespace girdle
