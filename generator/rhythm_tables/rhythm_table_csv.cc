// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "rhythm_tables/rhythm_table_csv.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>
#include <vector>

#include "text/csv.h"
#include "text/input_error.h"
#include "text/number_text.h"
#include "text/shown_text.h"

namespace girdle {
namespace {

constexpr std::string_view kMeasured = "measured";
constexpr std::string_view kDerived = "sc_ac_derived";
constexpr std::array<std::string_view, 3> kScapulothoracicColumns = {
    "st_internal_rotation_deg", "st_upward_rotation_deg", "st_tilt_deg"};

std::string ColumnOf(std::string_view coordinate) { return std::string(coordinate) + "_deg"; }

// Returns the shortest decimals of an angle in degrees that read back as exactly the same radians.
// Degrees that were read from a text give that text.
std::string ExactDegreesText(double angle_rad) {
  const auto is_exact = [angle_rad](const std::string& text) {
    return RadiansFromDegrees(*FiniteNumber(text)) == angle_rad;
  };
  const double angle_deg = DegreesFromRadians(angle_rad);
  constexpr int kMostDigits = 17;
  for (int digits = 1; digits <= kMostDigits; ++digits) {
    std::string text = NumberText(*FiniteNumber(SignificantText(angle_deg, digits)));
    if (is_exact(text)) {
      return text;
    }
  }
  // The conversion to degrees may round to a neighbour of the number that was read.
  for (const double towards : {-kFullCircle_deg, kFullCircle_deg}) {
    std::string text = NumberText(std::nextafter(angle_deg, towards));
    if (is_exact(text)) {
      return text;
    }
  }
  return NumberText(angle_deg);
}

// Collects rows into a grid. Its messages name the row where the grid is broken.
class GridBuilder {
 public:
  void Add(const CsvReader& csv, double plane_deg, double elevation_deg, RhythmPosition position) {
    if (planes_deg_.empty() || plane_deg != planes_deg_.back()) {
      StartPlane(csv, plane_deg);
    } else if (elevation_deg == previous_elevation_deg_) {
      csv.Fail("plane " + NumberText(plane_deg) + " deg, elevation " + NumberText(elevation_deg) +
               " deg is given twice. Remove one of the rows");
    } else if (elevation_deg < previous_elevation_deg_) {
      csv.Fail("elevation " + NumberText(elevation_deg) + " deg does not increase (previous " +
               NumberText(previous_elevation_deg_) + ")");
    }
    if (planes_deg_.size() == 1) {
      elevations_deg_.push_back(elevation_deg);
    } else if (row_in_plane_ >= elevations_deg_.size() ||
               elevations_deg_[row_in_plane_] != elevation_deg) {
      csv.Fail("plane " + NumberText(plane_deg) + " deg has elevation " +
               NumberText(elevation_deg) + " deg where " +
               (row_in_plane_ < elevations_deg_.size()
                    ? NumberText(elevations_deg_[row_in_plane_]) + " deg"
                    : std::string("no further row")) +
               " is expected: every plane needs the elevations of plane " +
               NumberText(planes_deg_.front()) + " deg");
    }
    previous_elevation_deg_ = elevation_deg;
    ++row_in_plane_;
    positions_.push_back(position);
  }

  [[nodiscard]] RhythmTable Finish(const CsvReader& csv) {
    if (planes_deg_.empty()) {
      csv.Fail("the table has no rows");
    }
    CheckPlaneComplete(csv);
    try {
      return {Radians(planes_deg_), Radians(elevations_deg_), std::move(positions_)};
    } catch (const std::invalid_argument& error) {
      throw InputError(csv.name() + ": " + error.what());
    }
  }

 private:
  void StartPlane(const CsvReader& csv, double plane_deg) {
    if (!planes_deg_.empty()) {
      CheckPlaneComplete(csv);
      if (plane_deg < planes_deg_.back()) {
        csv.Fail("plane " + NumberText(plane_deg) + " deg does not increase (previous " +
                 NumberText(planes_deg_.back()) + ")");
      }
    }
    planes_deg_.push_back(plane_deg);
    row_in_plane_ = 0;
  }

  void CheckPlaneComplete(const CsvReader& csv) const {
    if (row_in_plane_ < elevations_deg_.size()) {
      csv.Fail("plane " + NumberText(planes_deg_.back()) + " deg ends without elevation " +
               NumberText(elevations_deg_[row_in_plane_]) + " deg: the grid has a hole");
    }
  }

  [[nodiscard]] static std::vector<double> Radians(std::vector<double> angles_deg) {
    for (double& angle : angles_deg) {
      angle = RadiansFromDegrees(angle);
    }
    return angles_deg;
  }

