// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The data of `data/`, compiled in, so that nothing has to be found at run time.
#pragma once

#include "kinematics/rhythm_table.h"
#include "tables/anatomy.h"

namespace girdle {

/// Returns the measured table of Ludewig et al. 2009 (data/ludewig2009.csv).
[[nodiscard]] RhythmTable BuiltInRhythmTable();

/// Returns the adult right shoulder of data/ (landmarks, segments, joint ranges, thorax
/// ellipsoids).
[[nodiscard]] Anatomy BuiltInAnatomy();

}  // namespace girdle
