// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// The files of data/, read without the product's reader.
#pragma once

#include <array>
#include <cstddef>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/rhythm_table.h"

namespace girdle {

/// Fields of the rows after the header.
inline std::vector<std::vector<std::string>> ShippedRows(const std::string& file) {
  std::ifstream in(std::string(GIRDLE_SOURCE_DIR) + "/data/" + file);
  if (!in) throw std::runtime_error("data/" + file + " cannot be opened");
  std::vector<std::vector<std::string>> rows;
  bool header = true;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line.front() == '#') continue;
    if (!std::exchange(header, false)) {
      std::istringstream fields(line);
      rows.emplace_back();
      for (std::string field; std::getline(fields, field, ',');) rows.back().push_back(field);
    }
  }
  return rows;
}

/// One row of data/ludewig2009.csv.
struct MeasuredRow {
  double plane_deg = 0;
  double elevation_deg = 0;
  std::array<double, kCoordinateCount> angles_deg{};
  std::array<double, 3> scapulothoracic_deg{};
};

inline std::vector<MeasuredRow> MeasuredRows() {
  constexpr std::size_t kFirstAngle = 3;  // behind plane, elevation and origin
  std::vector<MeasuredRow> measured;
  for (const std::vector<std::string>& fields : ShippedRows("ludewig2009.csv")) {
    MeasuredRow row;
    row.plane_deg = std::stod(fields.at(0));
    row.elevation_deg = std::stod(fields.at(1));
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      row.angles_deg[k] = std::stod(fields.at(kFirstAngle + k));
    }
    for (std::size_t k = 0; k < 3; ++k) {
      row.scapulothoracic_deg[k] = std::stod(fields.at(kFirstAngle + kCoordinateCount + k));
    }
    measured.push_back(row);
  }
  return measured;
}

inline JointAngles Radians(const std::array<double, kCoordinateCount>& angles_deg) {
  JointAngles angles_rad{};
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    angles_rad[k] = RadiansFromDegrees(angles_deg[k]);
  }
  return angles_rad;
}

/// Grid of the rows, which stand plane by plane with the same elevations in each.
inline RhythmTable TableOf(const std::vector<MeasuredRow>& rows) {
  std::vector<double> planes_rad;
  std::vector<double> elevations_rad;
  std::vector<RhythmPosition> positions;
  for (const MeasuredRow& row : rows) {
    const double plane_rad = RadiansFromDegrees(row.plane_deg);
    if (planes_rad.empty() || planes_rad.back() != plane_rad) planes_rad.push_back(plane_rad);
    if (planes_rad.size() == 1) elevations_rad.push_back(RadiansFromDegrees(row.elevation_deg));
    RhythmPosition position;
    position.angles_rad = Radians(row.angles_deg);
    positions.push_back(position);
  }
  return {planes_rad, elevations_rad, positions};
}

/// data/joint_ranges.csv, in the order of kCoordinateNames.
inline JointRanges ShippedJointRanges() {
  JointRanges ranges{};
  const auto rows = ShippedRows("joint_ranges.csv");
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    if (rows.at(k).at(0) != kCoordinateNames.at(k)) {
      throw std::runtime_error("data/joint_ranges.csv has other rows than expected");
    }
    ranges[k] = {RadiansFromDegrees(std::stod(rows.at(k).at(1))),
                 RadiansFromDegrees(std::stod(rows.at(k).at(2)))};
  }
  return ranges;
}

/// data/landmarks.csv by name, each in the frame of its segment [m].
inline std::map<std::string, Vector3> ShippedLandmarks() {
  std::map<std::string, Vector3> landmarks_m;
  for (const std::vector<std::string>& fields : ShippedRows("landmarks.csv")) {
    landmarks_m[fields.at(0)] = {std::stod(fields.at(2)), std::stod(fields.at(3)),
                                 std::stod(fields.at(4))};
  }
  return landmarks_m;
}

}  // namespace girdle
