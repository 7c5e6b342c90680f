// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// A comparison of rhythms as text: for people, for programs, and the map itself. Angles in
/// degrees.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "rhythms/comparison.h"

namespace girdle {

/// Name of the measured rhythm in reports.
inline constexpr std::string_view kMeasuredName = "Girdle";

/// Returns tables for people: what each rhythm says, differences within the table and on the whole
/// map side by side, scapulohumeral ratios. `-` where a rhythm says nothing.
[[nodiscard]] std::string ComparisonAsText(const Comparison& comparison);

/// Returns the same as JSON: `interpolation`, `closure`, `map`, `table`, `rhythms` with the array
/// `differences`, `scapulohumeral_ratio`. Null where a rhythm says nothing.
[[nodiscard]] std::string ComparisonAsJson(const Comparison& comparison);

/// Writes the map as CSV through `write`, in pieces: one row a rhythm (the measured one first),
/// elevation and plane, with the nine joint angles, the three of the scapula in the thorax and the
/// differences. Clamped positions are left out; a field is empty where a rhythm says nothing.
void WriteMapCsv(const ShoulderRhythm& measured, const std::vector<PublishedRhythm>& published,
                 const ComparisonMap& map, const std::function<void(std::string_view)>& write);

}  // namespace girdle
