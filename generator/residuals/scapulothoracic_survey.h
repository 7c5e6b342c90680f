// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// Differences between the shoulder girdle of any model and the measured rhythm.
///
/// The arm is moved over a grid of directions. At each, clavicle and scapula are compared with the
/// measured ones for the direction that the simulated humerus has reached, which may differ from
/// the commanded one. Differences are model minus measured, with the signs of the measured angles:
/// upward rotation and elevation of the clavicle are negative.
///
/// Absolute angles depend on the choice of bony points as landmarks. The change since elevation 30
/// does not depend on them, except through the thorax frame: the rotation of the model's scapula
/// since the lowest position of its plane is applied to the measured scapula at that position.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "anatomy/anatomy.h"
#include "kinematics/shoulder_rhythm.h"
#include "kinematics/words.h"
#include "residuals/residual.h"
#include "residuals/residual_report.h"
#include "simulation/mapped_arm.h"
#include "simulation/mapped_shoulder.h"
#include "text/sinks.h"

namespace girdle {

/// Figures that are compared [deg]. Angles between two directions or two rotations are never
/// negative.
enum class GirdleFigure {
  kClavicleAxis,  ///< angle between the long axes
  kProtraction,
  kClavicleElevation,
  kClavicleRotation,  ///< only if the mapping gives the clavicle's body
  kScapula,           ///< angle of the rotation between the two scapulae
  kInternalRotation,
  kUpwardRotation,
  kTilt,
};
inline constexpr std::size_t kGirdleFigureCount = 8;
inline constexpr std::array<std::string_view, kGirdleFigureCount> kGirdleFigureNames = {
    "clavicle axis",           "clavicle protraction", "clavicle elevation",
    "clavicle rotation",       "scapula orientation",  "scapula internal rotation",
    "scapula upward rotation", "scapula tilt",
};
constexpr const auto& WordsOf(GirdleFigure /*which*/) noexcept { return kGirdleFigureNames; }
/// Values in the order of GirdleFigure; nothing if the mapping does not give the bone.
using GirdleFigures = std::array<std::optional<double>, kGirdleFigureCount>;

/// An arm is beyond the table if its direction is farther than this [rad] from the table's
/// directions. Arms that are commanded to the table's edge miss it by some degrees.
inline constexpr double kNearTable_rad = 5 * kRadiansPerDegree;

/// One position of the grid.
struct SurveyedPosition {
  double elevation_rad = 0;
  double plane_rad = 0;
  std::string not_reached;  ///< the reason; empty if the position was reached
  ArmAngles reached{};
  bool is_in_table = false;   ///< whether `reached` is within kNearTable_rad of the table
  GirdleFigures model_deg{};  ///< the angles; nothing for axis and orientation
  GirdleFigures measured_deg{};
  GirdleFigures difference_deg{};
  /// Differences of the change since the lowest position of this plane in the table.
  GirdleFigures change_difference_deg{};
  /// Distances of kGlidingLandmarks from the ellipsoid, positive outside.
  std::array<std::optional<double>, kGlidingLandmarks.size()> border_mm{};
  MappedPose pose;
  Quaternion measured_q_TS{1, 0, 0, 0};
};

/// The directions of the grid [deg].
struct SurveyGrid {
  std::vector<double> elevations_deg;
  std::vector<double> planes_deg;
};

struct ScapulothoracicSurvey {
  std::vector<SurveyedPosition> positions;  ///< plane by plane
  ResidualReport report;
  std::string sentence;  ///< the conclusion that the figures support
};

/// Surveys a model. TS and AI should glide on `ellipsoid`. Throws InputError if the bones cannot be
/// those of a shoulder, or if no position is reached.
[[nodiscard]] ScapulothoracicSurvey SurveyGirdle(MappedArm& arm, const MappedShoulder& shoulder,
                                                 const ShoulderRhythm& rhythm,
                                                 const Ellipsoid& ellipsoid, const SurveyGrid& grid,
                                                 const ProgressSink& progress);

/// Returns the survey in a form. Text has the report and its sentence; JSON also has every
/// position. The summary has a table of the differences between the bones and the measured ones.
[[nodiscard]] std::string SurveyIn(const ReportChoice& choice, const ScapulothoracicSurvey& survey);

}  // namespace girdle
