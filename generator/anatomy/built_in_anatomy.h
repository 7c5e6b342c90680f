// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The anatomy and postures of `data/`, compiled into the program, so that no file has to be found
/// at run time.
#pragma once

#include "anatomy/anatomy.h"
#include "anatomy/postures.h"

namespace girdle {

/// Returns the adult right shoulder of data/ (landmarks, segments, joint ranges, thorax ellipsoids,
/// ligaments).
[[nodiscard]] Anatomy BuiltInAnatomy();

/// Returns SC and AC in relaxed standing (data/postures.csv).
[[nodiscard]] Posture RelaxedStanding();

}  // namespace girdle
