// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// How many commands were answered unchanged, and why the others were not.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "kinematics/shoulder_rhythm.h"

namespace girdle {

struct CommandTally {
  std::size_t rows = 0;
  std::size_t clamped = 0;   ///< answered by another command
  std::size_t beyond = 0;    ///< of the clamped ones, those answered in another direction
  std::size_t derived = 0;   ///< answered by Origin::kDerived
  std::size_t modelled = 0;  ///< answered by Origin::kModelled
  double farthest_rad = 0;   ///< largest distance of a command from measured directions
  std::size_t gaps = 0;      ///< rows with a missing angle, without an answer
  std::size_t bridged = 0;   ///< rows with a missing angle, answered as on the way past them

  /// Adds a command and the values that ShoulderSolution has for its answer.
  void Add(const ShoulderRhythm& rhythm, const ArmCommand& command, const ArmCommand& used,
           Origin origin, double distance_rad) noexcept;
  void Add(const CommandTally& other) noexcept;
};

/// The subject of a tally.
struct TallySubject {
  Range range = Range::kWhole;       ///< of the rhythm that answered the commands
  std::string_view counted = "row";  ///< singular word for what was answered
  bool has_used_columns = true;      ///< whether the columns used_* were written
  /// The zero of the axial turns that were read; nothing if none were read.
  std::optional<AxialFrom> axial_from = std::nullopt;
  /// The origin of the hanging arm that rotations are counted from; nothing if they are not.
  std::optional<Origin> hanging = std::nullopt;
};

/// Returns one line without its line break:
///
///     6 rows, 1 clamped (1 beyond what an arm reaches; see the columns used_*), 1 derived, 2
///     modelled (up to 37.2 deg from measured directions), 2 gaps, 3 bridged, axial from isb,
///     relative to hanging (modelled)
///
/// Derived rows, gaps and bridged rows are left out if there are none.
[[nodiscard]] std::string TallyText(const CommandTally& tally, const TallySubject& subject);

}  // namespace girdle
