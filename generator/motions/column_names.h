// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Names that the columns of arm commands have in the files of other programs.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "text/csv.h"

namespace girdle {

/// Names of the columns of arm commands. They end in `_deg` even if the file contains radians.
inline constexpr const char* kElevationColumn = "elevation_deg";
inline constexpr const char* kPlaneColumn = "plane_deg";
inline constexpr const char* kAxialColumn = "axial_deg";
inline constexpr const char* kShrugColumn = "shrug_deg";
inline constexpr const char* kProtractionColumn = "protraction_deg";
inline constexpr std::array<std::string_view, 5> kCommandColumns = {
    kElevationColumn, kPlaneColumn, kAxialColumn, kShrugColumn, kProtractionColumn};
/// Name of the column of times [s] of a motion.
inline constexpr const char* kTimeColumn = "time_s";

/// A known column, and its name in a file.
struct NamedColumn {
  std::string known;
  std::string in_file;
};

/// Returns the columns that `--columns` names: `elevation_deg=shoulder_elv,plane_deg=elv_angle`.
/// Throws InputError for a text of another form, for a name that is not among `known`, and for a
/// name that is given twice.
[[nodiscard]] std::vector<NamedColumn> ReadNamedColumns(std::string_view text,
                                                        std::span<const std::string_view> known);

/// The meaning of the numbers in a column of axial turns.
enum class AxialMeaning {
  kAsRead,        ///< turns from the zero that is given with the file
  kIsb,           ///< ISB's third angle
  kIsbWithPlane,  ///< the sum of ISB's third angle and the plane
};

/// The known columns of one file: those with their own names, those that the user names, and those
/// with a name that has one meaning.
///
/// Names with one meaning are `humeral_elevation_deg`, `plane_of_elevation_deg` and the like, and
/// the coordinates of two models of OpenSim: `shoulder_elv`, `elv_angle` and `shoulder_rot` of
/// MoBL-ARMS, `sh_elev_r`, `sh_plane_elev_r` and `sh_axial_rot_r` (or `_l`) of OpenCap. A name such
/// as `shoulder_elv` has other meanings in other models, so elevation and plane must both be there.
class ColumnNames {
 public:
  /// Finds the columns `known` of a file. `given` are the names of `--columns`. `csv` must outlive
  /// this. Throws InputError at the header in these cases:
  ///
  /// - a name of `given` is not in the file, or the known name is there, too;
  /// - two names mean one known column.
  ColumnNames(const CsvReader& csv, std::vector<std::string_view> known,
              const std::vector<NamedColumn>& given);

  /// Returns the position of a known column; nothing if the file does not have it.
  [[nodiscard]] std::optional<std::size_t> Find(std::string_view known) const noexcept;
  /// Returns the position of a known column. Throws InputError if the file does not have it.
  [[nodiscard]] std::size_t Column(std::string_view known) const;
  /// Returns whether a column of the file is one of the known columns.
  [[nodiscard]] bool IsTaken(std::string_view in_file) const noexcept;
  /// Returns whether the user gives the name of a known column.
  [[nodiscard]] bool IsGiven(std::string_view known) const noexcept;

  /// The meaning of the numbers in the column of axial turns.
  [[nodiscard]] AxialMeaning axial() const noexcept { return axial_; }

  /// Returns `read 'shoulder_elv' as elevation_deg, 'elv_angle' as plane_deg`. Empty if every known
  /// column has its own name.
  [[nodiscard]] std::string Note() const;

  /// Throws InputError if the name of another column is nearly a known one (IsNearly), or has
  /// radians as its unit. Known columns that `--columns` names have no other names that are nearly
  /// theirs. `has_unit` and `is_radians` tell whether the unit is given, and whether it is radians.
  void ExpectNoneNearly(bool has_unit, bool is_radians) const;

 private:
  struct Taken {
    std::string_view known;
    std::size_t column;
    bool is_given;
  };

  void Take(std::string_view known, std::string_view in_file, bool is_given);
  void TakeGiven(const std::vector<NamedColumn>& given);
  void TakeSets();
  bool TakeIfFree(std::string_view known, std::string_view in_file);
  void TakeSingleNames();
  [[nodiscard]] const Taken* FindTaken(std::string_view known) const noexcept;
  [[nodiscard]] std::string RadiansMend(std::string_view meant, const std::string& in_file,
                                        bool has_unit, bool is_radians) const;

  const CsvReader& csv_;
  std::vector<std::string_view> known_;
  std::vector<Taken> taken_;
  AxialMeaning axial_ = AxialMeaning::kAsRead;
};

/// Returns the option that gives a name, such as `--columns axial_deg=humeral_rotation`, as a shell
/// reads it. A name with a comma cannot be given; the result then names the known column alone.
[[nodiscard]] std::string ColumnsOption(std::string_view known, std::string_view in_file);

}  // namespace girdle
