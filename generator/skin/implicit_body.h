// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// A human upper body without a head, made of solids about the bones: no scan, no data.
#pragma once

#include <vector>

#include "names/model_names.h"
#include "skin/posed_body.h"

namespace girdle {

/// Size of the grid's cells in an adult [m]; they grow with the thorax.
inline constexpr double kImplicitCell_m = 0.010;

/// Returns the surface of thorax, neck, shoulders and arms about the bones of `anatomy`, the arms
/// raised 45 deg in the frontal plane: closed, every edge shared by two triangles. The arm of
/// a side that is not in `sides` is cut off above its middle. Muscles are drawn after textbook
/// figures, where an adult has them, and grow with the bone that they are given to; every bone is
/// covered wherever its landmarks are. The same anatomy gives the same surface.
[[nodiscard]] PosedBody ImplicitBody(const Anatomy& anatomy, const std::vector<Side>& sides);

}  // namespace girdle
