// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

/// How far the girdle of any model is from the measured rhythm.
///
/// The arm is moved over a grid of directions. At each, clavicle and scapula are held against the
/// measured ones for the direction that the simulated humerus has reached, whatever was asked of
/// it. Differences are model minus measured, with the signs of the measured angles: upward rotation
/// and a raised clavicle are negative.
///
/// Absolute angles depend on which points of the bones were taken for landmarks. The change since
/// elevation 30 does not, but for the thorax's frame: the turn of the model's scapula since the
/// lowest position of its plane is put on the measured scapula there.
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

/// What is compared, in degrees. Those that are angles between two directions or rotations are
/// never negative.
enum class GirdleFigure {
  kClavicleAxis,  ///< angle between the long axes
  kProtraction,
  kClavicleElevation,
  kClavicleRotation,  ///< only of a clavicle that is mapped by its body
  kScapula,           ///< angle of the rotation between the two
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
/// In the order of GirdleFigure; nothing where the mapping does not tell.
using GirdleFigures = std::array<std::optional<double>, kGirdleFigureCount>;

/// Farther from the table's directions than this [rad] an arm is beyond the table. Arms that are
/// asked for an edge of it miss it by some degrees.
inline constexpr double kNearTable_rad = 5 * kRadiansPerDegree;

/// One position of the grid.
struct SurveyedPosition {
  double asked_elevation_rad = 0;
  double asked_plane_rad = 0;
  std::string not_reached;  ///< why; empty where the rest is said
  ArmAngles reached{};
  bool is_in_table = false;   ///< no farther than kNearTable_rad from it
  GirdleFigures model_deg{};  ///< angles themselves; nothing for axis and orientation
  GirdleFigures measured_deg{};
  GirdleFigures difference_deg{};
  /// The same of the change since the lowest position in the table of this plane.
  GirdleFigures change_difference_deg{};
  /// Of kGlidingLandmarks from the ellipsoid, outside +.
  std::array<std::optional<double>, kGlidingLandmarks.size()> border_mm{};
  MappedPose pose;
  Quaternion measured_q_TS{1, 0, 0, 0};
};

/// What of the grid is asked for [deg].
struct SurveyGrid {
  std::vector<double> elevations_deg;
  std::vector<double> planes_deg;
};

struct ScapulothoracicSurvey {
  std::vector<SurveyedPosition> positions;  ///< plane by plane
  ResidualReport report;
  std::string sentence;  ///< what the figures allow to say
};

/// Surveys a model. `ellipsoid` is what TS and AI should glide on. Throws InputError if the bones
/// cannot be those of a shoulder, or no position at all is reached.
[[nodiscard]] ScapulothoracicSurvey SurveyGirdle(MappedArm& arm, const MappedShoulder& shoulder,
                                                 const ShoulderRhythm& rhythm,
                                                 const Ellipsoid& ellipsoid, const SurveyGrid& grid,
                                                 const ProgressSink& progress);

/// Returns the survey in a form: the report and its sentence as text, and as JSON also every
/// position. The summary has a table of how far the bones are from the measured ones.
[[nodiscard]] std::string SurveyIn(const ReportChoice& choice, const ScapulothoracicSurvey& survey);

}  // namespace girdle
