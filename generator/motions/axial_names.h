// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Column names that mean the axial turn of the humerus.
#pragma once

#include <string_view>

namespace girdle {

/// Returns whether a column's name plainly means the humerus's turn about its long axis. Examples
/// are `axial_rotation_deg`, `axial_isb_deg`, `humeral_rotation` and `InternalRotation (deg)`. The
/// name must consist of words for that turn only, with or without a unit at the end. Capital
/// letters, characters between words and a slip in a longer word (`rotaton`) do not matter. A name
/// for the turn of something else does not count: `gh_axial_deg`, `ac_internal_rotation_deg`,
/// `used_axial_deg`, `trunk_rotation_deg`; nor does a name of more than 128 letters.
[[nodiscard]] bool MeansAxialTurn(std::string_view column);

}  // namespace girdle
