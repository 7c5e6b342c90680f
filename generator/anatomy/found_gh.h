// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Finds GH of a person whose other landmarks were measured.
#pragma once

#include <string>

#include "anatomy/anatomy.h"
#include "anatomy/measured_landmarks.h"

namespace girdle {

/// Adds GH to landmarks that lack it. GH is the centre of the sphere through points of the humeral
/// head, if there are such points; otherwise it is estimated from the scapula's landmarks
/// (humeral_head.h). Returns how GH was found and how precisely, for Anatomy::gh_origin. If a row
/// gives GH, it is not changed and the result is empty. `adult` has a known GH, which shows the
/// error of the estimate. Throws InputError at the last of the points if they determine no sphere,
/// or a sphere that does not have the size of a humeral head.
[[nodiscard]] std::string FindGh(MeasuredLandmarks& measured, const Anatomy& adult);

}  // namespace girdle
