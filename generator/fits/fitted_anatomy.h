// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Parts of an anatomy that follow from its bones and the rhythm together: the surface that the
/// scapula glides on, and the slack lengths of the ligaments.
#pragma once

#include "anatomy/anatomy.h"

namespace girdle {

/// Gives `anatomy` the gliding ellipsoid that fits its own TS and AI under the built-in rhythm
/// (FitGlidingEllipsoid). Throws std::invalid_argument if no ellipsoid of a body's size fits.
void FitGliding(Anatomy& anatomy);

/// Gives each ligament of `anatomy` a slack length: its longest length in the positions of the
/// built-in tables, rounded up to 0.1 mm, as in data/ligaments.csv.
void FitLigaments(Anatomy& anatomy);

}  // namespace girdle
