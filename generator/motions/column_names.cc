// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "motions/column_names.h"

#include <algorithm>
#include <array>
#include <utility>

#include "text/input_error.h"
#include "text/near_names.h"
#include "text/shown_text.h"
#include "text/small_letters.h"
#include "text/split.h"

namespace girdle {
namespace {

constexpr const char* kOption = "--columns";

// Coordinates of a model that have a meaning together. Signs and zeros are those of Girdle; times
// are in seconds.
struct CoordinateSet {
  std::string_view elevation;
  std::string_view plane;
  std::string_view axial;
  AxialMeaning meaning;
};
constexpr std::array<CoordinateSet, 3> kCoordinateSets = {{
    // OpenSim MoBL-ARMS and MyoArm (Saul et al. 2015): Y(plane) X(-elevation) Y(-plane) Y(rot)
    {"shoulder_elv", "elv_angle", "shoulder_rot", AxialMeaning::kIsbWithPlane},
    // OpenCap: Y(plane) X(-elevation) Y(rot); the left has the signs of the right
    {"sh_elev_r", "sh_plane_elev_r", "sh_axial_rot_r", AxialMeaning::kIsb},
    {"sh_elev_l", "sh_plane_elev_l", "sh_axial_rot_l", AxialMeaning::kIsb},
}};
constexpr std::string_view kTimeOfSets = "time";

// Names that have one meaning, sign and unit.
constexpr std::array<std::pair<std::string_view, std::string_view>, 12> kSingleNames = {{
    {"humeral_elevation_deg", kElevationColumn},
    {"humerothoracic_elevation_deg", kElevationColumn},
    {"thoracohumeral_elevation_deg", kElevationColumn},
    {"plane_of_elevation_deg", kPlaneColumn},
    {"humeral_plane_of_elevation_deg", kPlaneColumn},
    {"humerothoracic_plane_of_elevation_deg", kPlaneColumn},
    {"thoracohumeral_plane_of_elevation_deg", kPlaneColumn},
    {"time_sec", kTimeColumn},
    {"time_seconds", kTimeColumn},
    {"Time (s)", kTimeColumn},
    {"Time [s]", kTimeColumn},
    {"Time_s", kTimeColumn},
}};

bool IsInRadians(const std::string& column) {
  const std::string small = InSmallLetters(column);
  return small.find("rad") != std::string::npos && small.find("radi") != 0;
}

}  // namespace

std::vector<NamedColumn> ReadNamedColumns(std::string_view text,
                                          std::span<const std::string_view> known) {
  std::vector<NamedColumn> columns;
  for (const std::string& part : Split(text, ",")) {
    const std::size_t equals = part.find('=');
    NamedColumn column = {
        std::string(WithoutBlanks(std::string_view(part).substr(0, equals))),
        equals == std::string::npos
            ? std::string()
            : std::string(WithoutBlanks(std::string_view(part).substr(equals + 1)))};
    if (column.known.empty() || column.in_file.empty()) {
      throw InputError(std::string(kOption) + " '" + ShortText(text) + "': '" + ShortText(part) +
                       "' does not name a column. Give pairs with commas between, such as "
                       "--columns elevation_deg=shoulder_elv,plane_deg=elv_angle");
    }
    if (std::find(known.begin(), known.end(), column.known) == known.end()) {
      throw InputError(std::string(kOption) + " " + ShortText(part) + ": '" +
                       ShortText(column.known) + "' is not known. " +
                       DidYouMean(column.known, known) +
                       "Before = stands one of: " + Joined(known));
    }
    for (const NamedColumn& earlier : columns) {
      if (earlier.known == column.known || earlier.in_file == column.in_file) {
        throw InputError(std::string(kOption) + " " + ShortText(part) + ": '" +
                         ShortText(earlier.known == column.known ? column.known : column.in_file) +
                         "' is given twice. Remove one");
      }
    }
    columns.push_back(std::move(column));
  }
  return columns;
}

std::string ColumnsOption(std::string_view known, std::string_view in_file) {
  constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-.";
  const std::string option = std::string(kOption) + " ";
  if (in_file.find_first_of(",'") != std::string_view::npos) {
    return option + std::string(known) + "=NAME";
  }
  const std::string pair = std::string(known) + "=" + ShortText(in_file);
  return in_file.find_first_not_of(kPlain) == std::string_view::npos ? option + pair
                                                                     : option + "'" + pair + "'";
}

ColumnNames::ColumnNames(const CsvReader& csv, std::vector<std::string_view> known,
                         const std::vector<NamedColumn>& given)
    : csv_(csv), known_(std::move(known)) {
  TakeGiven(given);
  for (const std::string_view name : known_) {
    if (!IsGiven(name) && csv_.HasColumn(name)) {
      Take(name, name, false);
    }
  }
  TakeSets();
  TakeSingleNames();
}

void ColumnNames::Take(std::string_view known, std::string_view in_file, bool is_given) {
  const Taken* const earlier = FindTaken(known);
  if (earlier != nullptr) {
    const std::string& first = csv_.columns()[earlier->column];
    csv_.Fail("the columns '" + ShortText(first) + "' and '" + ShortText(in_file) + "' both mean " +
              std::string(known) + ". Choose one with " + ColumnsOption(known, first));
  }
  taken_.push_back({known, csv_.Column(in_file), is_given});
}

void ColumnNames::TakeGiven(const std::vector<NamedColumn>& given) {
  for (const NamedColumn& column : given) {
    const auto known = std::find(known_.begin(), known_.end(), column.known);
    if (known == known_.end()) {
      csv_.Fail(std::string(kOption) + ": '" + column.known + "' is not read here. Omit it");
    }
    if (!csv_.HasColumn(column.in_file)) {
      const std::vector<std::string_view> names(csv_.columns().begin(), csv_.columns().end());
      csv_.Fail(ColumnsOption(column.known, column.in_file) + ": there is no column '" +
                ShortText(column.in_file) + "'. " + DidYouMean(column.in_file, names) +
                "The header has: " + ShortText(Joined(names), kMostShownOfHeader));
    }
    if (column.known != column.in_file && csv_.HasColumn(column.known)) {
      csv_.Fail(ColumnsOption(column.known, column.in_file) + ": the column '" + column.known +
                "' is there, too. Rename it, or omit this name");
    }
    Take(*known, column.in_file, true);
  }
}

void ColumnNames::TakeSets() {
  const auto has_own_name = [this](std::string_view known) {
    const Taken* const taken = FindTaken(known);
    return taken != nullptr && csv_.columns()[taken->column] == known;
  };
  if (has_own_name(kElevationColumn) || has_own_name(kPlaneColumn)) {
    return;
  }
  const CoordinateSet* found = nullptr;
  for (const CoordinateSet& set : kCoordinateSets) {
    // A name that the user gives for another column leaves the set incomplete.
    if (!csv_.HasColumn(set.elevation) || !csv_.HasColumn(set.plane) ||
        IsGiven(kElevationColumn) != IsTaken(set.elevation) ||
        IsGiven(kPlaneColumn) != IsTaken(set.plane)) {
      continue;
    }
    if (found != nullptr) {
      csv_.Fail("the columns '" + std::string(found->elevation) + "' and '" +
                std::string(set.elevation) + "' both mean elevation_deg. Choose one arm with " +
                ColumnsOption(kElevationColumn, found->elevation) + "," + kPlaneColumn + "=" +
                std::string(found->plane));
    }
    found = &set;
  }
  if (found == nullptr) {
    return;
  }
  TakeIfFree(kElevationColumn, found->elevation);
  TakeIfFree(kPlaneColumn, found->plane);
  TakeIfFree(kTimeColumn, kTimeOfSets);
  if (TakeIfFree(kAxialColumn, found->axial)) {
    axial_ = found->meaning;
  }
}

bool ColumnNames::TakeIfFree(std::string_view known, std::string_view in_file) {
  if (std::find(known_.begin(), known_.end(), known) == known_.end() ||
      FindTaken(known) != nullptr || !csv_.HasColumn(in_file)) {
    return false;
  }
  Take(known, in_file, false);
  return true;
}

void ColumnNames::TakeSingleNames() {
  const std::vector<Taken> before = taken_;
  const auto is_taken_before = [&before](std::string_view known) {
    return std::any_of(before.begin(), before.end(),
                       [known](const Taken& taken) { return taken.known == known; });
  };
  for (const auto& [in_file, known] : kSingleNames) {
    const auto of_file = std::find(known_.begin(), known_.end(), known);
    if (of_file != known_.end() && csv_.HasColumn(in_file) && !is_taken_before(known)) {
      Take(*of_file, in_file, false);
    }
  }
}

const ColumnNames::Taken* ColumnNames::FindTaken(std::string_view known) const noexcept {
  const auto found = std::find_if(taken_.begin(), taken_.end(),
                                  [known](const Taken& taken) { return taken.known == known; });
  return found == taken_.end() ? nullptr : &*found;
}

std::optional<std::size_t> ColumnNames::Find(std::string_view known) const noexcept {
  const Taken* const taken = FindTaken(known);
  return taken == nullptr ? std::nullopt : std::optional(taken->column);
}

std::size_t ColumnNames::Column(std::string_view known) const {
  const std::optional<std::size_t> found = Find(known);
  if (!found) {
    csv_.Fail("column '" + std::string(known) + "' is missing. If it has another name, give " +
              ColumnsOption(known, "NAME") +
              ". The header has: " + ShortText(Joined(csv_.columns()), kMostShownOfHeader));
  }
  return *found;
}

bool ColumnNames::IsTaken(std::string_view in_file) const noexcept {
  return std::any_of(taken_.begin(), taken_.end(),
                     [&](const Taken& taken) { return csv_.columns()[taken.column] == in_file; });
}

bool ColumnNames::IsGiven(std::string_view known) const noexcept {
  const Taken* const taken = FindTaken(known);
  return taken != nullptr && taken->is_given;
}

std::string ColumnNames::Note() const {
  std::string text;
  for (const Taken& taken : taken_) {
    const std::string& in_file = csv_.columns()[taken.column];
    if (in_file == taken.known) {
      continue;
    }
    text +=
        (text.empty() ? "read '" : ", '") + ShortText(in_file) + "' as " + std::string(taken.known);
    if (taken.known == kAxialColumn && axial_ == AxialMeaning::kIsbWithPlane) {
      text += " + plane_deg from isb";
    } else if (taken.known == kAxialColumn && axial_ == AxialMeaning::kIsb) {
      text += " from isb";
    }
  }
  return text;
}

// Returns the fix for a known name with radians as its unit: only an option gives the unit.
std::string ColumnNames::RadiansMend(std::string_view meant, const std::string& in_file,
                                     bool has_unit, bool is_radians) const {
  const bool has_degrees = std::any_of(known_.begin(), known_.end(), [this](std::string_view name) {
    return name.ends_with("_deg") && csv_.HasColumn(name);
  });
  const std::string name = "Name it '" + std::string(meant) + "' or give " +
                           ColumnsOption(meant, in_file) + ", whatever the unit";
  if (is_radians) {
    return name + (has_degrees ? ", if all angles of the file are in radians" : "");
  }
  return has_degrees || has_unit
             ? "All angles of a file have one unit: write these in degrees, too, as '" +
                   std::string(meant) + "', or all in radians with --angles rad"
             : name + ", and give --angles rad";
}

void ColumnNames::ExpectNoneNearly(bool has_unit, bool is_radians) const {
  for (const std::string& column : csv_.columns()) {
    if (IsTaken(column)) {
      continue;
    }
    const auto is_meant = [&](std::string_view known, bool in_radians) {
      return !IsGiven(known) &&
             (in_radians ? known.ends_with("_deg") && PlainStem(known) == PlainStem(column)
                         : IsNearly(column, known));
    };
    for (const bool in_radians : {true, false}) {
      const auto meant = std::find_if(known_.begin(), known_.end(), [&](std::string_view known) {
        return is_meant(known, in_radians);
      });
      if (meant == known_.end() || (in_radians && !IsInRadians(column))) {
        continue;
      }
      const std::string shown = "column '" + ShortText(column) + "' is not known. ";
      if (in_radians) {
        csv_.Fail(shown +
                  (csv_.HasColumn(*meant)
                       ? "'" + std::string(*meant) + "' is there, too: leave one of them out"
                       : RadiansMend(*meant, column, has_unit, is_radians)));
      }
      csv_.Fail(shown + "Did you mean '" + std::string(*meant) + "'? Correct its name" +
                (Find(*meant) ? "" : " or give " + ColumnsOption(*meant, column)) +
                ". If it is something else, give it a name that is less alike");
    }
  }
}

}  // namespace girdle
