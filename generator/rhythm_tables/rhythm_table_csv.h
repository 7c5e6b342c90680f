// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The measured rhythm as text.
///
/// Columns: `plane_deg`, `elevation_deg`, the nine coordinates of kCoordinateNames with `_deg`;
/// optionally `origin`
/// (`measured` or `sc_ac_derived`) and the three published scapulothoracic angles
/// `st_internal_rotation_deg`, `st_upward_rotation_deg`, `st_tilt_deg`. One row a position: planes
/// one after the other, elevations increasing within each, the same elevations in all. Angles in
/// degrees within [-180, 180].
#pragma once

#include <istream>
#include <string>
#include <vector>

#include "kinematics/shoulder_rhythm.h"

namespace girdle {

/// Reads and validates a table. Throws InputError with file, line, value and expectation.
[[nodiscard]] RhythmTable ReadRhythmTable(std::istream& in, const std::string& name);

/// Returns the table as a file that ReadRhythmTable reads: `comments`, each a line that begins with
/// `#`, the header, the rows. Angles are rounded to `decimals` places of a degree, so that the text
/// does not depend on a machine's last digits; planes and elevations keep all of theirs.
[[nodiscard]] std::string RhythmTableToCsv(const RhythmTable& table,
                                           const std::vector<std::string>& comments, int decimals);

/// Returns the table as one line, rows separated by `;`, in the form that RhythmTableFromLine reads
/// back; for places that cannot hold line breaks, such as an XML attribute.
[[nodiscard]] std::string RhythmTableToLine(const RhythmTable& table);

/// Reads the text of RhythmTableToLine. Throws InputError; `name` stands in messages for the file
/// and a row counts as a line.
[[nodiscard]] RhythmTable RhythmTableFromLine(std::string line, const std::string& name);

}  // namespace girdle
