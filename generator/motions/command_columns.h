// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Arm commands in the columns of a CSV file.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "kinematics/shoulder_rhythm.h"
#include "motions/angle_span.h"
#include "motions/arm_angles.h"
#include "text/csv.h"

namespace girdle {

/// Names of the columns. They end in `_deg` even if the file contains radians.
inline constexpr const char* kElevationColumn = "elevation_deg";
inline constexpr const char* kPlaneColumn = "plane_deg";
inline constexpr const char* kAxialColumn = "axial_deg";
inline constexpr const char* kShrugColumn = "shrug_deg";
inline constexpr const char* kProtractionColumn = "protraction_deg";

/// The columns of one file that make its commands: `elevation_deg` and `plane_deg`, optionally
/// `axial_deg`, `shrug_deg` and `protraction_deg`, in any order. Other columns are ignored. Two
/// kinds of other columns are errors: one with nearly one of these names, and one that means the
/// axial turn in a file without `axial_deg`. Immutable: threads may share it.
class CommandColumns {
 public:
  /// Throws InputError at the header if a column is missing. Throws it also if a name is nearly one
  /// of these or of `further` (IsNearly), or means the axial turn (MeansAxialTurn). The message
  /// contains the correct name.
  CommandColumns(const CsvReader& csv, const AngleReading& reading,
                 const std::vector<std::string_view>& further = {});

  /// Returns the command of a row. `otherwise` gives the values of columns that the file does not
  /// have. Adds the numbers of the row to `span` unless the unit is given. Throws InputError at the
  /// row, with column and value, for an angle that arm_angles.h rejects and for an offset beyond
  /// kShrugRange or kProtractionRange.
  [[nodiscard]] ArmCommand Read(const CsvRows& row, const ArmCommand& otherwise,
                                AngleSpan& span) const;

  /// The zero of the file's axial turns; nothing if the file has none.
  [[nodiscard]] std::optional<AxialFrom> axial_from() const noexcept;

 private:
  struct Offset {
    std::size_t index;
    double ArmCommand::*angle_rad;
    double lower_deg;
    double upper_deg;
  };

  void FindAxial(const CsvReader& csv);
  [[nodiscard]] double Degrees(double number) const noexcept;
  [[nodiscard]] double OffsetRead_deg(const CsvRows& row, const Offset& offset) const;

  AngleReading reading_;
  std::size_t elevation_;
  std::size_t plane_;
  std::optional<std::size_t> axial_;
  std::vector<Offset> offsets_;
};

}  // namespace girdle
