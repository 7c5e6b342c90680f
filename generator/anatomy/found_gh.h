// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// GH of a person whose landmarks were measured.
#pragma once

#include <string>

#include "anatomy/anatomy.h"
#include "anatomy/measured_landmarks.h"

namespace girdle {

/// Adds GH to landmarks that lack it: the centre of the sphere through points of the humeral head,
/// or else an estimate from the scapula's landmarks (humeral_head.h). Returns how it was found and
/// how well, for Anatomy::gh_origin; an empty text if a row gives GH, which stays. `adult` shows
/// how far the estimate is from a GH that is known. Throws InputError, at the last of the points,
/// for points that tell no sphere or one of another size than a humeral head.
[[nodiscard]] std::string FindGh(MeasuredLandmarks& measured, const Anatomy& adult);

}  // namespace girdle
