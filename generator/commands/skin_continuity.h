// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Comparison of the interpolations slerp, squad and smooth by their effect on one skin.
#pragma once

#include <string>
#include <vector>

#include "kinematics/knot_crossings.h"
#include "kinematics/shoulder_rhythm.h"
#include "skin/skin_measures.h"

namespace girdle {

/// A largest value over landmarks and commands [mm/deg], and where it is:
/// `skin_ac, elevation 115, plane 0.5`.
struct SkinFigure {
  double value_mm_per_deg = 0;
  std::string where;
};

/// Jumps of the velocity of skin landmarks where an interpolation crosses the inner knots of a
/// table in one direction.
struct SkinJumps {
  Interpolation interpolation;
  Direction direction;
  SkinFigure ac_skin;  ///< over the landmarks that IsAcSkin
  SkinFigure all;      ///< over all landmarks
};

/// The largest movement of the AC skin under an interpolation while the elevation rises by a
/// degree.
struct SkinStep {
  Interpolation interpolation;
  SkinFigure ac_skin;
};

struct SkinContinuity {
  std::vector<SkinJumps> jumps;  ///< over elevations and planes, for each interpolation
  std::vector<SkinStep> steps;   ///< for each interpolation
};

/// Returns jumps and steps of the landmarks under each interpolation, with closure table on
/// `table`. Throws std::invalid_argument if the table is too small for one of them.
[[nodiscard]] SkinContinuity MeasureSkin(const LandmarkSkin& landmarks, const RhythmTable& table);

[[nodiscard]] std::string SkinContinuityAsText(const SkinContinuity& skin);

}  // namespace girdle
