// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// A comparison of rhythms as text for people, as JSON for programs, and the whole map as CSV.
/// Angles are in degrees.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "rhythms/comparison.h"

namespace girdle {

/// Name of the measured rhythm in reports.
inline constexpr std::string_view kMeasuredName = "Girdle";

/// Returns tables for people: the angles that each rhythm defines, the differences within the table
/// next to those on the whole map, and scapulohumeral ratios. `-` means that a rhythm does not
/// define the angle.
[[nodiscard]] std::string ComparisonAsText(const Comparison& comparison);

/// Returns the content of ComparisonAsText as JSON: `interpolation`, `closure`, `map`, `table`,
/// `rhythms` with the array `differences`, `scapulohumeral_ratio`. Null means that a rhythm does
/// not define the angle.
[[nodiscard]] std::string ComparisonAsJson(const Comparison& comparison);

/// Writes the map as CSV through `write`, in pieces. Each rhythm (the measured one first),
/// elevation and plane is one row. It has the nine joint angles, the three of the scapula in the
/// thorax and the differences. Clamped positions are omitted. A field is empty if a rhythm does not
/// define the angle. Returns the number of rows.
std::size_t WriteMapCsv(const ShoulderRhythm& measured,
                        const std::vector<PublishedRhythm>& published, const ComparisonMap& map,
                        const std::function<void(std::string_view)>& write);

}  // namespace girdle
