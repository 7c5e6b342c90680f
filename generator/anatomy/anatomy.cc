// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "anatomy/anatomy.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "kinematics/lengths.h"
#include "text/csv.h"
#include "text/near_names.h"
#include "text/number_text.h"
#include "text/shown_text.h"

namespace girdle {
namespace {

// No point of a shoulder is farther from its segment's origin. Coordinates in millimetres are.
constexpr double kFarthestLandmark_m = 1;
constexpr double kHeaviestSegment_kg = 200;
constexpr double kLargestInertia_kg_m2 = 100;
// The clavicle and the coracoid process are only some centimeters apart.
constexpr double kLongestLigament_m = 0.2;
constexpr double kStiffestLigament_N_per_m = 1e7;

// Matches rows to a fixed list of names, each exactly once, in any order.
class NamedRows {
 public:
  NamedRows(CsvReader& csv, std::string_view key_column, std::vector<std::string_view> names)
      : csv_(csv), key_(csv.Column(key_column)), names_(std::move(names)), seen_(names_.size()) {}

  // Returns the index of the next row's name. Returns nothing at the end, and throws there if a
  // name is missing.
  std::optional<std::size_t> Next() {
    if (!csv_.Next()) {
      const auto missing = std::find(seen_.begin(), seen_.end(), false);
      if (missing != seen_.end()) {
        csv_.Fail("no row for " +
                  std::string(names_[static_cast<std::size_t>(missing - seen_.begin())]));
      }
      return std::nullopt;
    }
    const std::string_view key = csv_.Field(key_);
    const auto found = std::find(names_.begin(), names_.end(), key);
    if (found == names_.end()) {
      csv_.Fail("'" + ShortText(key) + "' is not known. " + DidYouMean(key, names_) +
                "Correct the name or remove the row");
    }
    const auto index = static_cast<std::size_t>(found - names_.begin());
    if (seen_[index]) {
      csv_.Fail("'" + std::string(key) + "' is given twice. Remove one of the rows");
    }
    seen_[index] = true;
    return index;
  }

 private:
  CsvReader& csv_;
  std::size_t key_;
  std::vector<std::string_view> names_;
  std::vector<bool> seen_;
};

// Reads three columns of the current row as a vector.
class VectorColumns {
 public:
  VectorColumns(const CsvReader& csv, const std::array<std::string_view, 3>& names)
      : csv_(csv), columns_{csv.Column(names[0]), csv.Column(names[1]), csv.Column(names[2])} {}

  [[nodiscard]] Vector3 Within(double lower, double upper) const {
    return {csv_.NumberWithin(columns_[0], lower, upper),
            csv_.NumberWithin(columns_[1], lower, upper),
            csv_.NumberWithin(columns_[2], lower, upper)};
  }
  [[nodiscard]] Vector3 Meters() const {
    const Vector3 position{csv_.Number(columns_[0]), csv_.Number(columns_[1]),
                           csv_.Number(columns_[2])};
    if (glm::length(position) > kFarthestLandmark_m) {
      csv_.Fail("a position more than 1 m from the origin. Give meters, not millimeters");
    }
    return position;
  }

