// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The rhythm tables of `data/`, compiled into the program, so that no file has to be found at run
/// time.
#pragma once

#include <array>
#include <string_view>

#include "kinematics/shoulder_rhythm.h"

namespace girdle {

enum class BuiltInTable {
  kMeasured,  ///< as published: data/ludewig2009.csv
  kSmoothed,  ///< without the steps where people drop out: data/ludewig2009_smoothed.csv
};

/// Words for the tables, in the order of the enumerators.
inline constexpr std::array<std::string_view, 2> kBuiltInTableNames = {"measured", "smoothed"};

constexpr const auto& WordsOf(BuiltInTable /*which*/) noexcept { return kBuiltInTableNames; }

/// Returns the table that an interpolation uses unless another one is chosen. For squad
/// and slerp it is the measured table, as published. For smooth it is the smoothed table, because a
/// curve with continuous second derivatives through the measured rows swings where people drop out
/// of the measurement. No row of the smoothed table is moved by more than 0.7 deg, a third of the
/// disagreement among the measured tables.
[[nodiscard]] BuiltInTable DefaultTable(Interpolation interpolation) noexcept;

/// Returns a built-in table. All built-in tables have the same planes and elevations.
[[nodiscard]] RhythmTable BuiltInRhythmTable(BuiltInTable table);

/// Returns the rhythm of the interpolation's default table, with the joint ranges of the built-in
/// anatomy. Throws InputError if the options exclude each other.
[[nodiscard]] ShoulderRhythm BuiltInRhythm(const RhythmOptions& options = {});

}  // namespace girdle
