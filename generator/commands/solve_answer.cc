// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/solve_answer.h"

#include <array>
#include <nlohmann/json.hpp>
#include <vector>

#include "motions/command_columns.h"
#include "names/model_names.h"
#include "text/json_text.h"
#include "text/number_text.h"
#include "text/text_columns.h"

namespace girdle {
namespace {

constexpr const char* kLandmarksKey = "landmarks_mm";
constexpr const char* kAxialIsbKey = "axial_isb_deg";

struct CellEdges {
  double elevation_from_deg;
  double elevation_to_deg;
  double plane_from_deg;
  double plane_to_deg;
};

CellEdges EdgesOf(const RhythmTable& table, const RhythmCell& cell) {
  const auto& elevations = table.elevations_rad();
  const auto& planes = table.planes_rad();
  return {DegreesFromRadians(elevations[cell.elevation_index]),
          DegreesFromRadians(elevations[cell.elevation_index + 1]),
          DegreesFromRadians(planes[cell.plane_index]),
          DegreesFromRadians(planes[cell.plane_index + 1])};
}

// Returns first and second derivatives [deg per deg, deg per deg^2] as JSON.
nlohmann::ordered_json DerivativesAsJson(const ShoulderDerivatives& derivatives) {
  nlohmann::ordered_json json;
  const auto first = [](const Vector3& w) { return std::array{w.x, w.y, w.z}; };
  const auto second = [](const Vector3& w) {
    return std::array{w.x * kRadiansPerDegree, w.y * kRadiansPerDegree, w.z * kRadiansPerDegree};
  };
  for (std::size_t joint = 0; joint < kJointCount; ++joint) {
    const RotationDerivatives& rotation = derivatives.joints[joint];
    json["angular_velocity"][std::string(kJointNames[joint])] = {
        {"by_elevation", first(rotation.rate.by_elevation)},
        {"by_plane", first(rotation.rate.by_plane)},
        {"by_elevation_twice_per_deg", second(rotation.by_elevation_twice)},
        {"by_elevation_and_plane_per_deg", second(rotation.by_elevation_and_plane)},
        {"by_plane_twice_per_deg", second(rotation.by_plane_twice)}};
  }
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    const AngleDerivatives& angle = derivatives.angles[k];
    json["angles"][std::string(kCoordinateNames[k])] = {
        {"by_elevation", angle.by_elevation},
        {"by_plane", angle.by_plane},
        {"by_elevation_twice_per_deg", angle.by_elevation_twice * kRadiansPerDegree},
        {"by_elevation_and_plane_per_deg", angle.by_elevation_and_plane * kRadiansPerDegree},
        {"by_plane_twice_per_deg", angle.by_plane_twice * kRadiansPerDegree}};
  }
  return json;
}

nlohmann::ordered_json PointsAsJson(const Anatomy& anatomy, const ShoulderPose& pose) {
  nlohmann::ordered_json json;
  for (const ShoulderPoint& point : ShoulderPoints(anatomy, pose)) {
    json[point.name] = {point.p_mm.x, point.p_mm.y, point.p_mm.z};
  }
  return json;
}

// Adds the rotations of a pose in the chosen form.
void AddRotations(nlohmann::ordered_json& json, const ShoulderPose& pose,
                  const SolveOutput& output) {
  if (output.since) {
    json["relative_to"] = kHangingName;
  }
  const WrittenRotations rotations = RotationsOf(pose, output.since);
  if (output.form == RotationForm::kQuaternions) {
    for (std::size_t i = 0; i < rotations.size(); ++i) {
      const Quaternion& q = rotations[i];
      json["quaternions"][std::string(kWrittenRotationNames[i])] = {q.w, q.x, q.y, q.z};
    }
    return;
  }
  const std::vector<std::string> names = WrittenAngleNames();
  const WrittenAngles angles_rad = AnglesOf(rotations);
  for (std::size_t k = 0; k < names.size(); ++k) {
    json["angles_deg"][names[k]] = DegreesFromRadians(angles_rad[k]);
  }
}

constexpr std::size_t kLabelWidth = 22;
constexpr std::size_t kAngleWidth = 13;

// Returns numbers to the right of a label, each in a column of its own.
std::string NumbersAsText(const std::string& label, const std::vector<double>& numbers,
                          int digits) {
  std::string text = AlignedLeft(label, kLabelWidth);
  for (const double number : numbers) {
    text += " " + AlignedRight(RoundedText(number, digits), kAngleWidth - 1);
  }
  return text;
}

std::string RotationsAsText(const ShoulderPose& pose, const SolveOutput& output) {
  std::string text;
  if (output.since) {
    text = "turned since the arm was hanging (" + std::string(Name(output.since_origin)) + ")\n";
  }
  const WrittenRotations rotations = RotationsOf(pose, output.since);
  if (output.form == RotationForm::kQuaternions) {
    text += "quaternions w, x, y, z\n";
    for (std::size_t i = 0; i < rotations.size(); ++i) {
      const Quaternion& q = rotations[i];
      text += NumbersAsText(std::string(kWrittenRotationNames[i]), {q.w, q.x, q.y, q.z},
                            output.digits) +
              "\n";
    }
    return text;
  }
  const std::vector<std::string> names = WrittenAngleNames();
  const WrittenAngles angles_rad = AnglesOf(rotations);
  for (std::size_t k = 0; k < names.size(); ++k) {
    text += NumbersAsText(names[k], {DegreesFromRadians(angles_rad[k])}, output.digits) + " deg\n";
  }
  return text;
}

std::string PointsAsText(const Anatomy& anatomy, const ShoulderPose& pose, int digits) {
  std::string text = "\n" + AlignedLeft("in the thorax (mm)", kLabelWidth);
  for (const char* axis : {"x", "y", "z"}) {
    text += AlignedRight(axis, kAngleWidth);
  }
  text += "\n";
  for (const ShoulderPoint& point : ShoulderPoints(anatomy, pose)) {
    text += NumbersAsText(point.name, {point.p_mm.x, point.p_mm.y, point.p_mm.z}, digits) + "\n";
  }
  return text;
}

// Returns how each angle changes with elevation and plane.
std::string DerivativesAsText(const ShoulderDerivatives& derivatives, int digits) {
  std::string text = "\n" + AlignedLeft("change of", kLabelWidth) +
                     AlignedRight("elevation", kAngleWidth) + AlignedRight("plane", kAngleWidth) +
                     "  deg per deg\n";
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    const AngleDerivatives& angle = derivatives.angles[k];
    text += NumbersAsText(std::string(kCoordinateNames[k]), {angle.by_elevation, angle.by_plane},
                          digits) +
            "\n";
  }
  return text;
}

