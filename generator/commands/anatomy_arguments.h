// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Options that say whose shoulder it is: landmarks of one person, or figures of a tape measure.
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <string>

#include "tables/anatomy.h"
#include "tables/body_size.h"

namespace girdle {

/// `--anatomy` and the measures as given; empty where not given.
struct AnatomyArguments {
  std::string file;
  std::array<std::string, kBodyMeasures.size()> measures;  ///< in the order of kBodyMeasures
};

void AddAnatomyArguments(CLI::App& verb, AnatomyArguments& arguments);

/// Returns the anatomy chosen: that of the file or the built-in one in the size that the measures
/// say. With a file, lengths are its own, and of stature the height above the floor is taken.
/// Throws InputError for a file that is not of a right shoulder, a measure that nobody has, and a
/// length beside a file.
[[nodiscard]] Anatomy ChosenAnatomy(const AnatomyArguments& arguments);

}  // namespace girdle
