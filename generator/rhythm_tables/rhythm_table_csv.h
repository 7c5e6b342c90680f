// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The measured rhythm as text.
///
/// Columns are `plane_deg`, `elevation_deg` and the nine coordinates of kCoordinateNames with
/// `_deg`. Optional columns are `origin` (with the words `measured` and `sc_ac_derived`) and the
/// three published scapulothoracic angles `st_internal_rotation_deg`, `st_upward_rotation_deg` and
/// `st_tilt_deg`. Each position is one row. Planes follow each other, elevations increase within
/// each plane, and all planes have the same elevations. Angles are degrees within [-180, 180].
#pragma once

#include <istream>
#include <string>
#include <vector>

#include "kinematics/shoulder_rhythm.h"

namespace girdle {

/// Reads and validates a table. Throws InputError with file, line, value and expectation.
[[nodiscard]] RhythmTable ReadRhythmTable(std::istream& in, const std::string& name);

/// Returns the table as a file that ReadRhythmTable reads: `comments`, each a line that begins with
/// `#`, then the header, then the rows. Angles are rounded to `decimals` places of a degree, so the
/// text does not depend on a machine's last digits. Planes and elevations keep all digits.
[[nodiscard]] std::string RhythmTableToCsv(const RhythmTable& table,
                                           const std::vector<std::string>& comments, int decimals);

/// Returns the table as one line that RhythmTableFromLine reads back. Rows are separated by `;`. It
/// is for places without line breaks, such as an XML attribute.
[[nodiscard]] std::string RhythmTableToLine(const RhythmTable& table);

/// Reads the text of RhythmTableToLine. Throws InputError. Its message has `name` instead of the
/// file and the number of the row instead of the line.
[[nodiscard]] RhythmTable RhythmTableFromLine(std::string line, const std::string& name);

}  // namespace girdle