  std::vector<double> planes_deg_;
  std::vector<double> elevations_deg_;
  std::vector<RhythmPosition> positions_;
  double previous_elevation_deg_ = 0;
  std::size_t row_in_plane_ = 0;
};

struct ScapulothoracicColumns {
  std::array<std::size_t, 3> index;
};

// Returns the three columns, or nothing if none of them exists. Throws if only some exist.
std::optional<ScapulothoracicColumns> FindScapulothoracic(const CsvReader& csv) {
  const auto present =
      std::count_if(kScapulothoracicColumns.begin(), kScapulothoracicColumns.end(),
                    [&csv](std::string_view column) { return csv.HasColumn(column); });
  if (present == 0) {
    return std::nullopt;
  }
  return ScapulothoracicColumns{{csv.Column(kScapulothoracicColumns[0]),
                                 csv.Column(kScapulothoracicColumns[1]),
                                 csv.Column(kScapulothoracicColumns[2])}};
}

// Returns header and rows, with `separator` between them. `angle_text` writes the angles of a
// position.
template <typename AngleText>
std::string TableText(const RhythmTable& table, char separator, const AngleText& angle_text) {
  const bool has_scapulothoracic = table.position(0, 0).scapulothoracic_rad.has_value();
  std::string text = "plane_deg,elevation_deg,origin";
  for (const std::string_view name : kCoordinateNames) {
    text += "," + ColumnOf(name);
  }
  if (has_scapulothoracic) {
    for (const std::string_view column : kScapulothoracicColumns) {
      text += "," + std::string(column);
    }
  }
  const auto append_angle = [&](double angle_rad) { text += ',' + angle_text(angle_rad); };
  for (std::size_t plane = 0; plane < table.planes_rad().size(); ++plane) {
    for (std::size_t elevation = 0; elevation < table.elevations_rad().size(); ++elevation) {
      const RhythmPosition& position = table.position(plane, elevation);
      text += separator + ExactDegreesText(table.planes_rad()[plane]);
      text += ',' + ExactDegreesText(table.elevations_rad()[elevation]);
      text += ',';
      text += position.measured ? kMeasured : kDerived;
      for (const double angle_rad : position.angles_rad) {
        append_angle(angle_rad);
      }
      if (has_scapulothoracic) {
        const Vector3 st = *position.scapulothoracic_rad;
        append_angle(st.x);
        append_angle(st.y);
        append_angle(st.z);
      }
    }
  }
  return text;
}

}  // namespace

RhythmTable ReadRhythmTable(std::istream& in, const std::string& name) {
  CsvReader csv(in, name);
  const std::size_t plane_column = csv.Column("plane_deg");
  const std::size_t elevation_column = csv.Column("elevation_deg");
  std::vector<std::string> known = {"plane_deg", "elevation_deg", "origin"};
  std::array<std::size_t, kCoordinateCount> angle_columns{};
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    known.push_back(ColumnOf(kCoordinateNames[k]));
    angle_columns[k] = csv.Column(known.back());
  }
  known.insert(known.end(), kScapulothoracicColumns.begin(), kScapulothoracicColumns.end());
  csv.ExpectOnlyColumns({known.begin(), known.end()});
  const bool has_origin = csv.HasColumn("origin");
  const std::optional<ScapulothoracicColumns> scapulothoracic = FindScapulothoracic(csv);

  const auto angle_rad = [&csv](std::size_t column) {
    return RadiansFromDegrees(csv.NumberWithin(column, -kHalfCircle_deg, kHalfCircle_deg));
  };
  GridBuilder grid;
  while (csv.Next()) {
    RhythmPosition position;
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      position.angles_rad[k] = angle_rad(angle_columns[k]);
    }
    if (has_origin) {
      const std::string_view origin = csv.Field(csv.Column("origin"));
      if (origin != kMeasured && origin != kDerived) {
        csv.Fail("origin is '" + ShortText(origin) + "', expected " + std::string(kMeasured) +
                 " or " + std::string(kDerived));
      }
      position.measured = origin == kMeasured;
    }
    if (scapulothoracic) {
      position.scapulothoracic_rad =
          Vector3(angle_rad(scapulothoracic->index[0]), angle_rad(scapulothoracic->index[1]),
                  angle_rad(scapulothoracic->index[2]));
    }
    grid.Add(csv, csv.NumberWithin(plane_column, -kHalfCircle_deg, kHalfCircle_deg),
             csv.NumberWithin(elevation_column, 0, kHalfCircle_deg), position);
  }
  return grid.Finish(csv);
}

std::string RhythmTableToCsv(const RhythmTable& table, const std::vector<std::string>& comments,
                             int decimals) {
  std::string text;
  for (const std::string& comment : comments) {
    text += comment + '\n';
  }
  return text +
         TableText(table, '\n',
                   [decimals](double angle_rad) {
                     return RoundedText(DegreesFromRadians(angle_rad), decimals);
                   }) +
         '\n';
}

std::string RhythmTableToLine(const RhythmTable& table) {
  return TableText(table, ';', ExactDegreesText);
}

RhythmTable RhythmTableFromLine(std::string line, const std::string& name) {
  std::replace(line.begin(), line.end(), ';', '\n');
  std::istringstream in(line);
  return ReadRhythmTable(in, name);
}

}  // namespace girdle
