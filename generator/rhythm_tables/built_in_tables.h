// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The rhythm tables of `data/`, compiled in, so that nothing has to be found at run time.
#pragma once

#include <array>
#include <string_view>

#include "kinematics/shoulder_rhythm.h"

namespace girdle {

enum class BuiltInTable {
  kMeasured,   ///< as published: data/ludewig2009.csv
  kSmoothed,  ///< without the steps of people dropping out: data/ludewig2009_smoothed.csv
};

/// Words for the tables, in the order of the enumerators.
inline constexpr std::array<std::string_view, 2> kBuiltInTableNames = {"measured", "smoothed"};

constexpr const auto& WordsOf(BuiltInTable /*which*/) noexcept { return kBuiltInTableNames; }

/// The table that an interpolation uses unless told otherwise. Smooth: the de-stepped one, because
/// a curve with continuous second derivatives through the measured rows swings where people dropped
/// out, and no row of the other moves by more than 0.7
/// deg, a third of what the measured tables disagree by among themselves. Squad and slerp: the
/// measured one, which is what was published.
[[nodiscard]] BuiltInTable DefaultTable(Interpolation interpolation) noexcept;

/// Returns one of the tables that are built in. They have the same planes and elevations.
[[nodiscard]] RhythmTable BuiltInRhythmTable(BuiltInTable table);

/// Returns the rhythm of a built-in table, the interpolation's default one, in the joint ranges of
/// the built-in anatomy. Throws InputError if the options do not go together.
[[nodiscard]] ShoulderRhythm BuiltInRhythm(const RhythmOptions& options = {});

}  // namespace girdle
