// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/solve_command.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <system_error>

#include "commands/output_file.h"
#include "commands/progress.h"
#include "commands/rhythm_arguments.h"
#include "tables/csv.h"
#include "tables/input_error.h"
#include "tables/number_text.h"
#include "tables/text_file.h"

namespace girdle {
namespace {

constexpr const char* kElevationColumn = "elevation_deg";
constexpr const char* kPlaneColumn = "plane_deg";
constexpr const char* kAxialColumn = "axial_deg";
constexpr const char* kClampedColumn = "clamped";

struct SolveArguments {
  RhythmArguments rhythm;
  std::optional<std::string> elevation_deg;
  std::optional<std::string> plane_deg;
  std::optional<std::string> axial_deg;
  std::string in;
  std::string out;
  bool json = false;
};

std::string AngleColumn(std::size_t coordinate) {
  return std::string(kCoordinateNames[coordinate]) + "_deg";
}

// One position of the arm as typed.
struct TypedPose {
  double elevation_deg;
  double plane_deg;
  double axial_deg;
};

double RequiredNumber(const std::string& option, const std::optional<std::string>& text) {
  if (!text) {
    throw InputError(option + " is missing. One pose needs --elevation and --plane");
  }
  return NumberArgument(option, *text);
}

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

std::string PoseAsJson(const ShoulderRhythm& rhythm, const TypedPose& typed,
                       const ShoulderSolution& solution) {
  const CellEdges edges = EdgesOf(rhythm.table(), solution.cell);
  nlohmann::ordered_json json;
  json[kElevationColumn] = typed.elevation_deg;
  json[kPlaneColumn] = typed.plane_deg;
  json[kAxialColumn] = typed.axial_deg;
  json["interpolation"] = Name(rhythm.options().interpolation);
  json["closure"] = Name(rhythm.options().closure);
  json["cell"] = {{"elevation_from_deg", edges.elevation_from_deg},
                  {"elevation_to_deg", edges.elevation_to_deg},
                  {"elevation_weight", solution.cell.elevation_weight},
                  {"plane_from_deg", edges.plane_from_deg},
                  {"plane_to_deg", edges.plane_to_deg},
                  {"plane_weight", solution.cell.plane_weight}};
  json[kClampedColumn] = solution.clamped;
  json["distance_deg"] = DegreesFromRadians(solution.distance_rad);
  const JointAngles angles_rad = AnglesFromPose(solution.pose);
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    json["angles_deg"][std::string(kCoordinateNames[k])] = DegreesFromRadians(angles_rad[k]);
  }
  return json.dump(2) + "\n";
}

std::string PoseAsText(const ShoulderRhythm& rhythm, const ShoulderSolution& solution) {
  constexpr int kEdgeDecimals = 6;
  constexpr int kAngleDecimals = 6;
  constexpr std::size_t kNameWidth = 22;
  constexpr std::size_t kAngleWidth = 13;
  const CellEdges edges = EdgesOf(rhythm.table(), solution.cell);
  const auto range = [](double from_deg, double to_deg, double weight) {
    return RoundedText(from_deg, kEdgeDecimals) + " to " + RoundedText(to_deg, kEdgeDecimals) +
           " deg, weight " + RoundedText(weight, kEdgeDecimals) + "\n";
  };
  std::string text =
      "elevation cell  " +
      range(edges.elevation_from_deg, edges.elevation_to_deg, solution.cell.elevation_weight) +
      "plane cell      " +
      range(edges.plane_from_deg, edges.plane_to_deg, solution.cell.plane_weight);
  if (solution.clamped) {
    text += "clamped         the command is " +
            RoundedText(DegreesFromRadians(solution.distance_rad), kEdgeDecimals) +
            " deg outside the table; its nearest point is used\n";
  }
  text += "\n";
  const JointAngles angles_rad = AnglesFromPose(solution.pose);
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    std::string name(kCoordinateNames[k]);
    name.resize(kNameWidth, ' ');
    const std::string angle = RoundedText(DegreesFromRadians(angles_rad[k]), kAngleDecimals);
    text += name + std::string(kAngleWidth - std::min(kAngleWidth, angle.size()), ' ') + angle +
            " deg\n";
  }
  return text;
}

void SolveOne(const SolveArguments& arguments) {
  const TypedPose typed = {RequiredNumber("--elevation", arguments.elevation_deg),
                           RequiredNumber("--plane", arguments.plane_deg),
                           NumberArgument("--axial", arguments.axial_deg.value_or("0"))};
  const ShoulderRhythm rhythm = ChosenRhythm(arguments.rhythm);
  const ShoulderSolution solution =
      rhythm.Solve({RadiansFromDegrees(typed.elevation_deg), RadiansFromDegrees(typed.plane_deg),
                    RadiansFromDegrees(typed.axial_deg)});
  OutputFile out(arguments.out);
  out.Write(arguments.json ? PoseAsJson(rhythm, typed, solution) : PoseAsText(rhythm, solution));
  out.Commit();
}

