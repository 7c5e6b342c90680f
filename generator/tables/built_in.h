// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The data of `data/`, compiled in, so that nothing has to be found at run time.
#pragma once

#include <array>
#include <string_view>

#include "kinematics/rhythm_table.h"
#include "tables/anatomy.h"

namespace girdle {

/// Returns the measured table of Ludewig et al. 2009 (data/ludewig2009.csv).
[[nodiscard]] RhythmTable BuiltInRhythmTable();

enum class BuiltInTable {
  kMeasured,   ///< as published: data/ludewig2009.csv
  kDestepped,  ///< without the steps of people dropping out: data/ludewig2009_destepped.csv
};

/// Words for the tables, in the order of the enumerators.
inline constexpr std::array<std::string_view, 2> kBuiltInTableNames = {"measured", "destepped"};

/// Returns one of the tables that are built in. They have the same planes and elevations.
[[nodiscard]] RhythmTable BuiltInRhythmTable(BuiltInTable table);

/// Returns the adult right shoulder of data/ (landmarks, segments, joint ranges, thorax
/// ellipsoids).
[[nodiscard]] Anatomy BuiltInAnatomy();

}  // namespace girdle
