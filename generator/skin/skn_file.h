// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// MuJoCo's own file format of skins.
#pragma once

#include <string>

#include "skin/bound_skin.h"

namespace girdle {

/// Returns a skin as the bytes of an .skn file. It contains four counts, the vertices, the
/// triangles, and for each bone its body's name in 40 bytes, its position, its rotation and its
/// vertices with their weights. Numbers are little endian with 32 bits. There is no texture. Throws
/// std::invalid_argument if a name is too long.
[[nodiscard]] std::string SknBytes(const BoundSkin& skin);

}  // namespace girdle
