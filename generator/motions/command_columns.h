// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Arm commands in the columns of a CSV file.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kinematics/shoulder_rhythm.h"
#include "motions/angle_span.h"
#include "motions/arm_angles.h"
#include "motions/column_names.h"
#include "text/csv.h"

namespace girdle {

/// The columns of one file that make its commands: `elevation_deg` and `plane_deg`, optionally
/// `axial_deg`, `shrug_deg` and `protraction_deg`, in any order, or other names for them
/// (ColumnNames). Other columns are ignored. Two kinds of other columns are errors: one with nearly
/// one of these names, and one that means the axial turn in a file without `axial_deg`. Immutable:
/// threads may share it.
class CommandColumns {
 public:
  /// `given` are the names of `--columns`; `further` are known columns beside those of commands.
  /// Throws InputError at the header if a column is missing. Throws it also if a name is nearly one
  /// of these or of `further` (IsNearly), or means the axial turn (MeansAxialTurn). The message
  /// contains the correct name. `csv` must outlive this.
  CommandColumns(const CsvReader& csv, const AngleReading& reading,
                 const std::vector<NamedColumn>& given = {},
                 const std::vector<std::string_view>& further = {});

  /// Returns the command of a row; nothing if one of its angles is a gap (CsvRows::IsGap).
  /// `otherwise` gives the values of columns that the file does not have. Adds the numbers of the
  /// row to `span` unless the unit is given. Throws InputError at the row, with column and value,
  /// for a field that is no number, for an angle that arm_angles.h rejects and for an offset beyond
  /// kShrugRange or kProtractionRange.
  [[nodiscard]] std::optional<ArmCommand> Read(const CsvRows& row, const ArmCommand& otherwise,
                                               AngleSpan& span) const;

  /// Returns `elevation_deg is empty, a gap` about the first gap of a row. Precondition: the row
  /// has one.
  [[nodiscard]] std::string GapText(const CsvRows& row) const;

  /// The zero of the file's axial turns; nothing if the file has none.
  [[nodiscard]] std::optional<AxialFrom> axial_from() const noexcept;
  /// The columns under their known names.
  [[nodiscard]] const ColumnNames& names() const noexcept { return names_; }

 private:
  struct Offset {
    std::size_t index;
    double ArmCommand::*angle_rad;
    double lower_deg;
    double upper_deg;
  };

  void FindAxial(const CsvReader& csv);
  [[nodiscard]] double Degrees(double number) const noexcept;
  [[nodiscard]] std::optional<double> OffsetRead_deg(const CsvRows& row,
                                                     const Offset& offset) const;

  AngleReading reading_;
  ColumnNames names_;
  std::size_t elevation_;
  std::size_t plane_;
  std::optional<std::size_t> axial_;
  std::vector<Offset> offsets_;
};

}  // namespace girdle
