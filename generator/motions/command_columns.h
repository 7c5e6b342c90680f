// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Commands of the arm in the columns of a CSV file.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "kinematics/shoulder_rhythm.h"
#include "motions/angle_span.h"
#include "motions/arm_angles.h"
#include "text/csv.h"

namespace girdle {

/// Names of the columns. They end in `_deg` in files with radians, too.
inline constexpr const char* kElevationColumn = "elevation_deg";
inline constexpr const char* kPlaneColumn = "plane_deg";
inline constexpr const char* kAxialColumn = "axial_deg";
inline constexpr const char* kShrugColumn = "shrug_deg";
inline constexpr const char* kProtractionColumn = "protraction_deg";

/// The columns of one file that make its commands: `elevation_deg` and `plane_deg`, optionally
/// `axial_deg`, `shrug_deg` and `protraction_deg`, in any order. Others are nobody's business,
/// unless they are nearly one of these or, in a file without `axial_deg`, mean the axial turn.
/// Immutable: threads share it.
class CommandColumns {
 public:
  /// Throws InputError at the header if a column is missing, or is nearly called as one of these or
  /// of `further` (IsNearly) or as the axial turn (MeansAxialTurn), with the name that is meant.
  CommandColumns(const CsvReader& csv, const AngleReading& reading,
                 const std::vector<std::string_view>& further = {});

  /// Returns the command of a row; `otherwise` says what stands in place of columns that the file
  /// has not. Adds its numbers to `span` unless the unit is said. Throws InputError at the row,
  /// with column and value, for what is not an angle of arm_angles.h or beyond kShrugRange and
  /// kProtractionRange.
  [[nodiscard]] ArmCommand Read(const CsvRows& row, const ArmCommand& otherwise,
                                AngleSpan& span) const;

  /// What the file's axial turns count from; nothing if it has none.
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
