// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Named places of the skin over a shoulder.
#pragma once

#include <array>
#include <vector>

#include "names/model_names.h"
#include "skin/posed_body.h"

namespace girdle {

/// Vertices of one shoulder's skin landmarks, in the order of kSkinLandmarkNames: the nearest one
/// first.
using SkinLandmarkVertices = std::array<std::vector<int>, kSkinLandmarkCount>;

/// Returns the vertices nearest to what the landmarks lie over, on the body as it stands: the
/// centre of the AC joint, the tip of the acromion (three vertices, whose mean is meant), the
/// middle of the clavicle, the middle of the scapular spine, and the side of the arm that looks
/// away from the body, at a third of its length. Throws std::invalid_argument for a surface with
/// too few vertices.
[[nodiscard]] SkinLandmarkVertices FindSkinLandmarks(const PosedBody& body, Side side);

}  // namespace girdle
