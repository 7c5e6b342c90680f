// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// A person's own surface, with bones at the person's landmarks.
#pragma once

#include <string>
#include <vector>

#include "names/model_names.h"
#include "skin/posed_body.h"

namespace girdle {

/// The largest distance [m] of a landmark outside the skin. Palpated landmarks lie on the skin, up
/// to the error of measuring.
inline constexpr double kOutsideSkin_m = 0.005;

/// Reads a mesh (mesh_file.h) and the landmarks of the right shoulder of the same person. The
/// landmarks are in the mesh's coordinates, in the format of a laboratory (person_landmarks.h).
/// Ligaments and the gliding ellipsoid are not fitted to the bones. Throws InputError for the
/// faults that ReadMeshFile, FlawOfSkin and ReadDigitizedPerson find. Throws it also if a landmark
/// of one of `sides` lies more than kOutsideSkin_m outside the skin; a left one is the mirror image
/// in the thorax's median plane.
[[nodiscard]] PosedBody ReadPersonBody(const std::string& mesh_file,
                                       const std::string& landmark_file, const Anatomy& adult,
                                       const std::vector<Side>& sides);

}  // namespace girdle
