// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/solve_columns.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/gtc/quaternion.hpp>
#include <string>

#include "names/model_names.h"

namespace girdle {
namespace {

using Stems = std::vector<std::string>;

constexpr std::array<const char*, 3> kAxes = {"_x", "_y", "_z"};

// Returns the part of a rotation's name behind its stem.
std::string SinceText(const SolveOutput& output) { return output.since ? "_since_hanging" : ""; }

Stems AngleStems(const SolveOutput& output) {
  if (output.form != RotationForm::kAngles) {
    return {};
  }
  Stems stems = WrittenAngleNames();
  for (std::string& stem : stems) {
    stem += SinceText(output);
  }
  return stems;
}

constexpr std::array<const char*, 4> kQuaternionParts = {"_qw", "_qx", "_qy", "_qz"};
Stems QuaternionStems(const SolveOutput& output) {
  Stems stems;
  for (const std::string_view rotation : kWrittenRotationNames) {
    for (const char* const part : kQuaternionParts) {
      if (output.form == RotationForm::kQuaternions) {
        stems.push_back(std::string(rotation) + SinceText(output) + part);
      }
    }
  }
  return stems;
}

Cell QuaternionPart(const SolvedRow& row, std::size_t k) {
  const Quaternion& q = row.rotations[k / kQuaternionParts.size()];
  return std::array{q.w, q.x, q.y, q.z}[k % kQuaternionParts.size()];
}

// Each joint has three components of its rotation with elevation, and then three with plane.
constexpr std::size_t kRatesOfJoint = 2 * kAxes.size();
Stems RateStems(const SolveOutput& output) {
  Stems stems;
  for (const char* joint : {"sc", "ac", "gh"}) {
    for (const char* by : {"_w_elevation", "_w_plane"}) {
      for (const char* axis : kAxes) {
        if (output.derivatives) {
          stems.push_back(std::string(joint) + by + axis);
        }
      }
    }
  }
  return stems;
}

Stems PointStems(const SolveOutput& output) {
  Stems stems;
  if (output.points_of) {
    for (const ShoulderPoint& point : ShoulderPoints(*output.points_of, {})) {
      for (const char* axis : kAxes) {
        stems.push_back(point.name + axis);
      }
    }
  }
  return stems;
}

Cell Rate(const SolvedRow& row, std::size_t k) {
  const AngularRate& rate = row.rates->joints[k / kRatesOfJoint];
  const std::size_t component = k % kRatesOfJoint;
  const Vector3& w = component < kAxes.size() ? rate.by_elevation : rate.by_plane;
  return w[static_cast<int>(component % kAxes.size())];
}

// The columns in the order of the output. A further column is one more line here.
constexpr std::array<OutputColumns<SolvedRow, SolveOutput>, 11> kSolveColumns = {{
    {AngleStems, kDegrees,
     [](const SolvedRow& row, std::size_t k) -> Cell {
       return DegreesFromRadians(row.angles_rad[k]);
     }},
    {QuaternionStems, kNoUnit, QuaternionPart},
    {[](const SolveOutput&) { return Stems{std::string(kClampedStem)}; }, kNoUnit,
     [](const SolvedRow& row, std::size_t) -> Cell { return row.clamped ? 1.0 : 0.0; }},
    {[](const SolveOutput&) {
       return Stems{std::string(kUsedElevationStem), std::string(kUsedPlaneStem)};
     },
     kDegrees,
     [](const SolvedRow& row, std::size_t k) -> Cell {
       return DegreesFromRadians(k == 0 ? row.used.elevation_rad : row.used.plane_rad);
     }},
    {[](const SolveOutput&) { return Stems{std::string(kDistanceStem)}; }, kDegrees,
     [](const SolvedRow& row, std::size_t) -> Cell {
       return DegreesFromRadians(row.distance_rad);
     }},
    {[](const SolveOutput&) { return Stems{std::string(kOriginStem)}; }, kNoUnit,
     [](const SolvedRow& row, std::size_t) -> Cell { return Name(row.origin); }},
    {[](const SolveOutput& output) {
       return output.has_bridged ? Stems{std::string(kBridgedStem)} : Stems{};
     },
     kNoUnit, [](const SolvedRow& row, std::size_t) -> Cell { return row.bridged ? 1.0 : 0.0; }},
    {[](const SolveOutput&) {
       return Stems{kUsedAxialNames.begin(), kUsedAxialNames.end()};
     },
     kDegrees,
     [](const SolvedRow& row, std::size_t k) -> Cell {
       return DegreesFromRadians(k == 0 ? row.used.axial_rad : row.used_axial_isb_rad);
     }},
    {[](const SolveOutput&) {
       return Stems{kUsedOffsetNames.begin(), kUsedOffsetNames.end()};
     },
     kDegrees,
     [](const SolvedRow& row, std::size_t k) -> Cell {
       return DegreesFromRadians(k == 0 ? row.used.shrug_rad : row.used.protraction_rad);
     }},
    {RateStems, kNoUnit, Rate},
    {PointStems, kMillimeters,
     [](const SolvedRow& row, std::size_t k) -> Cell {
       return row.points[k / kAxes.size()].p_mm[static_cast<int>(k % kAxes.size())];
     }},
}};

Quaternion WithPositiveW(const Quaternion& q) noexcept { return q.w < 0 ? -q : q; }

}  // namespace

WrittenRotations RotationsOf(const ShoulderPose& pose,
                             const std::optional<ShoulderPose>& since) noexcept {
  WrittenRotations rotations = {pose.q_TC, pose.q_CS, pose.q_SH, pose.q_TS(), pose.q_TH()};
  if (since) {
    const WrittenRotations from = RotationsOf(*since, std::nullopt);
    for (std::size_t i = 0; i < rotations.size(); ++i) {
      rotations[i] = glm::conjugate(from[i]) * rotations[i];
    }
  }
  for (Quaternion& q : rotations) {
    q = WithPositiveW(q);
  }
  return rotations;
}

std::vector<std::string> WrittenAngleNames() {
  std::vector<std::string> names(kCoordinateNames.begin(), kCoordinateNames.end());
  names.insert(names.end(), kScapulothoracicNames.begin(), kScapulothoracicNames.end());
  return names;
}

WrittenAngles AnglesOf(const WrittenRotations& rotations) noexcept {
  const auto& [sc, ac, gh, st, ht] = rotations;
  return WithScapulothoracic(AnglesFromPose({sc, ac, gh}), st);
}

WrittenAngles WithScapulothoracic(const JointAngles& joints_rad, const Quaternion& q_TS) noexcept {
  const Vector3 st_rad = EulerFromQuaternion(EulerSequence::kYXZ, q_TS);
  WrittenAngles angles_rad{};
  std::ranges::copy(joints_rad, angles_rad.begin());
  std::ranges::copy(std::array{st_rad.x, st_rad.y, st_rad.z},
                    angles_rad.begin() + kCoordinateCount);
  return angles_rad;
}

WrittenColumns<SolvedRow, RoundedNumbers> SolveColumns(const SolveOutput& output,
                                                       const CsvDialect& dialect) {
  return {kSolveColumns, output, {output.digits, dialect.decimal_mark}, dialect.separator};
}

}  // namespace girdle
