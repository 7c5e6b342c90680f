// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "residuals/scapulothoracic_survey.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <nlohmann/json.hpp>

#include "anatomy/ellipsoid.h"
#include "kinematics/lengths.h"
#include "kinematics/worst_case.h"
#include "residuals/report_parts.h"
#include "residuals/report_summary.h"
#include "residuals/residual_report.h"
#include "text/input_error.h"
#include "text/json_text.h"
#include "text/number_text.h"
#include "text/text_columns.h"

namespace girdle {
namespace {

// Lowest elevation at which SC and AC were measured.
constexpr double kLowestMeasured_deg = 30;
// Residual of couplings after Newton's method (mapped_arm.cc).
constexpr double kCouplingTolerance = 1e-9;
// Landmarks of one bone keep their distances. PAC may be on the clavicle, and a soft AC joint opens
// by a tenth of a millimeter.
constexpr double kRigid_mm = 1;
// Directions count as equal within the error of a servo at rest.
constexpr double kSameDirection_rad = 0.01 * kRadiansPerDegree;

std::size_t Index(GirdleFigure figure) { return static_cast<std::size_t>(figure); }

double AngleDifference_deg(double a_deg, double b_deg) {
  return std::remainder(a_deg - b_deg, 360);
}

double AngleBetweenAxes_deg(const Vector3& a, const Vector3& b) {
  return DegreesFromRadians(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

// Returns the long axis of a clavicle: z of Y(protraction) X(elevation).
Vector3 ClavicleAxisOf(double protraction_deg, double elevation_deg) {
  return QuaternionFromEuler(EulerSequence::kYXZ, {RadiansFromDegrees(protraction_deg),
                                                   RadiansFromDegrees(elevation_deg), 0}) *
         Vector3(0, 0, 1);
}

void PutScapula(const Quaternion& q_TS, GirdleFigures& figures_deg) {
  const Vector3 angles_rad = EulerFromQuaternion(EulerSequence::kYXZ, q_TS);
  figures_deg[Index(GirdleFigure::kInternalRotation)] = DegreesFromRadians(angles_rad[0]);
  figures_deg[Index(GirdleFigure::kUpwardRotation)] = DegreesFromRadians(angles_rad[1]);
  figures_deg[Index(GirdleFigure::kTilt)] = DegreesFromRadians(angles_rad[2]);
}

GirdleFigures ModelFigures(const MappedPose& pose) {
  GirdleFigures figures_deg;
  PutScapula(pose.q_TS, figures_deg);
  if (pose.clavicle_axis_T) {
    const Vector3& axis = *pose.clavicle_axis_T;
    figures_deg[Index(GirdleFigure::kProtraction)] = DegreesFromRadians(std::atan2(axis.x, axis.z));
    figures_deg[Index(GirdleFigure::kClavicleElevation)] =
        DegreesFromRadians(std::atan2(-axis.y, std::hypot(axis.x, axis.z)));
  }
  if (pose.q_TC) {
    figures_deg[Index(GirdleFigure::kClavicleRotation)] =
        DegreesFromRadians(EulerFromQuaternion(EulerSequence::kYXZ, *pose.q_TC)[2]);
  }
  return figures_deg;
}

GirdleFigures MeasuredFigures(const ShoulderPose& measured) {
  MappedPose pose;
  pose.q_TS = measured.q_TS();
  pose.q_TC = measured.q_TC;
  pose.clavicle_axis_T = measured.q_TC * Vector3(0, 0, 1);
  return ModelFigures(pose);
}

// Returns differences of the angles, and the angles between axes and between orientations.
GirdleFigures Differences(const GirdleFigures& model_deg, const Quaternion& q_TS,
                          const GirdleFigures& measured_deg, const Quaternion& measured_q_TS) {
  GirdleFigures difference_deg;
  for (std::size_t i = 0; i < kGirdleFigureCount; ++i) {
    if (model_deg[i] && measured_deg[i]) {
      difference_deg[i] = AngleDifference_deg(*model_deg[i], *measured_deg[i]);
    }
  }
  difference_deg[Index(GirdleFigure::kScapula)] =
      DegreesFromRadians(AngleBetween(q_TS, measured_q_TS));
  const auto axis = [](const GirdleFigures& figures_deg) {
    return ClavicleAxisOf(*figures_deg[Index(GirdleFigure::kProtraction)],
                          *figures_deg[Index(GirdleFigure::kClavicleElevation)]);
  };
  if (model_deg[Index(GirdleFigure::kProtraction)]) {
    difference_deg[Index(GirdleFigure::kClavicleAxis)] =
        AngleBetweenAxes_deg(axis(model_deg), axis(measured_deg));
  }
  return difference_deg;
}

// Returns differences of the change since `start`. The model's rotation of the scapula since then
// is applied to the measured scapula, q = (q_TS q_TS0^-1) m_TS0. For the clavicle, the change of
// its angles is compared.
GirdleFigures ChangeDifferences(const SurveyedPosition& start, const SurveyedPosition& position) {
  const Quaternion q_TS =
      position.pose.q_TS * glm::conjugate(start.pose.q_TS) * start.measured_q_TS;
  GirdleFigures model_deg;
  PutScapula(q_TS, model_deg);
  for (const GirdleFigure figure : {GirdleFigure::kProtraction, GirdleFigure::kClavicleElevation,
                                    GirdleFigure::kClavicleRotation}) {
    const std::size_t i = Index(figure);
    if (position.model_deg[i]) {
      model_deg[i] = *start.measured_deg[i] + *position.model_deg[i] - *start.model_deg[i];
    }
  }
  return Differences(model_deg, q_TS, position.measured_deg, position.measured_q_TS);
}

// Whether the direction of the measured rhythm's answer differs from the arm's by more than the
// error of a servo at rest.
bool IsFar(const ArmCommand& used, const ArmAngles& reached) {
  return std::abs(used.elevation_rad - reached.elevation_rad) > kSameDirection_rad ||
         std::abs(std::remainder(used.plane_rad - reached.plane_rad, 2 * kPi)) > kSameDirection_rad;
}

ArmCommand CommandOf(const SurveyedPosition& position) {
  return {position.elevation_rad, position.plane_rad};
}

std::string PlaceText(const ArmCommand& command) {
  return "elevation " + RoundedText(DegreesFromRadians(command.elevation_rad), 1) + ", plane " +
         RoundedText(DegreesFromRadians(command.plane_rad), 1);
}

// Worst case over positions, with the commanded direction.
using Spread = WorstCase<ArmCommand>;

// How the items of a Spread's two lines end.
constexpr const char* kRms = ", rms";
constexpr const char* kLargest = ", largest";

void AppendTo(std::vector<Residual>& lines, const Spread& spread, const std::string& group,
              const std::string& item, const std::string& unit) {
  if (spread.empty()) {
    return;
  }
  lines.push_back(
      {group, item + kRms, spread.rms(), unit, std::nullopt, CountText(spread.count(), "value")});
  lines.push_back(
      {group, item + kLargest, spread.value(), unit, std::nullopt, PlaceText(spread.place())});
}

struct GroupSpreads {
  std::array<Spread, kGirdleFigureCount> figures;
  Spread border;

  void AppendTo(std::vector<Residual>& lines, const std::string& group) const {
    for (std::size_t i = 0; i < kGirdleFigureCount; ++i) {
      girdle::AppendTo(lines, figures[i], group, std::string(kGirdleFigureNames[i]), "deg");
    }
    girdle::AppendTo(lines, border, group, "TS, AI to ellipsoid", "mm");
  }
};

class Surveyor {
 public:
  Surveyor(MappedArm& arm, const MappedShoulder& shoulder, const ShoulderRhythm& rhythm,
           const Ellipsoid& ellipsoid)
      : arm_(arm), shoulder_(shoulder), rhythm_(rhythm), ellipsoid_(ellipsoid) {}

  SurveyedPosition Visit(double elevation_deg, double plane_deg) {
    SurveyedPosition position;
    position.elevation_rad = RadiansFromDegrees(elevation_deg);
    position.plane_rad = RadiansFromDegrees(plane_deg);
    // The rotation about the humerus's long axis is the measured one.
    const ArmAngles own = ArmAnglesFromRotation(
        rhythm_.SolvePose({position.elevation_rad, position.plane_rad}).q_TH());
    const ArmMove move = arm_.Move({position.elevation_rad, position.plane_rad, own.axial_rad});
    if (!move.reached) {
      position.not_reached = move.reason;
      return position;
    }
    if (bone_lengths_m_.empty()) {
      shoulder_.ExpectSound(arm_.data());
    }
    position.pose = shoulder_.Observe(arm_.data());
    position.reached = ArmAnglesFromRotation(position.pose.q_TH);
    const ShoulderSolution measured =
        rhythm_.Solve({position.reached.elevation_rad, position.reached.plane_rad});
    if (IsFar(measured.used, position.reached)) {
      position.not_reached = "the arm goes to elevation " +
                             RoundedText(DegreesFromRadians(position.reached.elevation_rad), 1) +
                             ", plane " +
                             RoundedText(DegreesFromRadians(position.reached.plane_rad), 1) +
                             ", which the measured rhythm does not reach";
      return position;
    }
    coupling_.Add(move.coupling, CommandOf(position));
    speed_.Add(move.speed_rad_per_s, CommandOf(position));
    AddBoneLengths(position);
    position.is_in_table = measured.distance_rad <= kNearTable_rad;
    position.measured_q_TS = measured.pose.q_TS();
    position.model_deg = ModelFigures(position.pose);
    position.measured_deg = MeasuredFigures(measured.pose);
    position.difference_deg = Differences(position.model_deg, position.pose.q_TS,
                                          position.measured_deg, position.measured_q_TS);
    for (std::size_t i = 0; i < position.border_mm.size(); ++i) {
      if (const auto& point_m = position.pose.border_T_m[i]) {
        position.border_mm[i] = kMillimetersPerMeter * DistanceFromEllipsoid(ellipsoid_, *point_m);
      }
    }
    return position;
  }

  // Adds the checks of the model itself: speed at rest, couplings, and distances within a bone.
  void AppendChecks(std::vector<Residual>& lines) const {
    if (arm_.moves_by_actuators()) {
      lines.push_back({"model", "speed at rest", speed_.value(), "rad/s", kRestSpeed_rad_per_s,
                       PlaceText(speed_.place())});
      lines.push_back({"model", "equality constraints", coupling_.value(), "m, rad", std::nullopt,
                       PlaceText(coupling_.place())});
    } else {
      lines.push_back({"model", "equality constraints", coupling_.value(), "m, rad",
                       kCouplingTolerance, PlaceText(coupling_.place())});
    }
    if (!rigid_.empty()) {
      lines.push_back({"bones", "distances of a bone's landmarks", rigid_.magnitude(), "mm",
                       kRigid_mm, PlaceText(rigid_.place())});
    }
  }

 private:
  void AddBoneLengths(const SurveyedPosition& position) {
    const std::vector<double>& lengths_m = position.pose.bone_lengths_m;
    if (bone_lengths_m_.empty()) {
      bone_lengths_m_ = lengths_m;
    }
    for (std::size_t i = 0; i < lengths_m.size(); ++i) {
      rigid_.Add(kMillimetersPerMeter * (lengths_m[i] - bone_lengths_m_[i]), CommandOf(position));
    }
  }

  MappedArm& arm_;
  const MappedShoulder& shoulder_;
  const ShoulderRhythm& rhythm_;
  const Ellipsoid& ellipsoid_;
  std::vector<double> bone_lengths_m_;  ///< at the first position reached
  Spread coupling_;
  Spread speed_;
  Spread rigid_;
};

// Returns the lowest elevation of the grid that is in the measured range.
double LowestElevation_deg(const SurveyGrid& grid) {
  double lowest_deg = grid.elevations_deg.back();
  for (const double elevation_deg : grid.elevations_deg) {
    if (elevation_deg >= kLowestMeasured_deg) {
      lowest_deg = std::min(lowest_deg, elevation_deg);
    }
  }
  return lowest_deg;
}

void PutChanges(double lowest_deg, std::vector<SurveyedPosition>& positions) {
  std::map<double, const SurveyedPosition*> starts;  // by plane
  const double lowest_rad = RadiansFromDegrees(lowest_deg);
  for (const SurveyedPosition& position : positions) {
    if (position.is_in_table && position.elevation_rad == lowest_rad) {
      starts[position.plane_rad] = &position;
    }
  }
  for (SurveyedPosition& position : positions) {
    const auto start = starts.find(position.plane_rad);
    if (position.is_in_table && start != starts.end() && position.elevation_rad > lowest_rad) {
      position.change_difference_deg = ChangeDifferences(*start->second, position);
    }
  }
}

// Visits all positions, plane by plane.
std::vector<SurveyedPosition> VisitAll(Surveyor& surveyor, const SurveyGrid& grid,
                                       const ProgressSink& progress) {
  std::vector<SurveyedPosition> positions;
  const std::size_t positions_of_grid = grid.planes_deg.size() * grid.elevations_deg.size();
  for (const double plane_deg : grid.planes_deg) {
    for (const double elevation_deg : grid.elevations_deg) {
      positions.push_back(surveyor.Visit(elevation_deg, plane_deg));
      progress(static_cast<double>(positions.size()) / static_cast<double>(positions_of_grid));
    }
  }
  return positions;
}

constexpr const char* kNotReached = "positions not reached";
constexpr const char* kElevationReached = "elevation reached - commanded";
constexpr const char* kPlaneReached = "plane reached - commanded";

// Returns the number of positions that the arm misses, with the reason for the first. Throws
// InputError if it misses all.
Residual PositionsNotReached(const std::vector<SurveyedPosition>& positions) {
  const auto is_missed = [](const SurveyedPosition& position) {
    return !position.not_reached.empty();
  };
  const auto first = std::find_if(positions.begin(), positions.end(), is_missed);
  const auto count = std::count_if(positions.begin(), positions.end(), is_missed);
  const std::string count_text = std::to_string(positions.size());
  if (count == std::ssize(positions)) {
    throw InputError("the arm reaches none of the " + count_text + " positions; at " +
                     PlaceText(CommandOf(*first)) + " " + first->not_reached +
                     ". Correct the rows of the arm in the mapping");
  }
  std::string where = "of " + count_text;
  if (count > 0) {
    where += "; " + PlaceText(CommandOf(*first)) + ": " + first->not_reached;
  }
  return {"arm", kNotReached, static_cast<double>(count), "-", std::nullopt, where};
}

// Extremes of all figures over the positions reached.
struct SurveySpreads {
  GroupSpreads in_table;
  GroupSpreads changes;  ///< since the lowest position of each plane
  GroupSpreads beyond;   ///< beyond the table
  Spread elevation_deg;  ///< reached - commanded, in the table
  Spread plane_deg;
};

SurveySpreads SpreadsOf(const std::vector<SurveyedPosition>& positions) {
  SurveySpreads spreads;
  for (const SurveyedPosition& position : positions) {
    if (!position.not_reached.empty()) {
      continue;
    }
    const ArmCommand command = CommandOf(position);
    GroupSpreads& group = position.is_in_table ? spreads.in_table : spreads.beyond;
    for (std::size_t i = 0; i < kGirdleFigureCount; ++i) {
      if (position.difference_deg[i]) {
        group.figures[i].Add(*position.difference_deg[i], command);
      }
      if (position.change_difference_deg[i]) {
        spreads.changes.figures[i].Add(*position.change_difference_deg[i], command);
      }
    }
    for (const std::optional<double>& border_mm : position.border_mm) {
      if (border_mm) {
        group.border.Add(*border_mm, command);
      }
    }
    if (position.is_in_table) {
      spreads.elevation_deg.Add(
          DegreesFromRadians(position.reached.elevation_rad - position.elevation_rad), command);
      spreads.plane_deg.Add(AngleDifference_deg(DegreesFromRadians(position.reached.plane_rad),
                                                DegreesFromRadians(position.plane_rad)),
                            command);
    }
  }
  return spreads;
}

std::string Whole(double value) { return RoundedText(value, 0); }

// Returns the upward rotation from one position to another, "turns upward by 28 degrees".
double UpwardTurn_deg(const GirdleFigures& from_deg, const GirdleFigures& to_deg) {
  const std::size_t i = Index(GirdleFigure::kUpwardRotation);
  return *from_deg[i] - *to_deg[i];
}

// Returns the conclusion: how far the scapula rotates upward in the plane nearest to the frontal
// one, how far it rotates from plane to plane, and its largest difference from the measured one.
std::string SentenceOf(const std::vector<SurveyedPosition>& positions, double lowest_deg,
                       const Spread& scapula, const Spread& upward) {
  std::map<double, std::vector<const SurveyedPosition*>> by_plane;
  for (const SurveyedPosition& position : positions) {
    if (position.is_in_table && position.elevation_rad >= RadiansFromDegrees(lowest_deg)) {
      by_plane[position.plane_rad].push_back(&position);
    }
  }
  std::erase_if(by_plane, [](const auto& plane) { return plane.second.size() < 2; });
  if (by_plane.empty()) {
    return "No two positions of one plane lie within the measured table, so nothing can be said "
           "of how this scapula turns as the arm rises.";
  }
  const auto& frontal = *std::min_element(
      by_plane.begin(), by_plane.end(),
      [](const auto& a, const auto& b) { return std::abs(a.first) < std::abs(b.first); });
  const SurveyedPosition& low = *frontal.second.front();
  const SurveyedPosition& high = *frontal.second.back();
  const auto degrees = [](double angle_rad) { return Whole(DegreesFromRadians(angle_rad)); };
  std::string text =
      "As this arm is raised from " + degrees(low.elevation_rad) + " to " +
      degrees(high.elevation_rad) + " degrees in plane " + degrees(frontal.first) +
      ", its scapula turns upward by " + Whole(UpwardTurn_deg(low.model_deg, high.model_deg)) +
      " degrees, the measured one by " + Whole(UpwardTurn_deg(low.measured_deg, high.measured_deg));
  // The sentence compares two planes at the highest elevation that both have.
  const auto& last = *by_plane.rbegin();
  for (auto there = last.second.rbegin();
       last.first != frontal.first && there != last.second.rend(); ++there) {
    const auto here = std::find_if(frontal.second.begin(), frontal.second.end(),
                                   [&](const SurveyedPosition* position) {
                                     return position->elevation_rad == (*there)->elevation_rad;
                                   });
    if (here != frontal.second.end()) {
      text +=
          "; from plane " + degrees(frontal.first) + " to " + degrees(last.first) +
          " at elevation " + degrees((*there)->elevation_rad) + " it turns by " +
          Whole(DegreesFromRadians(AngleBetween((*here)->pose.q_TS, (*there)->pose.q_TS))) +
          " degrees, the measured one by " +
          Whole(DegreesFromRadians(AngleBetween((*here)->measured_q_TS, (*there)->measured_q_TS)));
      break;
    }
  }
  return text + "; within the measured table its orientation is " + RoundedText(scapula.rms(), 1) +
         " degrees rms from the measured one, at most " + RoundedText(scapula.value(), 1) + " (" +
         PlaceText(scapula.place()) + "), its upward rotation " + RoundedText(upward.rms(), 1) +
         " degrees rms.";
}

nlohmann::ordered_json FiguresAsJson(const GirdleFigures& figures_deg) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < kGirdleFigureCount; ++i) {
    if (figures_deg[i]) {
      std::string key(kGirdleFigureNames[i]);
      std::replace(key.begin(), key.end(), ' ', '_');
      json[key + "_deg"] = *figures_deg[i];
    }
  }
  return json;
}

// The value of a line of the report; "-" if there is no such line.
std::string FigureText(const std::vector<Residual>& lines, const std::string& group,
                       const std::string& item) {
  constexpr int kDecimals = 2;
  const auto line = std::ranges::find_if(lines, [&](const Residual& residual) {
    return residual.group == group && residual.item == item;
  });
  return line == lines.end() ? "-" : RoundedText(line->value, kDecimals);
}

// A row for each quantity that is compared, and rms and largest difference in each part of the
// grid; one table for each part where they do not fit beside each other.
std::string DifferencesTable(const std::vector<Residual>& lines, const TextStyle& style) {
  std::vector<std::string> groups;
  std::vector<std::string> quantities;
  for (const Residual& residual : lines) {
    if (!residual.tolerance && residual.item.ends_with(kRms)) {
      const std::string quantity =
          residual.item.substr(0, residual.item.size() - std::string_view(kRms).size());
      if (std::ranges::count(groups, residual.group) == 0 && residual.group != "arm") {
        groups.push_back(residual.group);
      }
      if (std::ranges::count(quantities, quantity) == 0 && residual.group != "arm") {
        quantities.push_back(quantity);
      }
    }
  }
  const auto table_of = [&](const std::vector<std::string>& shown) {
    std::vector<std::vector<std::string>> rows = {{"rms, largest [deg, mm]"}};
    rows.front().insert(rows.front().end(), shown.begin(), shown.end());
    for (const std::string& quantity : quantities) {
      std::vector<std::string>& row = rows.emplace_back();
      row.push_back(quantity);
      for (const std::string& group : shown) {
        row.push_back(FigureText(lines, group, quantity + kRms) + ", " +
                      FigureText(lines, group, quantity + kLargest));
      }
    }
    return ColumnsText(rows, {Alignment::kLeft, Alignment::kRight});
  };
  std::string whole = table_of(groups);
  if (WidestLine(whole) <= style.width) {
    return whole;
  }
  std::string below_each_other;
  for (const std::string& group : groups) {
    below_each_other += table_of({group});
  }
  return below_each_other;
}

// Returns sentences on positions that were not reached and on directions that were missed; empty if
// there are none.
std::string ArmText(const std::vector<Residual>& lines) {
  constexpr double kSeen_deg = 1;
  std::string text;
  const auto add = [&text](const std::string& sentence) {
    text += (text.empty() ? "" : " ") + sentence;
  };
  for (const Residual& line : lines) {
    if (line.item == kNotReached && line.value > 0) {
      add("Positions not reached: " + std::to_string(std::lround(line.value)) + " " + line.where +
          ".");
    }
    for (const char* const item : {kElevationReached, kPlaneReached}) {
      if (line.item == std::string(item) + kLargest && std::abs(line.value) > kSeen_deg) {
        add("The arm misses the commanded " +
            std::string(item).substr(0, std::string(item).find(' ')) + " by up to " +
            RoundedText(std::abs(line.value), 1) + " deg (" + line.where + ").");
      }
    }
  }
  return text;
}

std::string SurveyAsJson(const ScapulothoracicSurvey& survey) {
  nlohmann::ordered_json json = nlohmann::ordered_json::parse(ReportAsJson(survey.report));
  json["sentence"] = survey.sentence;
  json["positions"] = nlohmann::ordered_json::array();
  for (const SurveyedPosition& position : survey.positions) {
    nlohmann::ordered_json row;
    row["elevation_deg"] = TypedDegrees(position.elevation_rad);
    row["plane_deg"] = TypedDegrees(position.plane_rad);
    if (!position.not_reached.empty()) {
      row["not_reached"] = position.not_reached;
    } else {
      row["reached_elevation_deg"] = DegreesFromRadians(position.reached.elevation_rad);
      row["reached_plane_deg"] = DegreesFromRadians(position.reached.plane_rad);
      row["reached_axial_deg"] = DegreesFromRadians(position.reached.axial_rad);
      row["in_table"] = position.is_in_table;
      row["model"] = FiguresAsJson(position.model_deg);
      row["measured"] = FiguresAsJson(position.measured_deg);
      row["difference"] = FiguresAsJson(position.difference_deg);
      row["difference_of_change"] = FiguresAsJson(position.change_difference_deg);
      for (std::size_t i = 0; i < kGlidingLandmarks.size(); ++i) {
        if (position.border_mm[i]) {
          row[std::string(DefinitionOf(kGlidingLandmarks[i]).name) + "_to_ellipsoid_mm"] =
              *position.border_mm[i];
        }
      }
    }
    json["positions"].push_back(row);
  }
  return JsonText(json);
}

}  // namespace

ScapulothoracicSurvey SurveyGirdle(MappedArm& arm, const MappedShoulder& shoulder,
                                   const ShoulderRhythm& rhythm, const Ellipsoid& ellipsoid,
                                   const SurveyGrid& grid, const ProgressSink& progress) {
  ScapulothoracicSurvey survey;
  Surveyor surveyor(arm, shoulder, rhythm, ellipsoid);
  survey.positions = VisitAll(surveyor, grid, progress);
  const Residual missed = PositionsNotReached(survey.positions);
  const double lowest_deg = LowestElevation_deg(grid);
  PutChanges(lowest_deg, survey.positions);
  const SurveySpreads spreads = SpreadsOf(survey.positions);

  survey.report.engine = mj_versionString();
  std::vector<Residual>& lines = survey.report.residuals;
  surveyor.AppendChecks(lines);
  lines.push_back(missed);
  AppendTo(lines, spreads.elevation_deg, "arm", kElevationReached, "deg");
  AppendTo(lines, spreads.plane_deg, "arm", kPlaneReached, "deg");
  spreads.in_table.AppendTo(lines, "scapulothoracic");
  spreads.changes.AppendTo(lines, "since elevation " + RoundedText(lowest_deg, 1));
  spreads.beyond.AppendTo(lines, "beyond the table");
  survey.sentence = SentenceOf(survey.positions, lowest_deg,
                               spreads.in_table.figures[Index(GirdleFigure::kScapula)],
                               spreads.in_table.figures[Index(GirdleFigure::kUpwardRotation)]);
  return survey;
}

std::string SurveyIn(const ReportChoice& choice, const ScapulothoracicSurvey& survey) {
  if (choice.form == ReportForm::kJson) {
    return SurveyAsJson(survey);
  }
  const std::string arm = ArmText(survey.report.residuals);
  const std::string sentence = (arm.empty() ? "" : WrappedText(arm, choice.style.width) + "\n") +
                               WrappedText(survey.sentence, choice.style.width) + "\n";
  if (choice.form == ReportForm::kFull) {
    return ReportAsText(survey.report, choice.style) + "\n" + sentence;
  }
  ResidualReport checked = survey.report;
  std::erase_if(checked.residuals, [](const Residual& residual) { return !residual.tolerance; });
  const SummaryParts parts = SummaryPartsOf(checked, choice.style);
  return parts.head + "\n" + parts.table + "\n" +
         DifferencesTable(survey.report.residuals, choice.style) + "\n" + parts.failures +
         (parts.failures.empty() ? "" : "\n") + sentence + parts.end;
}

}  // namespace girdle