// Returns the parts of the command used that differ from the command given.
std::string UsedAsText(const ShoulderRhythm& rhythm, const ArmCommand& given,
                       const ArmCommand& used, int digits) {
  std::string differing;
  const bool is_other_plane =
      rhythm.IsClamped({used.elevation_rad, given.plane_rad}, {used.elevation_rad, used.plane_rad});
  const auto add = [&differing, digits](const char* name, double given_rad, double used_rad) {
    if (given_rad != used_rad) {
      differing += (differing.empty() ? "" : ", ") + std::string(name) + " " +
                   RoundedText(DegreesFromRadians(used_rad), digits) + " deg";
    }
  };
  add("elevation", given.elevation_rad, used.elevation_rad);
  if (is_other_plane) {
    add("plane", given.plane_rad, used.plane_rad);
  }
  add("axial", rhythm.AxialCountedFrom(AxialFrom::kRhythm, given), used.axial_rad);
  add("shrug", given.shrug_rad, used.shrug_rad);
  add("protraction", given.protraction_rad, used.protraction_rad);
  return "clamped         used instead: " + differing + "\n";
}

}  // namespace

std::string PositionAsJson(const ShoulderRhythm& rhythm, const TypedPosition& typed,
                           const SolveOutput& output) {
  const ShoulderSolution solution = rhythm.Solve(typed.command());
  const CellEdges edges = EdgesOf(rhythm.table(), solution.cell);
  nlohmann::ordered_json json;
  json[kElevationColumn] = typed.elevation_deg;
  json[kPlaneColumn] = typed.plane_deg;
  json[kAxialColumn] = typed.axial_deg;
  json[kShrugColumn] = typed.shrug_deg;
  json[kProtractionColumn] = typed.protraction_deg;
  json["axial_from"] = Name(typed.axial_from);
  json["interpolation"] = Name(rhythm.options().interpolation);
  json["closure"] = Name(rhythm.options().closure);
  json["range"] = Name(*rhythm.options().range);
  json["cell"] = {{"elevation_from_deg", edges.elevation_from_deg},
                  {"elevation_to_deg", edges.elevation_to_deg},
                  {"elevation_weight", solution.cell.elevation_weight},
                  {"plane_from_deg", edges.plane_from_deg},
                  {"plane_to_deg", edges.plane_to_deg},
                  {"plane_weight", solution.cell.plane_weight}};
  json[std::string(kClampedStem)] = solution.clamped;
  json["used"] = {{kElevationColumn, DegreesFromRadians(solution.used.elevation_rad)},
                  {kPlaneColumn, DegreesFromRadians(solution.used.plane_rad)},
                  {kAxialColumn, DegreesFromRadians(solution.used.axial_rad)},
                  {kAxialIsbKey, DegreesFromRadians(rhythm.AxialOf(AxialFrom::kIsb, solution.pose,
                                                                   solution.used))},
                  {kShrugColumn, DegreesFromRadians(solution.used.shrug_rad)},
                  {kProtractionColumn, DegreesFromRadians(solution.used.protraction_rad)}};
  json[ColumnName(kDistanceStem, kDegrees)] = DegreesFromRadians(solution.distance_rad);
  json[std::string(kOriginStem)] = Name(solution.origin);
  AddRotations(json, solution.pose, output);
  if (output.points_of) {
    json[kLandmarksKey] = PointsAsJson(*output.points_of, solution.pose);
  }
  if (output.derivatives) {
    json["derivatives"] = DerivativesAsJson(*rhythm.SolveDerivatives(typed.command()));
  }
  return JsonText(json);
}

