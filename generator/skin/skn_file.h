// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// MuJoCo's own format of skins.
#pragma once

#include <string>

#include "skin/bound_skin.h"

namespace girdle {

/// Returns a skin as the bytes of an .skn file: four counts, vertices, triangles, and of each bone
/// its body's name in 40 bytes, its place, its rotation and its vertices with their weights; little
/// endian, 32 bits a number, without texture. Throws std::invalid_argument for a name that is too
/// long.
[[nodiscard]] std::string SknBytes(const BoundSkin& skin);

}  // namespace girdle
