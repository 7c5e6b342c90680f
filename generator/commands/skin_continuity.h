// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// What slerp, squad and smooth do to one skin, in which they differ alone.
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

/// How an interpolation moves skin landmarks where it crosses a table's inner knots along one
/// direction: jumps of their velocity.
struct SkinJumps {
  Interpolation interpolation;
  Direction direction;
  SkinFigure ac_skin;  ///< of the landmarks that IsAcSkin
  SkinFigure all;      ///< of all landmarks
};

/// How far an interpolation moves the AC skin at most while the elevation rises by a degree.
struct SkinStep {
  Interpolation interpolation;
  SkinFigure ac_skin;
};

struct SkinContinuity {
  std::vector<SkinJumps> jumps;  ///< over elevations and planes, of each interpolation
  std::vector<SkinStep> steps;   ///< of each interpolation
};

/// Returns what the interpolations, each with closure table on the same table, do to landmarks.
/// Throws std::invalid_argument if the table is too small for one of them.
[[nodiscard]] SkinContinuity MeasureSkin(const LandmarkSkin& landmarks, const RhythmTable& table);

[[nodiscard]] std::string SkinContinuityAsText(const SkinContinuity& skin);

}  // namespace girdle