// Reads poses row by row and writes each with its angles; memory does not grow with the file.
// `bytes` is the length of the input, 0 if it is not known.
void SolveRows(std::istream& in, const std::string& name, std::uintmax_t bytes,
               const SolveArguments& arguments) {
  const ShoulderRhythm rhythm = ChosenRhythm(arguments.rhythm);
  const double axial_rad =
      RadiansFromDegrees(NumberArgument("--axial", arguments.axial_deg.value_or("0")));
  CsvReader csv(in, name);
  const std::size_t elevation_column = csv.Column(kElevationColumn);
  const std::size_t plane_column = csv.Column(kPlaneColumn);
  const bool has_axial = csv.HasColumn(kAxialColumn);
  const std::size_t axial_column = has_axial ? csv.Column(kAxialColumn) : 0;
  if (has_axial && arguments.axial_deg) {
    csv.Fail("the column axial_deg and --axial exclude each other. Remove one");
  }

  std::string text = csv.header_line();
  const auto append_column = [&csv, &text](const std::string& column) {
    if (csv.HasColumn(column)) {
      csv.Fail("column '" + column + "' would stand twice in the output. Rename it in the input");
    }
    text += "," + column;
  };
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    append_column(AngleColumn(k));
  }
  append_column(kClampedColumn);
  text += '\n';

  constexpr std::size_t kBufferSize = 1 << 16;
  OutputFile out(arguments.out);
  TerminalProgress progress("solving", arguments.out != "-");
  std::uintmax_t bytes_done = 0;
  while (csv.Next()) {
    const ShoulderSolution solution =
        rhythm.Solve({RadiansFromDegrees(csv.Number(elevation_column)),
                      RadiansFromDegrees(csv.Number(plane_column)),
                      has_axial ? RadiansFromDegrees(csv.Number(axial_column)) : axial_rad});
    text += csv.line();
    for (const double angle_rad : AnglesFromPose(solution.pose)) {
      text += ',';
      AppendNumber(text, DegreesFromRadians(angle_rad));
    }
    text += solution.clamped ? ",1\n" : ",0\n";
    bytes_done += csv.line().size() + 1;
    if (text.size() > kBufferSize) {
      out.Write(text);
      text.clear();
      if (bytes > 0) {
        progress(std::min(1.0, static_cast<double>(bytes_done) / static_cast<double>(bytes)));
      }
    }
  }
  out.Write(text);
  out.Commit();
}

void Solve(const SolveArguments& arguments) {
  const bool one = arguments.elevation_deg.has_value() || arguments.plane_deg.has_value();
  if (one && !arguments.in.empty()) {
    throw InputError("--in and --elevation, --plane exclude each other. Give a file or one pose");
  }
  if (one) {
    SolveOne(arguments);
    return;
  }
  if (arguments.in.empty()) {
    throw InputError(
        "nothing to solve. Give --elevation and --plane, or --in FILE; see girdle solve --help");
  }
  if (arguments.json) {
    throw InputError("--json is for one pose. With --in the output is CSV: leave --json away");
  }
  if (arguments.in == "-") {
    SolveRows(std::cin, "standard input", 0, arguments);
    return;
  }
  std::ifstream in = OpenTextFile(arguments.in);
  std::error_code unknown_size;
  const std::uintmax_t bytes = std::filesystem::file_size(arguments.in, unknown_size);
  SolveRows(in, arguments.in, unknown_size ? 0 : bytes, arguments);
}

}  // namespace

void AddSolveCommand(CLI::App& program) {
  auto arguments = std::make_shared<SolveArguments>();
  arguments->out = "-";
  CLI::App* verb =
      program.add_subcommand("solve", "Joint angles for one arm position or a CSV of them");
  verb->add_option("--elevation", arguments->elevation_deg, "Humeral elevation")->type_name("DEG");
  verb->add_option("--plane", arguments->plane_deg,
                   "Plane of elevation: 0 frontal, 40 scapular, 90 sagittal")
      ->type_name("DEG");
  verb->add_option("--axial", arguments->axial_deg,
                   "Turn about the humerus's long axis on top of the measured one")
      ->type_name("DEG");
  verb->add_option(
          "--in", arguments->in,
          "CSV with the columns elevation_deg and plane_deg, optionally axial_deg; - for standard "
          "input")
      ->type_name("FILE");
  verb->add_option("--out", arguments->out, "Where to write; - for standard output (default)")
      ->type_name("FILE");
  verb->add_flag("--json", arguments->json, "One pose as JSON");
  AddRhythmArguments(*verb, arguments->rhythm);
  verb->footer(
      "Examples:\n"
      "  girdle solve --elevation 23 --plane 50\n"
      "  girdle solve --in poses.csv --out angles.csv");
  verb->callback([arguments] { Solve(*arguments); });
}

}  // namespace girdle
