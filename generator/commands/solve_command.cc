// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/solve_command.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <system_error>
#include <thread>

#include "commands/output_file.h"
#include "commands/rhythm_arguments.h"
#include "commands/solve_rows.h"
#include "tables/input_error.h"
#include "tables/number_text.h"
#include "tables/text_file.h"

namespace girdle {
namespace {

constexpr std::size_t kMostThreads = 64;
// More would surprise whoever shares the machine.
constexpr std::size_t kMostThreadsUnasked = 4;

struct SolveArguments {
  RhythmArguments rhythm;
  std::optional<std::string> elevation_deg;
  std::optional<std::string> plane_deg;
  std::optional<std::string> axial_deg;
  std::optional<std::string> threads;
  std::string in;
  std::string out;
  bool json = false;
};

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

std::size_t ChosenThreads(const std::optional<std::string>& text) {
  if (!text) {
    // Where the number of cores is not known it is 0.
    return std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, kMostThreadsUnasked);
  }
  const std::optional<double> number = FiniteNumber(*text);
  if (!number || *number < 1 || *number > kMostThreads || *number != std::floor(*number)) {
    throw InputError("--threads '" + *text + "': not a whole number from 1 to " +
                     std::to_string(kMostThreads) + ". Give one such as --threads 2");
  }
  return static_cast<std::size_t>(*number);
}

void SolveFile(const RowSource& source, const SolveArguments& arguments) {
  RowOptions options;
  options.threads = ChosenThreads(arguments.threads);
  if (arguments.axial_deg) {
    options.axial_deg = NumberArgument("--axial", *arguments.axial_deg);
  }
  SolveRows(source, arguments.out, ChosenRhythm(arguments.rhythm), options);
}

void Solve(const SolveArguments& arguments) {
  const bool one = arguments.elevation_deg.has_value() || arguments.plane_deg.has_value();
  if (one && !arguments.in.empty()) {
    throw InputError("--in and --elevation, --plane exclude each other. Give a file or one pose");
  }
  if (one && arguments.threads) {
    throw InputError("--threads is for a file of poses. For one pose leave it away");
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
    SolveFile({std::cin, "standard input", 0}, arguments);
    return;
  }
  std::ifstream in = OpenTextFile(arguments.in);
  std::error_code unknown_size;
  const std::uintmax_t bytes = std::filesystem::file_size(arguments.in, unknown_size);
  SolveFile({in, arguments.in, unknown_size ? 0 : bytes}, arguments);
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
  verb->add_option("--threads", arguments->threads,
                   "How many threads solve a file, 1 to 64; as many as there are cores, 4 at most, "
                   "if not given. The output is the same")
      ->type_name("N");
  verb->add_flag("--json", arguments->json, "One pose as JSON");
  AddRhythmArguments(*verb, arguments->rhythm);
  verb->footer(
      "Examples:\n"
      "  girdle solve --elevation 23 --plane 50\n"
      "  girdle solve --in poses.csv --out angles.csv");
  verb->callback([arguments] { Solve(*arguments); });
}

}  // namespace girdle
