// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Configuration of one instance of the plugin, parsed from the texts of its `<config>` elements.
#pragma once

#include <array>
#include <string>

#include "names/model_names.h"
#include "rhythm_tables/rhythm_choice.h"

namespace girdle {

/// The texts as written in the model; empty if absent.
struct RhythmConfigText {
  std::string interpolation;
  std::string closure;
  std::string range;
  std::string table;
  std::string stiffness;
  std::string side{};
  std::string translation_stiffness{};
  std::string axial_from{};
};

struct RhythmConfig {
  RhythmChoice rhythm;
  std::array<double, kCoordinateCount> stiffness_N_m_per_rad;  ///< in the order of kCoordinateNames
  Side side = Side::kRight;
  double translation_stiffness_N_per_m = 0;
  AxialFrom axial_from = AxialFrom::kRhythm;  ///< zero of the command actuator `axial`
};

/// Returns the validated configuration. Throws InputError that names key, value and the fix.
[[nodiscard]] RhythmConfig ParseRhythmConfig(const RhythmConfigText& text);

}  // namespace girdle
