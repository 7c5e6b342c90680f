// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// A human upper body without head, modelled from solids around the bones. It uses no scan and no
/// data.
#pragma once

#include <vector>

#include "names/model_names.h"
#include "skin/posed_body.h"

namespace girdle {

/// Size of the grid's cells [m] for an adult. It is scaled with the thorax.
inline constexpr double kImplicitCell_m = 0.010;

/// Returns the surface of thorax, neck, shoulders and arms around the bones of `anatomy`, with the
/// arms raised 45 deg in the frontal plane. The surface is closed: every edge is shared by two
/// triangles. If a side is not in `sides`, its arm is cut off above the middle. Muscles follow
/// textbook figures of an adult and are scaled with the bone that they belong to. Every bone is
/// covered for any landmarks. The same anatomy gives the same surface.
[[nodiscard]] PosedBody ImplicitBody(const Anatomy& anatomy, const std::vector<Side>& sides);

}  // namespace girdle
