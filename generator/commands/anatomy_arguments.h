// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Options that say whose shoulder it is: landmarks of one person, or figures of a tape measure.
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <string>

#include "anatomy/anatomy.h"
#include "anatomy/body_size.h"

namespace girdle {

/// `--anatomy`, `--ellipsoids` and the measures as given; empty where not given.
struct AnatomyArguments {
  std::string file;
  std::string ellipsoids;
  std::array<std::string, kBodyMeasures.size()> measures;  ///< in the order of kBodyMeasures
};

void AddAnatomyArguments(CLI::App& verb, AnatomyArguments& arguments);

/// Returns the anatomy chosen: that of the file or the built-in one in the size that the measures
/// say. The scapula of bones of other proportions glides on an ellipsoid fitted to them under the
/// built-in rhythm, or on that of the `--ellipsoids` file. With a file of landmarks, lengths are
/// its own, and of stature the height above the floor is taken; if GH is not among its rows,
/// standard error says how it was found. Throws InputError for a file that is not of a right
/// shoulder, a measure that nobody has, and a length beside a file of landmarks.
[[nodiscard]] Anatomy ChosenAnatomy(const AnatomyArguments& arguments);

/// Says on standard error how GH was found, and how well, if no row of the file of landmarks gives
/// it.
void SayHowGhWasFound(const std::string& file, const Anatomy& anatomy);

/// Gives bones of other proportions the ligaments and the gliding ellipsoid that belong to them
/// under the built-in rhythm. Throws InputError
/// if the scapula glides on no ellipsoid.
void FitTissues(Anatomy& anatomy);

/// Returns whether any of the options was given.
[[nodiscard]] bool IsAnatomyChosen(const AnatomyArguments& arguments) noexcept;

}  // namespace girdle
