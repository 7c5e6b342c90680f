// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/solve_command.h"

#include <algorithm>
#include <array>
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
#include <utility>
#include <vector>

#include "anatomy/built_in_anatomy.h"
#include "commands/anatomy_arguments.h"
#include "commands/angle_arguments.h"
#include "commands/angle_sweep.h"
#include "commands/named_files.h"
#include "commands/output_file.h"
#include "commands/rhythm_arguments.h"
#include "commands/shoulder_points.h"
#include "commands/solve_columns.h"
#include "commands/solve_rows.h"
#include "motions/command_columns.h"
#include "names/model_names.h"
#include "text/input_error.h"
#include "text/json_text.h"
#include "text/number_text.h"
#include "text/text_columns.h"
#include "text/text_file.h"

namespace girdle {
namespace {

constexpr std::size_t kMostThreads = 64;
// More would surprise whoever shares the machine.
constexpr std::size_t kMostThreadsUnasked = 4;

struct SolveArguments {
  RhythmArguments rhythm;
  AnatomyArguments anatomy;
  std::optional<std::string> elevation_deg;
  std::optional<std::string> plane_deg;
  std::optional<std::string> axial_deg;
  std::string axial_from;
  AngleArguments angles;
  std::optional<std::string> shrug_deg;
  std::optional<std::string> protraction_deg;
  std::optional<std::string> posture;
  std::optional<std::string> threads;
  std::string in;
  std::string out;
  bool rates = false;
  bool landmarks = false;
  bool json = false;
};

constexpr const char* kLandmarksKey = "landmarks_mm";
constexpr const char* kAxialIsbKey = "axial_isb_deg";

// A million positions; more belong into a file.
constexpr std::uint64_t kMostSwept = 1'000'000;
constexpr SweptAngle kSweptElevation = {"--elevation", kWholeElevations, -kHalfCircle_deg,
                                        kHalfCircle_deg};
constexpr SweptAngle kSweptPlane = {"--plane", kWholePlanes, -kMostTurned_deg, kMostTurned_deg};

// One position of the arm as typed, with the elevation as Girdle counts it.
struct TypedPose {
  double elevation_deg;
  double plane_deg;
  double axial_deg;
  double shrug_deg;
  double protraction_deg;
  AxialFrom axial_from;

