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
#include "motions/arm_angles.h"

namespace girdle {

/// Where rows come from.
struct RowSource {
  std::istream& in;
  std::string name;      ///< for messages
  std::uintmax_t bytes;  ///< to come; 0 if that is not known
};

/// All combinations of these, in the order of the output: the elevations of the first plane, then
/// those of the next. Neither is empty. As they were typed: elevations have the sign of the
/// convention of RowOptions and are ones of ElevationRead_deg, planes may be whole turns on.
struct SweptPositions {
  std::vector<double> elevations_deg;
  std::vector<double> planes_deg;
};

/// What all rows have in common.
struct RowOptions {
  AngleReading reading;
  /// In place of their columns, which must not be there then.
  std::optional<double> axial_deg;
  std::optional<double> shrug_deg;
  std::optional<double> protraction_deg;
  SolveOutput output;
  std::size_t threads = 1;  ///< at least 1
};

/// Writes every row of `source` with its SolveColumns behind it to `out` (`-` is standard output),
/// in their order and with the same bytes whatever the number of threads. Memory does not grow with
/// the number of rows. Whenever it has to wait for its input, all rows that came are answered, on
/// standard output too.
///
/// Throws InputError, with file and line, at the first row that cannot be solved. A file that was
/// to be written is then as it was before; standard output has whole rows from before that row. A
/// stream that looks like radians (AngleSpan) shows only at its end; a file is to be asked before,
/// with ExpectKnownUnit. At the end standard error has the line of TallyText.
void SolveRows(const RowSource& source, const std::string& out, const ShoulderRhythm& rhythm,
               const RowOptions& options);

/// Throws InputError if the rows of a file look like radians and options do not say their unit.
/// Reads no further than the first row that does not.
void ExpectKnownUnit(const std::string& path, const AngleReading& reading);

/// Writes what SolveRows would write for a CSV with a row for each position: elevation and plane as
/// they were typed and, of axial turn and offsets, those that the options give.
void SolveSweep(const SweptPositions& sweep, const std::string& out, const ShoulderRhythm& rhythm,
                const RowOptions& options);

}  // namespace girdle
