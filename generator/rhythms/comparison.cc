// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "rhythms/comparison.h"

#include <cmath>

#include "kinematics/worst_case.h"

namespace girdle {
namespace {

// The measured planes, and common elevations.
constexpr std::array<double, 3> kRatioPlanes_deg = {0, 40, 90};
constexpr std::array<double, 5> kRatioElevations_deg = {60, 90, 120, 150, 180};

// An arm this near to hanging or straight up has no plane. The value is above the rounding of typed
// degrees.
constexpr double kWithoutPlane_rad = 1e-9;

// Below this rate a scapula counts as still: far above rounding, far below any measurement.
constexpr double kStill_rad = 1e-9;

std::optional<double> PlaneOf(const ArmCommand& place) {
  return std::abs(std::sin(place.elevation_rad)) < kWithoutPlane_rad
             ? std::nullopt
             : std::optional(place.plane_rad);
}

Vector3 AnglesOf(const Quaternion& q_AB) { return EulerFromQuaternion(EulerSequence::kYXZ, q_AB); }

double UpwardRotation(const Quaternion& q_TS) { return -AnglesOf(q_TS).y; }

class Extremes {
 public:
  void Add(const Differences& differences, const MapPosition& position) {
    for (std::size_t k = 0; k < kDifferenceCount; ++k) {
      if (differences[k]) {
        extremes_[k].Add(*differences[k], position.elevation_rad, position.plane_rad);
      }
    }
  }

  [[nodiscard]] DifferenceSummaries Summaries() const {
    DifferenceSummaries summaries;
    for (std::size_t k = 0; k < kDifferenceCount; ++k) {
      if (const WorstCase<ArmCommand>& extreme = extremes_[k]; !extreme.empty()) {
        summaries[k] = {extreme.rms(), extreme.value(), extreme.place().elevation_rad,
                        PlaneOf(extreme.place())};
      }
    }
    return summaries;
  }