  [[nodiscard]] ArmCommand command() const {
    return {RadiansFromDegrees(elevation_deg),   RadiansFromDegrees(PlaneRead_deg(plane_deg)),
            RadiansFromDegrees(axial_deg),       RadiansFromDegrees(shrug_deg),
            RadiansFromDegrees(protraction_deg), axial_from};
  }
};

// An offset that is given, within its bounds.
std::optional<double> OffsetArgument(const std::string& option,
                                     const std::optional<std::string>& text,
                                     const CoordinateRange& bounds) {
  if (!text) {
    return std::nullopt;
  }
  const double offset_deg = NumberArgument(option, *text);
  const double lower_deg = TypedDegrees(bounds.lower_rad);
  const double upper_deg = TypedDegrees(bounds.upper_rad);
  if (offset_deg < lower_deg || offset_deg > upper_deg) {
    constexpr int kDecimals = 6;
    throw InputError(option + " " + *text + ": a clavicle goes from " +
                     RoundedText(lower_deg, kDecimals) + " to " +
                     RoundedText(upper_deg, kDecimals) +
                     " deg beside the rhythm. Give an offset within");
  }
  return offset_deg;
}
std::optional<double> ShrugArgument(const SolveArguments& arguments) {
  return OffsetArgument("--shrug", arguments.shrug_deg, kShrugRange);
}
std::optional<double> ProtractionArgument(const SolveArguments& arguments) {
  return OffsetArgument("--protraction", arguments.protraction_deg, kProtractionRange);
}

// Without an axial turn there is nothing to count.
AxialFrom ChosenAxialFrom(const SolveArguments& arguments) {
  if (!arguments.axial_deg && arguments.in.empty()) {
    if (!arguments.axial_from.empty()) {
      throw InputError("--axial-from " + arguments.axial_from +
                       ": no axial turn is given. Add --axial, or leave --axial-from away");
    }
    return AxialFrom::kRhythm;
  }
  return AxialFromOf(arguments.axial_from, arguments.angles).value_or(AxialFrom::kRhythm);
}

const std::string& Required(const std::string& option, const std::optional<std::string>& text) {
  if (!text) {
    throw InputError(option + " is missing. One pose needs --elevation and --plane");
  }
  return *text;
}

// An elevation that was typed, as Girdle counts it.
double ReadElevation_deg(const SolveArguments& arguments, const std::string& text) {
  return ElevationArgument_deg("--elevation", text, ReadingFrom(arguments.angles).convention,
                               arguments.axial_deg.has_value());
}

// As it was typed, whole turns too.
double TypedPlane_deg(const SolveArguments& arguments) {
  const std::string& text = Required("--plane", arguments.plane_deg);
  static_cast<void>(PlaneArgument_deg("--plane", text));
  return NumberArgument("--plane", text);
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

// First and second derivatives [deg per deg, deg per deg^2].
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

SolveAdditions ChosenAdditions(const SolveArguments& arguments) {
  if (!arguments.landmarks && IsAnatomyChosen(arguments.anatomy)) {
    throw InputError(
        "whose shoulder it is changes no angle, only where landmarks are. Add --landmarks, or "
        "leave --anatomy, --thorax and the measures away");
  }
  SolveAdditions additions;
  additions.rates = arguments.rates;
  if (arguments.landmarks) {
    additions.points_of = ChosenAnatomy(arguments.anatomy);
  }
  return additions;
}

std::string PoseAsJson(const ShoulderRhythm& rhythm, const TypedPose& typed,
                       const ShoulderSolution& solution, const SolveAdditions& additions) {
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
  const JointAngles angles_rad = AnglesFromPose(solution.pose);
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    json["angles_deg"][std::string(kCoordinateNames[k])] = DegreesFromRadians(angles_rad[k]);
  }
  if (additions.points_of) {
    json[kLandmarksKey] = PointsAsJson(*additions.points_of, solution.pose);
  }
  if (additions.rates) {
    json["derivatives"] = DerivativesAsJson(*rhythm.SolveDerivatives(typed.command()));
  }
  return JsonText(json);
}

constexpr std::size_t kLabelWidth = 22;
constexpr std::size_t kAngleWidth = 13;
constexpr int kDecimals = 6;

std::string AnglesAsText(const JointAngles& angles_rad) {
  std::string text;
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    text += AlignedLeft(std::string(kCoordinateNames[k]), kLabelWidth) +
            AlignedRight(RoundedText(DegreesFromRadians(angles_rad[k]), kDecimals), kAngleWidth) +
            " deg\n";
  }
  return text;
}

std::string PointsAsText(const Anatomy& anatomy, const ShoulderPose& pose) {
  std::string text = "\n" + AlignedLeft("in the thorax (mm)", kLabelWidth);
  for (const char* axis : {"x", "y", "z"}) {
    text += AlignedRight(axis, kAngleWidth);
  }
  text += "\n";
  for (const ShoulderPoint& point : ShoulderPoints(anatomy, pose)) {
    text += AlignedLeft(point.name, kLabelWidth);
    for (int axis = 0; axis < 3; ++axis) {
      text += AlignedRight(RoundedText(point.p_mm[axis], kDecimals), kAngleWidth);
    }
    text += "\n";
  }
  return text;
}

// How each angle changes with elevation and plane.
std::string RatesAsText(const ShoulderDerivatives& derivatives) {
  std::string text = "\n" + AlignedLeft("change of", kLabelWidth) +
                     AlignedRight("elevation", kAngleWidth) + AlignedRight("plane", kAngleWidth) +
                     "  deg per deg\n";
  for (std::size_t k = 0; k < kCoordinateCount; ++k) {
    const AngleDerivatives& angle = derivatives.angles[k];
    text += AlignedLeft(std::string(kCoordinateNames[k]), kLabelWidth) +
            AlignedRight(RoundedText(angle.by_elevation, kDecimals), kAngleWidth) +
            AlignedRight(RoundedText(angle.by_plane, kDecimals), kAngleWidth) + "\n";
  }
  return text;
}

// What the command used differs from the one given by.
std::string UsedAsText(const ShoulderRhythm& rhythm, const ArmCommand& given,
                       const ArmCommand& used) {
  std::string differing;
  const bool is_other_plane =
      rhythm.IsClamped({used.elevation_rad, given.plane_rad}, {used.elevation_rad, used.plane_rad});
  const auto add = [&differing](const char* name, double given_rad, double used_rad) {
    if (given_rad != used_rad) {
      differing += (differing.empty() ? "" : ", ") + std::string(name) + " " +
                   RoundedText(DegreesFromRadians(used_rad), kDecimals) + " deg";
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

std::string PoseAsText(const ShoulderRhythm& rhythm, const TypedPose& typed,
                       const ShoulderSolution& solution, const SolveAdditions& additions) {
  const CellEdges edges = EdgesOf(rhythm.table(), solution.cell);
  const auto range = [](double from_deg, double to_deg, double weight) {
    return RoundedText(from_deg, kDecimals) + " to " + RoundedText(to_deg, kDecimals) +
           " deg, weight " + RoundedText(weight, kDecimals) + "\n";
  };
  std::string text =
      "elevation cell  " +
      range(edges.elevation_from_deg, edges.elevation_to_deg, solution.cell.elevation_weight) +
      "plane cell      " +
      range(edges.plane_from_deg, edges.plane_to_deg, solution.cell.plane_weight);
  if (solution.clamped) {
    text += UsedAsText(rhythm, typed.command(), solution.used);
  }
  text += "origin          " + std::string(Name(solution.origin));
  if (solution.distance_rad > 0) {
    text += (solution.clamped ? ", in answer to a direction " : ", ") +
            RoundedText(DegreesFromRadians(solution.distance_rad), kDecimals) +
            " deg from measured positions";
  }
  text +=
      "\naxial           " + RoundedText(DegreesFromRadians(solution.used.axial_rad), kDecimals) +
      " deg from the rhythm's own turn, ISB " +
      RoundedText(DegreesFromRadians(rhythm.AxialOf(AxialFrom::kIsb, solution.pose, solution.used)),
                  kDecimals) +
      " deg";
  text += "\n\n" + AnglesAsText(AnglesFromPose(solution.pose));
  if (additions.points_of) {
    text += PointsAsText(*additions.points_of, solution.pose);
  }
  if (additions.rates) {
    text += RatesAsText(*rhythm.SolveDerivatives(typed.command()));
  }
  return text;
}

void SolveOne(const SolveArguments& arguments) {
  ExpectNoUnit(arguments.angles);
  const std::string& elevation = Required("--elevation", arguments.elevation_deg);
  const TypedPose typed = {ReadElevation_deg(arguments, elevation),
                           TypedPlane_deg(arguments),
                           AxialArgument_deg("--axial", arguments.axial_deg.value_or("0")),
                           ShrugArgument(arguments).value_or(0),
                           ProtractionArgument(arguments).value_or(0),
                           ChosenAxialFrom(arguments)};
  const ShoulderRhythm rhythm = ChosenRhythm(arguments.rhythm);
  const ShoulderSolution solution = rhythm.Solve(typed.command());
  const SolveAdditions additions = ChosenAdditions(arguments);
  OutputFile out(arguments.out);
  out.Write(arguments.json ? PoseAsJson(rhythm, typed, solution, additions)
                           : PoseAsText(rhythm, typed, solution, additions));
  out.Commit();
}

void SolvePosture(const SolveArguments& arguments) {
  if (*arguments.posture != kRelaxedName) {
    throw InputError("--pose " + *arguments.posture +
                     ": not known. Choose one of: " + std::string(kRelaxedName));
  }
  if (arguments.elevation_deg || arguments.plane_deg || arguments.axial_deg ||
      !arguments.axial_from.empty() || arguments.shrug_deg || arguments.protraction_deg ||
      arguments.rates || !arguments.in.empty() || arguments.threads) {
    throw InputError("--pose says all of the arm. Leave the other options of the arm away");
  }
  const ShoulderPose pose = HangingIn(RelaxedStanding(), ChosenRhythm(arguments.rhythm));
  const SolveAdditions additions = ChosenAdditions(arguments);
  const JointAngles angles_rad = AnglesFromPose(pose);
  std::string text = "posture         " + *arguments.posture + "\n\n" + AnglesAsText(angles_rad);
  if (additions.points_of) {
    text += PointsAsText(*additions.points_of, pose);
  }
  if (arguments.json) {
    nlohmann::ordered_json json;
    json["posture"] = *arguments.posture;
    for (std::size_t k = 0; k < kCoordinateCount; ++k) {
      json["angles_deg"][std::string(kCoordinateNames[k])] = DegreesFromRadians(angles_rad[k]);
    }
    if (additions.points_of) {
      json[kLandmarksKey] = PointsAsJson(*additions.points_of, pose);
    }
    text = JsonText(json);
  }
  OutputFile out(arguments.out);
  out.Write(text);
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

// How the angles of a file are to be read.
AngleReading ChosenReading(const SolveArguments& arguments) {
  AngleReading reading = ReadingFrom(arguments.angles);
  reading.axial_from = ChosenAxialFrom(arguments);
  reading.must_have_axial = !arguments.axial_from.empty() && !arguments.axial_deg;
  reading.has_axial_option = arguments.axial_deg.has_value();
  return reading;
}

RowOptions ChosenRowOptions(const SolveArguments& arguments) {
  RowOptions options;
  options.threads = ChosenThreads(arguments.threads);
  options.shrug_deg = ShrugArgument(arguments);
  options.protraction_deg = ProtractionArgument(arguments);
  options.additions = ChosenAdditions(arguments);
  if (arguments.axial_deg) {
    options.axial_deg = AxialArgument_deg("--axial", *arguments.axial_deg);
  }
  options.reading = ChosenReading(arguments);
  return options;
}

void SolveFile(const RowSource& source, const SolveArguments& arguments) {
  const RowOptions options = ChosenRowOptions(arguments);
  SolveRows(source, arguments.out, ChosenRhythm(arguments.rhythm), options);
}

// As they were typed.
std::vector<double> SweptElevations_deg(const SolveArguments& arguments) {
  const std::string& text = Required("--elevation", arguments.elevation_deg);
  const std::vector<double> elevations_deg =
      IsSweep(text) ? SweepValues_deg(kSweptElevation, text, kMostSwept)
                    : std::vector{NumberArgument("--elevation", text)};
  for (const double elevation_deg : elevations_deg) {
    static_cast<void>(ReadElevation_deg(arguments, NumberText(elevation_deg)));
  }
  return elevations_deg;
}

std::vector<double> SweptPlanes_deg(const SolveArguments& arguments) {
  const std::string& text = Required("--plane", arguments.plane_deg);
  return IsSweep(text) ? SweepValues_deg(kSweptPlane, text, kMostSwept)
                       : std::vector{TypedPlane_deg(arguments)};
}

// All combinations of the elevations and planes given.
void SolveAllPositions(const SolveArguments& arguments) {
  ExpectNoUnit(arguments.angles);
  const SweptPositions sweep{SweptElevations_deg(arguments), SweptPlanes_deg(arguments)};
  const std::size_t positions = sweep.elevations_deg.size() * sweep.planes_deg.size();
  if (positions > kMostSwept) {
    throw InputError("--elevation and --plane make " + std::to_string(positions) +
                     " positions, at most " + std::to_string(kMostSwept) +
                     " are solved at once. Give larger steps, or a file with --in");
  }
  const RowOptions options = ChosenRowOptions(arguments);
  SolveSweep(sweep, arguments.out, ChosenRhythm(arguments.rhythm), options);
}

void Solve(const SolveArguments& arguments) {
  ExpectFilesApart({{"--out", arguments.out}}, {{"--in", arguments.in},
                                                {"--table", TableFile(arguments.rhythm.table)},
                                                {"--anatomy", arguments.anatomy.file},
                                                {"--thorax", arguments.anatomy.thorax}});
  if (arguments.posture) {
    SolvePosture(arguments);
    return;
  }
  if (arguments.rates) {
    ExpectRates(arguments.rhythm);
  }
  const bool one = arguments.elevation_deg.has_value() || arguments.plane_deg.has_value();
  if (one && !arguments.in.empty()) {
    throw InputError("--in and --elevation, --plane exclude each other. Give a file or one pose");
  }
  const auto sweeps = [](const std::optional<std::string>& text) { return text && IsSweep(*text); };
  if (sweeps(arguments.elevation_deg) || sweeps(arguments.plane_deg)) {
    if (arguments.json) {
      throw InputError(
          "--json is for one pose. With FROM:TO:STEP the output is CSV: leave --json away");
    }
    SolveAllPositions(arguments);
    return;
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
  std::error_code unknown_size;
  if (std::filesystem::is_regular_file(arguments.in, unknown_size)) {
    ExpectKnownUnit(arguments.in, ChosenReading(arguments));
  }
  std::ifstream in = OpenTextFile(arguments.in);
  const std::uintmax_t bytes = std::filesystem::file_size(arguments.in, unknown_size);
  SolveFile({in, arguments.in, unknown_size ? 0 : bytes}, arguments);
}

}  // namespace

void AddSolveCommand(CLI::App& program) {
  auto arguments = std::make_shared<SolveArguments>();
  arguments->out = "-";
  CLI::App* verb =
      program.add_subcommand("solve", "Joint angles for one arm position or a CSV of them");
  verb->add_option("--elevation", arguments->elevation_deg,
                   "Humeral elevation, 0 to 180; FROM:TO:STEP gives a CSV of them")
      ->type_name("DEG");
  verb->add_option("--plane", arguments->plane_deg,
                   "Plane of elevation, -95 to 135: 0 frontal, 40 scapular, 90 sagittal; or "
                   "FROM:TO:STEP")
      ->type_name("DEG");
  verb->add_option("--axial", arguments->axial_deg,
                   "Turn about the humerus's long axis on top of the measured one, or as "
                   "--axial-from says")
      ->type_name("DEG");
  AddAxialFromArgument(*verb, arguments->axial_from,
                       "What --axial or the column axial_deg is counted from (default rhythm; "
                       "isb with --convention isb)");
  AddConventionArgument(*verb, arguments->angles);
  AddUnitArgument(*verb, arguments->angles);
  verb->add_option("--shrug", arguments->shrug_deg,
                   "Clavicle raised beyond the rhythm, up to 35; down to -15")
      ->type_name("DEG");
  verb->add_option("--protraction", arguments->protraction_deg,
                   "Clavicle protracted beyond the rhythm, up to 30; back to -25")
      ->type_name("DEG");
  verb->add_option("--pose", arguments->posture, "A named posture instead: relaxed")
      ->type_name("NAME");
  verb->add_flag("--rates", arguments->rates,
                 "With derivatives by elevation and plane; needs the interpolation smooth");
  verb->add_flag("--landmarks", arguments->landmarks,
                 "With positions in the thorax in mm, x forward, y up, z to the right, from IJ: "
                 "elbow_x_mm and so on, also sc, pac, ts, ai, aa, pc, acj, gc, gh, em, el");
  verb->add_option(
          "--in", arguments->in,
          "CSV with the columns elevation_deg and plane_deg, optionally axial_deg, shrug_deg, "
          "protraction_deg; - for standard input")
      ->type_name("FILE");
  verb->add_option("--out", arguments->out, "Where to write; - for standard output (default)")
      ->type_name("FILE");
  verb->add_option("--threads", arguments->threads,
                   "How many threads solve a file, 1 to 64; as many as there are cores, 4 at most, "
                   "if not given. The output is the same")
      ->type_name("N");
  verb->add_flag("--json", arguments->json, "One pose as JSON");
  AddRhythmArguments(*verb, arguments->rhythm);
  AddAnatomyArguments(*verb, arguments->anatomy);
  verb->footer(
      "Examples:\n"
      "  girdle solve --elevation 23 --plane 50\n"
      "  girdle solve --elevation 0:180:1 --plane -95:135:5 --out map.csv\n"
      "  girdle solve --elevation 90 --plane 40 --landmarks --stature 1.85\n"
      "  girdle solve --in poses.csv --out angles.csv");
  verb->callback([arguments] { Solve(*arguments); });
}

}  // namespace girdle
