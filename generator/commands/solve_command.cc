// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/solve_command.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
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
#include "commands/option_group.h"
#include "commands/output_file.h"
#include "commands/rhythm_arguments.h"
#include "commands/solve_answer.h"
#include "commands/solve_columns.h"
#include "commands/solve_rows.h"
#include "commands/table_arguments.h"
#include "commands/word_argument.h"
#include "motions/command_columns.h"
#include "names/model_names.h"
#include "text/input_error.h"
#include "text/near_names.h"
#include "text/number_text.h"
#include "text/text_file.h"

namespace girdle {
namespace {

constexpr std::size_t kMostThreads = 64;
// More threads would surprise other users of the machine.
constexpr std::size_t kMostThreadsUnasked = 4;

struct SolveArguments {
  RhythmArguments rhythm;
  AnatomyArguments anatomy;
  std::optional<std::string> elevation_deg;
  std::optional<std::string> plane_deg;
  std::optional<std::string> axial_deg;
  std::string axial_from;
  AngleArguments angles;
  TableArguments table;
  std::optional<std::string> shrug_deg;
  std::optional<std::string> protraction_deg;
  std::optional<std::string> posture;
  std::optional<std::string> threads;
  std::optional<std::string> digits;
  std::string form;
  std::string since;
  std::string in;
  std::string out;
  bool derivatives = false;
  bool landmarks = false;
  bool json = false;
};

// A million positions. A larger set belongs in a file.
constexpr std::uint64_t kMostSwept = 1'000'000;
constexpr SweptAngle kSweptElevation = {"--elevation", kWholeElevations, -kHalfCircle_deg,
                                        kHalfCircle_deg};
constexpr SweptAngle kSweptPlane = {"--plane", kWholePlanes, -kMostTurned_deg, kMostTurned_deg};

// Returns an offset within its bounds, if one is given.
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

// Without an axial turn, `--axial-from` has no meaning.
AxialFrom ChosenAxialFrom(const SolveArguments& arguments) {
  if (!arguments.axial_deg && arguments.in.empty()) {
    if (!arguments.axial_from.empty()) {
      throw InputError("--axial-from " + arguments.axial_from +
                       ": no axial turn is given. Add --axial, or omit --axial-from");
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

// Returns a typed elevation with Girdle's sign.
double ReadElevation_deg(const SolveArguments& arguments, const std::string& text) {
  return ElevationArgument_deg("--elevation", text, ReadingFrom(arguments.angles).convention,
                               arguments.axial_deg.has_value());
}

// Returns the plane as typed, with any whole turns.
double TypedPlane_deg(const SolveArguments& arguments) {
  const std::string& text = Required("--plane", arguments.plane_deg);
  static_cast<void>(PlaneArgument_deg("--plane", text));
  return NumberArgument("--plane", text);
}

// Returns the answer to the hanging arm, without axial turn and offsets.
ShoulderSolution HangingArm(const ShoulderRhythm& rhythm) {
  const ShoulderSolution hanging = rhythm.Solve({});
  if (hanging.clamped) {
    throw InputError(
        "--relative-to hanging: this rhythm does not reach the hanging arm. Omit --range clamp, "
        "--interpolation and --closure");
  }
  return hanging;
}

int ChosenDigits(const std::optional<std::string>& text) {
  if (!text) {
    return kDefaultDigits;
  }
  return static_cast<int>(
      WholeNumberArgument("--digits", *text, {.least = 0, .most = kMostDigits, .example = 3}));
}

SolveOutput ChosenOutput(const SolveArguments& arguments, const ShoulderRhythm& rhythm) {
  if (!arguments.landmarks && IsAnatomyChosen(arguments.anatomy)) {
    throw InputError(
        "the options of a body change no angle, only landmarks. Add --landmarks, or "
        "omit --anatomy, --ellipsoids and the measures");
  }
  SolveOutput output;
  ChooseWord("--as", arguments.form, output.form);
  if (!arguments.since.empty()) {
    if (arguments.since != kHangingName) {
      throw InputError("--relative-to " + arguments.since + ": not known. " +
                       DidYouMean(arguments.since, std::array{kHangingName}) + "Choose hanging");
    }
    if (arguments.derivatives) {
      throw InputError(
          "--derivatives and --relative-to: derivatives are of the angles from each joint's zero. "
          "Omit one of them");
    }
    const ShoulderSolution hanging = HangingArm(rhythm);
    output.since = hanging.pose;
    output.since_origin = hanging.origin;
  }
  output.digits = ChosenDigits(arguments.digits);
  output.derivatives = arguments.derivatives;
  if (arguments.landmarks) {
    output.points_of = ChosenAnatomy(arguments.anatomy);
  }
  return output;
}

void WriteTo(const std::string& path, const std::string& text) {
  OutputFile out(path);
  out.Write(text);
  out.Commit();
  NoteWritten(path);
}

void SolveOne(const SolveArguments& arguments) {
  ExpectNoUnit(arguments.angles);
  const std::string& elevation = Required("--elevation", arguments.elevation_deg);
  const TypedPosition typed = {ReadElevation_deg(arguments, elevation),
                               TypedPlane_deg(arguments),
                               AxialArgument_deg("--axial", arguments.axial_deg.value_or("0")),
                               ShrugArgument(arguments).value_or(0),
                               ProtractionArgument(arguments).value_or(0),
                               ChosenAxialFrom(arguments)};
  const ShoulderRhythm rhythm = ChosenRhythm(arguments.rhythm);
  const SolveOutput output = ChosenOutput(arguments, rhythm);
  WriteTo(arguments.out, arguments.json ? PositionAsJson(rhythm, typed, output)
                                        : PositionAsText(rhythm, typed, output));
}

void SolvePosture(const SolveArguments& arguments) {
  if (*arguments.posture != kRelaxedName) {
    throw InputError("--posture " + *arguments.posture + ": not known. " +
                     DidYouMean(*arguments.posture, std::array{kRelaxedName}) +
                     "Choose one of: " + std::string(kRelaxedName));
  }
  if (arguments.elevation_deg || arguments.plane_deg || arguments.axial_deg ||
      !arguments.axial_from.empty() || arguments.shrug_deg || arguments.protraction_deg ||
      !arguments.angles.convention.empty() || !arguments.angles.unit.empty() ||
      arguments.derivatives || !arguments.in.empty() || arguments.threads) {
    throw InputError("--posture gives the whole arm. Omit the other options of the arm");
  }
  const ShoulderRhythm rhythm = ChosenRhythm(arguments.rhythm);
  const ShoulderPose pose = HangingIn(RelaxedStanding(), rhythm);
  const SolveOutput output = ChosenOutput(arguments, rhythm);
  WriteTo(arguments.out, arguments.json ? PostureAsJson(*arguments.posture, pose, output)
                                        : PostureAsText(*arguments.posture, pose, output));
}

std::size_t ChosenThreads(const std::optional<std::string>& text) {
  if (!text) {
    // hardware_concurrency returns 0 if the number of cores is not known.
    return std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, kMostThreadsUnasked);
  }
  return WholeNumberArgument("--threads", *text, {.least = 1, .most = kMostThreads, .example = 2});
}

// Returns the unit and the convention of the angles in a file.
AngleReading ChosenReading(const SolveArguments& arguments) {
  AngleReading reading = ReadingFrom(arguments.angles);
  reading.axial_from = ChosenAxialFrom(arguments);
  reading.must_have_axial = !arguments.axial_from.empty() && !arguments.axial_deg;
  reading.has_axial_option = arguments.axial_deg.has_value();
  return reading;
}

RowOptions ChosenRowOptions(const SolveArguments& arguments, const ShoulderRhythm& rhythm) {
  RowOptions options;
  options.threads = ChosenThreads(arguments.threads);
  options.shrug_deg = ShrugArgument(arguments);
  options.protraction_deg = ProtractionArgument(arguments);
  options.output = ChosenOutput(arguments, rhythm);
  if (arguments.axial_deg) {
    options.axial_deg = AxialArgument_deg("--axial", *arguments.axial_deg);
  }
  options.reading = ChosenReading(arguments);
  options.columns = ChosenColumns(arguments.table, false);
  options.gaps = ChosenGaps(arguments.table, GapRule::kKeep);
  options.output.has_bridged = options.gaps.bridged_rows > 0;
  return options;
}

void SolveFile(const RowSource& source, const SolveArguments& arguments) {
  const ShoulderRhythm rhythm = ChosenRhythm(arguments.rhythm);
  SolveRows(source, arguments.out, rhythm, ChosenRowOptions(arguments, rhythm));
}

// Returns the elevations as typed.
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

// Solves all combinations of the elevations and planes given.
void SolveAllPositions(const SolveArguments& arguments) {
  ExpectNoUnit(arguments.angles);
  const SweptPositions sweep{SweptElevations_deg(arguments), SweptPlanes_deg(arguments)};
  const std::size_t positions = sweep.elevations_deg.size() * sweep.planes_deg.size();
  if (positions > kMostSwept) {
    throw InputError("--elevation and --plane make " + std::to_string(positions) +
                     " positions, at most " + std::to_string(kMostSwept) +
                     " are solved at once. Give larger steps, or a file with --in");
  }
  const ShoulderRhythm rhythm = ChosenRhythm(arguments.rhythm);
  SolveSweep(sweep, arguments.out, rhythm, ChosenRowOptions(arguments, rhythm));
}

void Solve(const SolveArguments& arguments) {
  ExpectFilesApart({{"--out", arguments.out}}, {{"--in", arguments.in},
                                                {"--table", TableFile(arguments.rhythm.table)},
                                                {"--anatomy", arguments.anatomy.file},
                                                {"--ellipsoids", arguments.anatomy.ellipsoids}});
  if (arguments.in.empty()) {
    ExpectNoTable(arguments.table);
  }
  if (arguments.posture) {
    SolvePosture(arguments);
    return;
  }
  if (arguments.derivatives) {
    ExpectDerivatives("--derivatives", arguments.rhythm);
  }
  const bool one = arguments.elevation_deg.has_value() || arguments.plane_deg.has_value();
  if (one && !arguments.in.empty()) {
    throw InputError("--in and --elevation, --plane exclude each other. Give a file or one pose");
  }
  const auto sweeps = [](const std::optional<std::string>& text) { return text && IsSweep(*text); };
  if (sweeps(arguments.elevation_deg) || sweeps(arguments.plane_deg)) {
    if (arguments.json) {
      throw InputError("--json is for one pose. With FROM:TO:STEP the output is CSV: omit --json");
    }
    SolveAllPositions(arguments);
    return;
  }
  if (one && arguments.threads) {
    throw InputError("--threads is for a file of poses. For one pose omit it");
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
    throw InputError("--json is for one pose. With --in the output is CSV: omit --json");
  }
  if (arguments.in == "-") {
    SolveFile({std::cin, "standard input", 0}, arguments);
    return;
  }
  std::error_code unknown_size;
  if (std::filesystem::is_regular_file(arguments.in, unknown_size)) {
    ExpectKnownUnit(arguments.in, ChosenReading(arguments), ChosenColumns(arguments.table, false));
  }
  std::ifstream in = OpenTextFile(arguments.in);
  const std::uintmax_t bytes = std::filesystem::file_size(arguments.in, unknown_size);
  SolveFile({in, arguments.in, unknown_size ? 0 : bytes}, arguments);
}

}  // namespace

void AddSolveCommand(CLI::App& program) {
  auto arguments = std::make_shared<SolveArguments>();
  arguments->out = "-";
  CLI::App* verb = program.add_subcommand(
      "solve", "Joint angles for one position of the arm, or for a CSV of them");
  {
    const OptionGroup group(*verb, "The arm");
    verb->add_option("--elevation", arguments->elevation_deg,
                     "Humeral elevation, 0 to 180; FROM:TO:STEP gives a CSV of them")
        ->type_name("DEG");
    verb->add_option("--plane", arguments->plane_deg,
                     "Plane of elevation, -95 to 135: 0 frontal, 40 scapular, 90 sagittal; or "
                     "FROM:TO:STEP")
        ->type_name("DEG");
    verb->add_option("--axial", arguments->axial_deg,
                     "Axial turn of the humerus, counted from where --axial-from says (default 0)")
        ->type_name("DEG");
    verb->add_option("--shrug", arguments->shrug_deg,
                     "Clavicle raised beyond the rhythm, -15 to 35 (default 0)")
        ->type_name("DEG");
    verb->add_option("--protraction", arguments->protraction_deg,
                     "Clavicle protracted beyond the rhythm, -25 to 30 (default 0)")
        ->type_name("DEG");
    verb->add_option("--in", arguments->in,
                     "CSV of positions with the columns elevation_deg and plane_deg, optionally "
                     "axial_deg, shrug_deg, protraction_deg; - for standard input")
        ->type_name("FILE");
    verb->add_option("--posture", arguments->posture,
                     "A measured posture in place of a position: relaxed (standing)")
        ->type_name("NAME");
    AddAxialFromArgument(*verb, arguments->axial_from,
                         "Zero of --axial and of the column axial_deg (default rhythm; isb with "
                         "--convention isb)");
    AddConventionArgument(*verb, arguments->angles);
    AddUnitArgument(*verb, arguments->angles);
    AddTableArguments(*verb, arguments->table, GapRule::kKeep);
  }
  {
    const OptionGroup group(*verb, "The answer");
    verb->add_option("--out", arguments->out, "File to write; - for standard output (default)")
        ->type_name("FILE");
    verb->add_option(
            "--as", arguments->form,
            "Rotations as degrees (default: sc_, ac_, gh_ of the joints, st_ of the "
            "scapula in the thorax) or as quaternions w, x, y, z (ht_ of the humerus in the "
            "thorax, too)")
        ->type_name("WORD");
    verb->add_option(
            "--relative-to", arguments->since,
            "hanging: every rotation is the turn since the arm was hanging, about the axes "
            "that the bone has there; needs a rhythm that is smooth, exact and whole")
        ->type_name("hanging");
    verb->add_option("--digits", arguments->digits,
                     "Most decimals of a number in CSV and text, 0 to 15 (default 6)")
        ->type_name("N");
    verb->add_flag("--landmarks", arguments->landmarks,
                   "With positions in the thorax in mm, x forward, y up, z to the right, from IJ: "
                   "elbow_x_mm and so on, also sc, pac, ts, ai, aa, pc, acj, gc, gh, em, el");
    verb->add_flag("--derivatives", arguments->derivatives,
                   "With derivatives by elevation and plane; needs the interpolation smooth");
    verb->add_flag("--json", arguments->json, "One position as JSON, with all digits");
    verb->add_option(
            "--threads", arguments->threads,
            "Threads that solve a file, 1 to 64 (default: the number of cores, 4 at most); "
            "the output does not depend on it")
        ->type_name("N");
  }
  AddRhythmArguments(*verb, arguments->rhythm);
  AddAnatomyArguments(*verb, arguments->anatomy);
  verb->footer(
      "\nExamples:\n"
      "  girdle solve --elevation 90 --plane 40\n"
      "  girdle solve --elevation 0:180:1 --plane -95:135:5 --out map.csv\n"
      "  girdle solve --elevation 90 --plane 40 --landmarks --stature 1.85\n"
      "  girdle solve --in poses.csv --out angles.csv");
  verb->callback([arguments] { Solve(*arguments); });
}

}  // namespace girdle
