// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Solving many poses: those of a CSV, or all combinations of some elevations and planes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "commands/solve_columns.h"
#include "kinematics/shoulder_rhythm.h"

namespace girdle {

/// Columns of the input, and of one pose as JSON the keys.
inline constexpr const char* kElevationColumn = "elevation_deg";
inline constexpr const char* kPlaneColumn = "plane_deg";
inline constexpr const char* kAxialColumn = "axial_deg";
inline constexpr const char* kShrugColumn = "shrug_deg";
inline constexpr const char* kProtractionColumn = "protraction_deg";

/// Where rows come from.
struct RowSource {
  std::istream& in;
  std::string name;      ///< for messages
  std::uintmax_t bytes;  ///< to come; 0 if that is not known
};

/// All combinations of these, in the order of the output: the elevations of the first plane, then
/// those of the next. Neither is empty.
struct SweptPositions {
  std::vector<double> elevations_deg;
  std::vector<double> planes_deg;
};

/// What all rows have in common.
struct RowOptions {
  /// In place of their columns, which must not be there then.
  std::optional<double> axial_deg;
  AxialFrom axial_from = AxialFrom::kRhythm;  ///< what axial turns that are given are counted from
  std::optional<double> shrug_deg;
  std::optional<double> protraction_deg;
  SolveAdditions additions;
  std::size_t threads = 1;  ///< at least 1
};

/// Writes every row of `source` with its SolveColumns behind it to `out` (`-` is standard output),
/// in their order and with the same bytes whatever the number of threads. Memory does not grow with
/// the number of rows. Whenever it has to wait for its input, all rows that came are answered, on
/// standard output too.
///
/// Throws InputError, with file and line, at the first row that cannot be solved. A file that was
/// to be written is then as it was before; standard output has whole rows from before that row.
void SolveRows(const RowSource& source, const std::string& out, const ShoulderRhythm& rhythm,
               const RowOptions& options);

/// Writes what SolveRows would write for a CSV with a row for each position.
void SolveSweep(const SweptPositions& sweep, const std::string& out, const ShoulderRhythm& rhythm,
                const RowOptions& options);

}  // namespace girdle
