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
#include "motions/column_names.h"
#include "motions/gap_reading.h"

namespace girdle {

/// Input of rows.
struct RowSource {
  std::istream& in;
  std::string name;      ///< for messages
  std::uintmax_t bytes;  ///< remaining in the input; 0 if not known
};

/// All combinations of these elevations and planes, in the order of the output: the elevations of
/// the first plane, then those of the next. Neither list is empty. Values are as typed: elevations
/// have the sign of the convention of RowOptions and are valid for ElevationRead_deg, planes may
/// have whole turns added.
struct SweptPositions {
  std::vector<double> elevations_deg;
  std::vector<double> planes_deg;
};

/// Options that apply to all rows.
struct RowOptions {
  AngleReading reading;
  std::vector<NamedColumn> columns;  ///< names of `--columns`
  GapReading gaps;
  /// Values for all rows. The input must not have columns for those that are given.
  std::optional<double> axial_deg;
  std::optional<double> shrug_deg;
  std::optional<double> protraction_deg;
  SolveOutput output;
  std::size_t threads = 1;  ///< at least 1
};

/// Writes every row of `source` followed by its SolveColumns to `out` (`-` is standard output).
/// Rows stay in their order, and the bytes do not depend on the number of threads. Memory does not
/// grow with the number of rows. Before it waits for more input, it writes the answers to all rows
/// that came, to standard output too.
///
/// Rows with gaps have empty fields in place of SolveColumns, unless they are bridged as evenly
/// spaced rows. A bridged row waits for the row that ends its gap.
///
/// Throws InputError, with file and line, at the first row that cannot be solved. An output file
/// then is as it was before; standard output has whole rows, all from before that row. A stream
/// that looks like radians (AngleSpan) is recognised only at its end; check a file with
/// ExpectKnownUnit first. At the end, the line of TallyText is written to standard error.
void SolveRows(const RowSource& source, const std::string& out, const ShoulderRhythm& rhythm,
               const RowOptions& options);

/// Throws InputError if the rows of a file look like radians and the options do not give the unit.
/// Stops reading at the first row that does not look like radians.
void ExpectKnownUnit(const std::string& path, const AngleReading& reading,
                     const std::vector<NamedColumn>& names);

/// Writes what SolveRows would write for a CSV with a row for each position. The columns are
/// elevation and plane as typed, and those of axial turn and offsets that the options give.
void SolveSweep(const SweptPositions& sweep, const std::string& out, const ShoulderRhythm& rhythm,
                const RowOptions& options);

}  // namespace girdle
