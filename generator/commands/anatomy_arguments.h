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

/// Returns the chosen anatomy: that of the file, or the built-in one scaled to the body measures.
///
/// With `--ellipsoids`, the scapula glides on the ellipsoid of that file. Otherwise, for bones of
/// other proportions than the built-in ones, an ellipsoid is fitted under the built-in rhythm. A
/// file of landmarks sets the lengths itself; of the measure of stature only the height above the
/// floor is used with it. If GH is not among its rows, a line on standard error tells how GH was
/// found.
///
/// Throws InputError for a file that is not of a right shoulder, for a measure outside the range of
/// people, and for a length that is given beside a file of landmarks.
[[nodiscard]] Anatomy ChosenAnatomy(const AnatomyArguments& arguments);

/// Prints on standard error how GH was found, and how well, if no row of the file of landmarks
/// gives it.
void SayHowGhWasFound(const std::string& file, const Anatomy& anatomy);

/// Fits ligaments and the gliding ellipsoid under the built-in rhythm to bones of other
/// proportions. Throws InputError if the scapula glides on no ellipsoid.
void FitTissues(Anatomy& anatomy);

/// Returns whether any of the options was given.
[[nodiscard]] bool IsAnatomyChosen(const AnatomyArguments& arguments) noexcept;

}  // namespace girdle
