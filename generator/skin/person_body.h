// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// A person's own surface, with bones where the person's landmarks are.
#pragma once

#include <string>
#include <vector>

#include "names/model_names.h"
#include "skin/posed_body.h"

namespace girdle {

/// How far outside the skin a landmark may be [m]: palpated ones lie on it, up to the error of
/// measuring.
inline constexpr double kOutsideSkin_m = 0.005;

/// Reads a mesh (mesh_file.h) and the landmarks of the right shoulder of the person whose skin it
/// is, in the mesh's coordinates, in the format of a laboratory (person_landmarks.h). Ligaments and
/// the gliding ellipsoid are not fitted to the bones. Throws InputError for what ReadMeshFile,
/// FlawOfSkin or ReadDigitizedPerson find, and if a landmark of one of `sides` (of a left one: its
/// mirror image in the thorax's median plane) lies more than kOutsideSkin_m outside the skin.
[[nodiscard]] PosedBody ReadPersonBody(const std::string& mesh_file,
                                       const std::string& landmark_file, const Anatomy& adult,
                                       const std::vector<Side>& sides);

}  // namespace girdle
