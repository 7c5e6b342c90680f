// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "kinematics/rhythm_table.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "kinematics/clamped.h"

namespace girdle {
namespace {

void CheckKnots(const char* name, const std::vector<double>& knots_rad) {
  if (knots_rad.size() < 2) {
    throw std::invalid_argument(std::string(name) + ": " + std::to_string(knots_rad.size()) +
                                " given, at least 2 are needed to interpolate");
  }
  for (std::size_t i = 0; i < knots_rad.size(); ++i) {
    if (!std::isfinite(knots_rad[i])) {
      throw std::invalid_argument(std::string(name) + "[" + std::to_string(i) + "] is not finite");
    }
    if (i > 0 && knots_rad[i] <= knots_rad[i - 1]) {
      throw std::invalid_argument(std::string(name) + "[" + std::to_string(i) +
                                  "] = " + std::to_string(DegreesFromRadians(knots_rad[i])) +
                                  " deg does not increase");
    }
  }
}

void CheckAngle(std::size_t position, std::string_view name, double angle_rad) {
  // Written so that a NaN fails too.
  if (!(std::abs(angle_rad) <= kPi)) {
    throw std::invalid_argument("position " + std::to_string(position) + ": " + std::string(name) +
                                " = " + std::to_string(DegreesFromRadians(angle_rad)) +
                                " deg is not within [-180, 180]");
  }
}

// Returns the index i with knot_i < value <= knot_i+1, equations (6) and (7). The lowest knot
// belongs to the first interval. Precondition: value lies within the knots.
std::size_t IntervalIndex(const std::vector<double>& knots, double value) noexcept {
  const auto upper = std::lower_bound(knots.begin() + 1, knots.end() - 1, value);
  return static_cast<std::size_t>(upper - knots.begin()) - 1;
}

// Returns the place within interval i, equations (8) and (9).
double IntervalWeight(const std::vector<double>& knots, std::size_t i, double value) noexcept {
  return (value - knots[i]) / (knots[i + 1] - knots[i]);
}

}  // namespace

RhythmTable::RhythmTable(std::vector<double> planes_rad, std::vector<double> elevations_rad,
                         std::vector<RhythmPosition> positions)
    : planes_rad_(std::move(planes_rad)),
      elevations_rad_(std::move(elevations_rad)),
      positions_(std::move(positions)) {
  CheckKnots("planes", planes_rad_);
  CheckKnots("elevations", elevations_rad_);
  const std::size_t expected = planes_rad_.size() * elevations_rad_.size();
  if (positions_.size() != expected) {
    throw std::invalid_argument("the grid needs " + std::to_string(expected) + " positions, " +
                                std::to_string(positions_.size()) + " given");
  }
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      CheckAngle(i, kCoordinateNames[k], positions_[i].angles_rad[k]);
    }
    if (positions_[i].scapulothoracic_rad.has_value() !=
        positions_.front().scapulothoracic_rad.has_value()) {
      throw std::invalid_argument("position " + std::to_string(i) +
                                  ": all positions have scapulothoracic angles, or none has");
    }
    if (positions_[i].scapulothoracic_rad) {
      for (int k = 0; k < 3; ++k) {
        CheckAngle(i, "scapulothoracic angle", (*positions_[i].scapulothoracic_rad)[k]);
      }
    }
  }
}

RhythmCell RhythmTable::CellAt(double elevation_rad, double plane_rad) const noexcept {
  const double elevation = Clamped(elevation_rad, elevations_rad_.front(), elevations_rad_.back());
  const double plane = Clamped(plane_rad, planes_rad_.front(), planes_rad_.back());
  const std::size_t i = IntervalIndex(elevations_rad_, elevation);
  const std::size_t j = IntervalIndex(planes_rad_, plane);
  return {i, j, IntervalWeight(elevations_rad_, i, elevation),
          IntervalWeight(planes_rad_, j, plane)};
}

}  // namespace girdle
