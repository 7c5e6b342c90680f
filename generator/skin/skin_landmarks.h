// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Named places on the skin over a shoulder.
#pragma once

#include <array>
#include <vector>

#include "names/model_names.h"
#include "skin/posed_body.h"

namespace girdle {

/// Vertices of one shoulder's skin landmarks, in the order of kSkinLandmarkNames. The nearest
/// vertex of each is the first.
using SkinLandmarkVertices = std::array<std::vector<int>, kSkinLandmarkCount>;

/// Returns the vertices nearest to the five places below the landmarks, on the body in its present
/// pose. The places are the centre of the AC joint, the tip of the acromion (three vertices, whose
/// mean is the landmark), the middle of the clavicle, the middle of the scapular spine, and the
/// lateral side of the arm at a third of its length. Throws std::invalid_argument if the surface
/// has too few vertices.
[[nodiscard]] SkinLandmarkVertices FindSkinLandmarks(const PosedBody& body, Side side);

}  // namespace girdle