std::string PositionAsText(const ShoulderRhythm& rhythm, const TypedPosition& typed,
                           const SolveOutput& output) {
  const ShoulderSolution solution = rhythm.Solve(typed.command());
  const CellEdges edges = EdgesOf(rhythm.table(), solution.cell);
  const int digits = output.digits;
  const auto range = [digits](double from_deg, double to_deg, double weight) {
    return RoundedText(from_deg, digits) + " to " + RoundedText(to_deg, digits) + " deg, weight " +
           RoundedText(weight, digits) + "\n";
  };
  std::string text =
      "elevation cell  " +
      range(edges.elevation_from_deg, edges.elevation_to_deg, solution.cell.elevation_weight) +
      "plane cell      " +
      range(edges.plane_from_deg, edges.plane_to_deg, solution.cell.plane_weight);
  if (solution.clamped) {
    text += UsedAsText(rhythm, typed.command(), solution.used, digits);
  }
  text += "origin          " + std::string(Name(solution.origin));
  if (solution.distance_rad > 0) {
    text += (solution.clamped ? ", in answer to a direction " : ", ") +
            RoundedText(DegreesFromRadians(solution.distance_rad), digits) +
            " deg from measured positions";
  }
  text +=
      "\naxial           " + RoundedText(DegreesFromRadians(solution.used.axial_rad), digits) +
      " deg from the rhythm's own turn, ISB " +
      RoundedText(DegreesFromRadians(rhythm.AxialOf(AxialFrom::kIsb, solution.pose, solution.used)),
                  digits) +
      " deg";
  text += "\n\n" + RotationsAsText(solution.pose, output);
  if (output.points_of) {
    text += PointsAsText(*output.points_of, solution.pose, output.digits);
  }
  if (output.derivatives) {
    text += DerivativesAsText(*rhythm.SolveDerivatives(typed.command()), output.digits);
  }
  return text;
}

std::string PostureAsJson(const std::string& posture, const ShoulderPose& pose,
                          const SolveOutput& output) {
  nlohmann::ordered_json json;
  json["posture"] = posture;
  AddRotations(json, pose, output);
  if (output.points_of) {
    json[kLandmarksKey] = PointsAsJson(*output.points_of, pose);
  }
  return JsonText(json);
}

std::string PostureAsText(const std::string& posture, const ShoulderPose& pose,
                          const SolveOutput& output) {
  return "posture         " + posture + "\n\n" + RotationsAsText(pose, output) +
         (output.points_of ? PointsAsText(*output.points_of, pose, output.digits) : "");
}

}  // namespace girdle