 private:
  const CsvReader& csv_;
  std::array<std::size_t, 3> columns_;
};

double Positive(const CsvReader& csv, std::size_t column, double upper) {
  const double number = csv.NumberWithin(column, 0, upper);
  if (number == 0) {
    csv.Fail(csv.columns()[column] + " is 0, expected a positive number");
  }
  return number;
}

}  // namespace

void ReadLandmarks(std::istream& in, const std::string& name, Anatomy& anatomy) {
  CsvReader csv(in, name);
  csv.ExpectOnlyColumns({"landmark", "segment", "x_m", "y_m", "z_m"});
  std::vector<std::string_view> names;
  names.reserve(kLandmarkCount);
  for (const LandmarkDefinition& landmark : kLandmarks) {
    names.push_back(landmark.name);
  }
  NamedRows rows(csv, "landmark", names);
  const std::size_t segment_column = csv.Column("segment");
  const VectorColumns position(csv, {"x_m", "y_m", "z_m"});
  while (const std::optional<std::size_t> row = rows.Next()) {
    const std::string_view segment = Name(kLandmarks[*row].segment);
    if (csv.Field(segment_column) != segment) {
      csv.Fail(std::string(kLandmarks[*row].name) + " is given in the frame of '" +
               ShortText(csv.Field(segment_column)) + "', expected '" + std::string(segment) + "'");
    }
    anatomy.landmarks_m[*row] = position.Meters();
  }
}

void ReadSegments(std::istream& in, const std::string& name, Anatomy& anatomy) {
  CsvReader csv(in, name);
  csv.ExpectOnlyColumns({"segment", "mass_kg", "com_x_m", "com_y_m", "com_z_m", "ixx_kg_m2",
                         "iyy_kg_m2", "izz_kg_m2"});
  NamedRows rows(csv, "segment", {kSegmentNames.begin(), kSegmentNames.end()});
  const std::size_t mass = csv.Column("mass_kg");
  const VectorColumns center(csv, {"com_x_m", "com_y_m", "com_z_m"});
  const std::array<std::size_t, 3> moments = {csv.Column("ixx_kg_m2"), csv.Column("iyy_kg_m2"),
                                              csv.Column("izz_kg_m2")};
  while (const std::optional<std::size_t> row = rows.Next()) {
    const Vector3 inertia{Positive(csv, moments[0], kLargestInertia_kg_m2),
                          Positive(csv, moments[1], kLargestInertia_kg_m2),
                          Positive(csv, moments[2], kLargestInertia_kg_m2)};
    const double largest = std::max({inertia.x, inertia.y, inertia.z});
    if (2 * largest > inertia.x + inertia.y + inertia.z) {
      csv.Fail("the largest moment of inertia exceeds the sum of the other two, which no body has");
    }
    anatomy.segments[*row] = {Positive(csv, mass, kHeaviestSegment_kg), center.Meters(), inertia};
  }
}

void ReadJointRanges(std::istream& in, const std::string& name, Anatomy& anatomy) {
  CsvReader csv(in, name);
  csv.ExpectOnlyColumns({"coordinate", "lower_deg", "upper_deg"});
  std::vector<std::string_view> names(kCoordinateNames.begin(), kCoordinateNames.end());
  names.insert(names.end(), kScapulothoracicNames.begin(), kScapulothoracicNames.end());
  NamedRows rows(csv, "coordinate", names);
  const std::size_t lower_column = csv.Column("lower_deg");
  const std::size_t upper_column = csv.Column("upper_deg");
  while (const std::optional<std::size_t> row = rows.Next()) {
    const double lower = csv.NumberWithin(lower_column, -kHalfCircle_deg, kHalfCircle_deg);
    const double upper = csv.NumberWithin(upper_column, -kHalfCircle_deg, kHalfCircle_deg);
    if (lower >= upper) {
      csv.Fail("lower_deg is not below upper_deg");
    }
    CoordinateRange& range = *row < kCoordinateCount
                                 ? anatomy.ranges[*row]
                                 : anatomy.scapulothoracic_ranges[*row - kCoordinateCount];
    range = {RadiansFromDegrees(lower), RadiansFromDegrees(upper)};
  }
}

void ReadThoraxEllipsoids(std::istream& in, const std::string& name, Anatomy& anatomy) {
  CsvReader csv(in, name);
  csv.ExpectOnlyColumns({"ellipsoid", "center_x_m", "center_y_m", "center_z_m", "radius_x_m",
                         "radius_y_m", "radius_z_m"});
  const std::array<Ellipsoid*, 2> targets = {&anatomy.ribcage, &anatomy.gliding};
  NamedRows rows(csv, "ellipsoid", {"ribcage", "gliding"});
  const VectorColumns center(csv, {"center_x_m", "center_y_m", "center_z_m"});
  const std::array<std::size_t, 3> radii = {csv.Column("radius_x_m"), csv.Column("radius_y_m"),
                                            csv.Column("radius_z_m")};
  while (const std::optional<std::size_t> row = rows.Next()) {
    *targets[*row] = {
        center.Meters(),
        {Positive(csv, radii[0], kFarthestLandmark_m), Positive(csv, radii[1], kFarthestLandmark_m),
         Positive(csv, radii[2], kFarthestLandmark_m)}};
  }
}

void ReadLigaments(std::istream& in, const std::string& name, Anatomy& anatomy) {
  CsvReader csv(in, name);
  csv.ExpectOnlyColumns({"ligament", "clavicle_x_m", "clavicle_y_m", "clavicle_z_m", "scapula_x_m",
                         "scapula_y_m", "scapula_z_m", "slack_m", "stiffness_N_per_m",
                         "failure_elongation_m", "published_m", "published_sd_m"});
  NamedRows rows(csv, "ligament", {kLigamentNames.begin(), kLigamentNames.end()});
  const VectorColumns clavicle(csv, {"clavicle_x_m", "clavicle_y_m", "clavicle_z_m"});
  const VectorColumns scapula(csv, {"scapula_x_m", "scapula_y_m", "scapula_z_m"});
  const std::size_t slack = csv.Column("slack_m");
  const std::size_t stiffness = csv.Column("stiffness_N_per_m");
  const std::size_t failure = csv.Column("failure_elongation_m");
  const std::size_t published = csv.Column("published_m");
  const std::size_t published_sd = csv.Column("published_sd_m");
  while (const std::optional<std::size_t> row = rows.Next()) {
    anatomy.ligaments[*row] = {clavicle.Meters(),
                               scapula.Meters(),
                               Positive(csv, slack, kLongestLigament_m),
                               Positive(csv, stiffness, kStiffestLigament_N_per_m),
                               Positive(csv, failure, kLongestLigament_m),
                               Positive(csv, published, kLongestLigament_m),
                               Positive(csv, published_sd, kLongestLigament_m)};
  }
}

std::string LandmarksToCsv(const Anatomy& anatomy, const std::vector<std::string>& comments) {
  std::string text;
  for (const std::string& comment : comments) {
    text += comment + "\n";
  }
  text += "landmark,segment,x_m,y_m,z_m\n";
  for (std::size_t i = 0; i < kLandmarkCount; ++i) {
    text += kLandmarks[i].name;
    text += ",";
    text += Name(kLandmarks[i].segment);
    for (int axis = 0; axis < 3; ++axis) {
      text += ",";
      AppendNumber(text, anatomy.landmarks_m[i][axis]);
    }
    text += "\n";
  }
  return text;
}

std::string ThoraxEllipsoidsToCsv(const Anatomy& anatomy,
                                  const std::vector<std::string>& comments) {
  std::string text;
  for (const std::string& comment : comments) {
    text += comment + "\n";
  }
  text += "ellipsoid,center_x_m,center_y_m,center_z_m,radius_x_m,radius_y_m,radius_z_m\n";
  for (const auto& [name, ellipsoid] :
       {std::pair("ribcage", anatomy.ribcage), std::pair("gliding", anatomy.gliding)}) {
    text += name;
    for (const Vector3& vector : {ellipsoid.center_m, ellipsoid.radii_m}) {
      for (int i = 0; i < 3; ++i) {
        text += "," + RoundedText(vector[i], kLengthDecimals);
      }
    }
    text += "\n";
  }
  return text;
}

}  // namespace girdle