 private:
  std::array<WorstCase<ArmCommand>, kDifferenceCount> extremes_;
};

RhythmComparison CompareOne(const PublishedRhythm& rhythm,
                            const std::vector<MapPosition>& positions) {
  Extremes in_table;
  Extremes on_map;
  for (const MapPosition& position : positions) {
    const Differences differences = DifferencesAt(
        position, rhythm.girdle(position.elevation_rad, position.plane_rad), rhythm.defined);
    on_map.Add(differences, position);
    if (position.is_in_table) {
      in_table.Add(differences, position);
    }
  }
  return {rhythm, in_table.Summaries(), on_map.Summaries()};
}

// Returns the upward rotation of the measured rhythm [rad]; nothing if the rhythm clamps.
std::optional<double> MeasuredUpwardRotation(const ShoulderRhythm& measured, double elevation_rad,
                                             double plane_rad) {
  const ShoulderSolution solution = measured.Solve({elevation_rad, plane_rad, 0});
  if (solution.clamped) {
    return std::nullopt;
  }
  return UpwardRotation(solution.pose.q_TS());
}

RatioRow RatiosAt(const ShoulderRhythm& measured, const std::vector<PublishedRhythm>& published,
                  double elevation_rad, double plane_rad) {
  RatioRow row{plane_rad, elevation_rad, std::nullopt, {}};
  const double elevation_change_rad = elevation_rad - kRatioFrom_rad;
  const auto from_rad = MeasuredUpwardRotation(measured, kRatioFrom_rad, plane_rad);
  const auto to_rad = MeasuredUpwardRotation(measured, elevation_rad, plane_rad);
  if (from_rad && to_rad) {
    row.measured = ScapulohumeralRatio(elevation_change_rad, *to_rad - *from_rad);
  }
  for (const PublishedRhythm& rhythm : published) {
    row.published.push_back(ScapulohumeralRatio(
        elevation_change_rad, UpwardRotation(rhythm.girdle(elevation_rad, plane_rad).q_TS) -
                                  UpwardRotation(rhythm.girdle(kRatioFrom_rad, plane_rad).q_TS)));
  }
  return row;
}

}  // namespace

std::vector<MapPosition> PositionsOf(const ShoulderRhythm& measured, const ComparisonMap& map) {
  const std::vector<double>& elevations_rad = measured.table().elevations_rad();
  const std::vector<double>& planes_rad = measured.table().planes_rad();
  std::vector<MapPosition> positions;
  for (const double elevation_rad : map.elevations_rad) {
    for (const double plane_rad : map.planes_rad) {
      const ShoulderSolution solution = measured.Solve({elevation_rad, plane_rad, 0});
      if (!solution.clamped) {
        positions.push_back(
            {elevation_rad, plane_rad, solution.pose,
             elevation_rad >= elevations_rad.front() && elevation_rad <= elevations_rad.back() &&
                 plane_rad >= planes_rad.front() && plane_rad <= planes_rad.back()});
      }
    }
  }
  return positions;
}

Differences DifferencesAt(const MapPosition& position, const GirdlePose& girdle,
                          const DefinedAngles& defined) noexcept {
  const ShoulderPose& measured = position.measured;
  const ShoulderPose pose = WithHumerus(girdle, measured.q_TH());
  Differences differences;
  const auto set = [&differences](ComparedAngle which, double difference_rad) {
    differences[static_cast<std::size_t>(which)] = difference_rad;
  };
  if (defined.Clavicle()) {
    set(ComparedAngle::kSc, AngleBetween(pose.q_TC, measured.q_TC));
  }
  if (defined.Clavicle() && defined.Scapula()) {
    set(ComparedAngle::kAc, AngleBetween(pose.q_CS, measured.q_CS));
  }
  if (defined.Scapula()) {
    set(ComparedAngle::kGh, AngleBetween(pose.q_SH, measured.q_SH));
  }
  const Vector3 sc = AnglesOf(girdle.q_TC) - AnglesOf(measured.q_TC);
  const Vector3 st = AnglesOf(girdle.q_TS) - AnglesOf(measured.q_TS());
  const auto set_angle = [&defined, &set](std::size_t angle, ComparedAngle which,
                                          double difference_rad) {
    if (defined.angles[angle]) {
      set(which, std::remainder(difference_rad, 2 * kPi));
    }
  };
  set_angle(0, ComparedAngle::kProtraction, sc.x);
  set_angle(1, ComparedAngle::kClavicleElevation, sc.y);
  set_angle(3, ComparedAngle::kInternalRotation, st.x);
  set_angle(4, ComparedAngle::kUpwardRotation, st.y);
  set_angle(5, ComparedAngle::kTilt, st.z);
  return differences;
}

std::optional<double> ScapulohumeralRatio(double elevation_change_rad,
                                          double upward_rotation_change_rad) noexcept {
  if (std::abs(upward_rotation_change_rad) < kStill_rad) {
    return std::nullopt;
  }
  return (elevation_change_rad - upward_rotation_change_rad) / upward_rotation_change_rad;
}

Comparison Compare(const ShoulderRhythm& measured, const std::vector<PublishedRhythm>& published,
                   const ComparisonMap& map) {
  const std::vector<MapPosition> positions = PositionsOf(measured, map);
  Comparison comparison;
  comparison.options = measured.options();
  comparison.map = map;
  comparison.compared_on_map = positions.size();
  for (const MapPosition& position : positions) {
    comparison.compared_in_table += position.is_in_table ? 1 : 0;
  }
  comparison.table_from_elevation_rad = measured.table().elevations_rad().front();
  comparison.table_to_elevation_rad = measured.table().elevations_rad().back();
  comparison.table_from_plane_rad = measured.table().planes_rad().front();
  comparison.table_to_plane_rad = measured.table().planes_rad().back();
  for (const PublishedRhythm& rhythm : published) {
    comparison.rhythms.push_back(CompareOne(rhythm, positions));
  }
  for (const double plane_deg : kRatioPlanes_deg) {
    for (const double elevation_deg : kRatioElevations_deg) {
      comparison.ratios.push_back(RatiosAt(measured, published, RadiansFromDegrees(elevation_deg),
                                           RadiansFromDegrees(plane_deg)));
    }
  }
  return comparison;
}

}  // namespace girdle
