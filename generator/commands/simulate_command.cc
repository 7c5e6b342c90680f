// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/simulate_command.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>

#include "commands/angle_arguments.h"
#include "commands/named_files.h"
#include "commands/option_group.h"
#include "commands/output_file.h"
#include "commands/picture_arguments.h"
#include "commands/progress.h"
#include "commands/rhythm_arguments.h"
#include "commands/simulation_module.h"
#include "commands/table_arguments.h"
#include "commands/word_argument.h"
#include "kinematics/lengths.h"
#include "motions/motion.h"
#include "text/input_error.h"
#include "text/json_text.h"
#include "text/number_text.h"
#include "text/small_letters.h"

namespace girdle {
namespace {

struct SimulateArguments {
  std::string model;
  std::string plugin;
  std::optional<std::string> elevation;
  std::optional<std::string> plane;
  std::optional<std::string> seconds;
  std::optional<std::string> in;
  std::optional<std::string> longest;
  AngleArguments angles;
  TableArguments table;
  std::string out;
  std::string controls;
  std::string picture;
  std::string video;
  std::string frames_per_s;
  ViewArguments view;
  std::string side;
  std::string axial_from;
  RhythmArguments rhythm;
  bool json = false;
};

// Returns an elevation of `--elevation FROM:TO`.
double RaiseElevation(const SimulateArguments& arguments, const std::string& text) {
  const std::string option = "--elevation '" + *arguments.elevation + "': ";
  const AngleConvention convention = ReadingFrom(arguments.angles).convention;
  const std::optional<double> typed_deg = FiniteNumber(text);
  if (!typed_deg) {
    throw InputError(option + "'" + text +
                     "' is not a number. Give two elevations in degrees with a colon between, such "
                     "as 15:120");
  }
  try {
    return RadiansFromDegrees(ElevationRead_deg(*typed_deg, convention));
  } catch (const std::invalid_argument& error) {
    throw InputError(option + text + ": " + error.what() + ". Elevations such as " +
                     (convention == AngleConvention::kIsb ? "-15:-120" : "15:120") + " are read");
  }
}

// Returns the longest duration of a motion [s].
double LongestMotion_s(const SimulateArguments& arguments) {
  if (!arguments.longest) {
    return kLongestMotion_s;
  }
  const double longest_s = NumberArgument("--longest", *arguments.longest);
  if (longest_s <= 0 || longest_s > kLongestMotionAskedFor_s) {
    throw InputError("--longest " + *arguments.longest + ": expected more than 0 and at most " +
                     NumberText(kLongestMotionAskedFor_s) + " seconds, a year");
  }
  return longest_s;
}

MotionRequest Requested(const SimulateArguments& arguments) {
  if (arguments.elevation.has_value() == arguments.in.has_value()) {
    throw InputError(
        "a motion is needed, and only one. Give either --elevation FROM:TO, such as --elevation "
        "0:150, or --in FILE");
  }
  MotionRequest request;
  if (!arguments.side.empty()) {
    ChooseWord("--side", arguments.side, request.side.emplace());
  }
  request.axial_from = AxialFromOf(arguments.axial_from, arguments.angles);
  if (!arguments.axial_from.empty() && !arguments.in) {
    throw InputError(
        "--axial-from says how the column axial_deg of a motion is read. Give --in FILE, or omit "
        "it");
  }
  const double longest_s = LongestMotion_s(arguments);
  if (arguments.in) {
    if (arguments.plane || arguments.seconds) {
      throw InputError(
          "--plane and --seconds belong to --elevation; a motion has both. Omit them, or "
          "omit --in");
    }
    AngleReading reading = ReadingFrom(arguments.angles);
    reading.must_have_axial = !arguments.axial_from.empty();
    request.motion = MotionFile{*arguments.in,
                                {reading, longest_s, ChosenColumns(arguments.table, true),
                                 ChosenGaps(arguments.table, GapRule::kRefuse)}};
    return request;
  }
  ExpectNoTable(arguments.table);
  ExpectNoUnit(arguments.angles);
  const std::string& raise = *arguments.elevation;
  const std::size_t colon = raise.find(':');
  if (colon == std::string::npos) {
    throw InputError("--elevation " + raise +
                     ": a motion goes from one elevation to another. Give both, such as "
                     "--elevation 0:90");
  }
  const double plane_rad =
      RadiansFromDegrees(PlaneArgument_deg("--plane", arguments.plane.value_or("0")));
  ReachingRequest reaching;
  reaching.from = {RaiseElevation(arguments, raise.substr(0, colon)), plane_rad, 0};
  reaching.to = {RaiseElevation(arguments, raise.substr(colon + 1)), plane_rad, 0};
  reaching.duration_s = NumberArgument("--seconds", arguments.seconds.value_or("2"));
  if (reaching.duration_s <= 0 || reaching.duration_s > longest_s) {
    throw InputError("--seconds " + arguments.seconds.value_or("2") +
                     ": expected more than 0 and at most " + NumberText(longest_s) +
                     ". For a longer motion give --longest SECONDS");
  }
  request.motion = reaching;
  return request;
}

// Returns the request for pictures, without the receivers of the files.
PictureRequest RequestedPictures(const SimulateArguments& arguments) {
  if (arguments.picture.empty() && arguments.video.empty() && !arguments.view.empty()) {
    throw InputError(
        "--camera, --size and --show belong to a picture. Give --out-picture FILE.png or "
        "--out-video "
        "FILE.mp4");
  }
  if (arguments.video.empty() && !arguments.frames_per_s.empty()) {
    throw InputError("--fps " + arguments.frames_per_s +
                     ": there is no video. Give --out-video FILE.mp4, or omit --fps");
  }
  for (const char* const suffix : {".mp4", ".png"}) {
    if (InSmallLetters(arguments.out).ends_with(suffix)) {
      throw InputError(
          "--out " + arguments.out +
          ": the output is a CSV. Give --out-picture FILE.png or --out-video FILE.mp4");
    }
  }
  PictureRequest pictures;
  pictures.view = ChosenView(arguments.view);
  if (!arguments.picture.empty()) {
    ExpectSuffix("--out-picture", arguments.picture, ".png");
  }
  if (!arguments.video.empty()) {
    ExpectSuffix("--out-video", arguments.video, ".mp4");
  }
  if (!arguments.frames_per_s.empty()) {
    const double frames_per_s = NumberArgument("--fps", arguments.frames_per_s);
    if (frames_per_s != std::round(frames_per_s) || frames_per_s < kSlowestVideo_per_s ||
        frames_per_s > kFastestVideo_per_s) {
      throw InputError("--fps " + arguments.frames_per_s + ": expected a whole number, " +
                       std::to_string(kSlowestVideo_per_s) + " to " +
                       std::to_string(kFastestVideo_per_s));
    }
    pictures.frames_per_s = static_cast<int>(frames_per_s);
  }
  return pictures;
}

std::string SummaryAsJson(const SimulateArguments& arguments, const SimulationSummary& summary) {
  nlohmann::ordered_json json;
  json["model"] = arguments.model;
  const auto file = [](const std::string& name) {
    return name.empty() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(name);
  };
  json["out"] = file(arguments.out);
  json["out_controls"] = file(arguments.controls);
  json["out_picture"] = file(arguments.picture);
  json["out_video"] = file(arguments.video);
  json["frames"] = summary.frames;
  json["rows"] = summary.tally.rows;
  json["duration_s"] = summary.duration_s;
  json["clamped_rows"] = summary.tally.clamped;
  json["derived_rows"] = summary.tally.derived;
  json["modelled_rows"] = summary.tally.modelled;
  json["gap_rows"] = summary.tally.gaps;
  json["bridged_rows"] = summary.tally.bridged;
  json["worst_distance_deg"] = DegreesFromRadians(summary.tally.farthest_rad);
  json["worst_tracking_error_deg"] = summary.worst_error_deg;
  json["last_tracking_error_deg"] = summary.last_error_deg;
  json["loop_gaps_mm"] = nlohmann::ordered_json::object();
  for (const LoopGap& loop : summary.loop_gaps) {
    json["loop_gaps_mm"][loop.name] = loop.gap_m * kMillimetersPerMeter;
  }
  return JsonText(json);
}

std::string LoopGapsAsText(const SimulationSummary& summary) {
  constexpr int kDecimals = 3;
  std::string text;
  for (const LoopGap& loop : summary.loop_gaps) {
    text += "loop " + loop.name + " open by at most " +
            RoundedText(loop.gap_m * kMillimetersPerMeter, kDecimals) + " mm\n";
  }
  return text;
}

std::string SummaryAsText(const SimulationSummary& summary) {
  constexpr int kDecimals = 3;
  const CommandTally& tally = summary.tally;
  return "simulated " + RoundedText(summary.duration_s, kDecimals) + " s in " +
         CountText(tally.rows, "state") + "; joints at most " +
         RoundedText(summary.worst_error_deg, kDecimals) + " deg off their targets, " +
         RoundedText(summary.last_error_deg, kDecimals) + " at the end\n" +
         (tally.clamped > 0 ? CountText(tally.clamped, "command") +
                                  " lay outside the rhythm's or the controls' ranges; another pose "
                                  "was used\n"
                            : "") +
         (tally.modelled > 0
              ? "up to " + RoundedText(DegreesFromRadians(tally.farthest_rad), kDecimals) +
                    " deg from measured positions: modelled, not measured\n"
              : "") +
         LoopGapsAsText(summary);
}

void NoteFilesWritten(const SimulateArguments& arguments, const SimulationSummary& summary) {
  const std::string rows = CountText(summary.tally.rows, "row");
  NoteWritten(arguments.out, rows);
  NoteWritten(arguments.controls, rows);
  NoteWritten(arguments.picture);
  NoteWritten(arguments.video, CountText(static_cast<std::uintmax_t>(summary.frames), "frame"));
}

void Simulate(const SimulateArguments& arguments) {
  const MotionRequest request = Requested(arguments);
  if (arguments.json && arguments.out == "-") {
    throw InputError("--json and --out - both write to standard output. Give --out a file");
  }
  if (arguments.controls == "-" && (arguments.json || arguments.out == "-")) {
    throw InputError(
        "--out-controls - and another output both write to standard output. Give one of them a "
        "file");
  }
  std::vector<NamedFile> read = ModelFiles(arguments.model);
  read.insert(read.end(), {{"--in", arguments.in.value_or("")},
                           {"--table", TableFile(arguments.rhythm.table)},
                           {"--plugin", arguments.plugin}});
  ExpectFilesApart({{"--out", arguments.out},
                    {"--out-controls", arguments.controls},
                    {"--out-picture", arguments.picture},
                    {"--out-video", arguments.video}},
                   read);
  PictureRequest pictures = RequestedPictures(arguments);
  const SimulationModule& simulation = LoadSimulation();
  std::optional<OutputFile> trace;
  if (!arguments.out.empty()) {
    trace.emplace(arguments.out);
  }
  std::optional<OutputFile> controls;
  if (!arguments.controls.empty()) {
    controls.emplace(arguments.controls);
  }
  std::optional<OutputFile> picture;
  if (!arguments.picture.empty()) {
    picture.emplace(arguments.picture);
  }
  std::optional<OutputFile> video;
  if (!arguments.video.empty()) {
    video.emplace(arguments.video);
    pictures.video = video->Descriptor();
  }
  const auto into = [](std::optional<OutputFile>& file) {
    return [&file](std::string_view text) {
      if (file) {
        file->Write(text);
      }
    };
  };
  const bool prints_table = arguments.out == "-" || arguments.controls == "-";
  if (picture) {
    pictures.png = into(picture);
  }
  const auto expect_room = [&](std::uintmax_t trace_bytes, std::uintmax_t controls_bytes) {
    // Trace and controls may be on one disk.
    const std::uintmax_t bytes = (trace ? trace_bytes : 0) + (controls ? controls_bytes : 0);
    ExpectRoom("--out", arguments.out, bytes);
    ExpectRoom("--out-controls", arguments.controls, bytes);
  };
  TerminalProgress progress("simulating", !prints_table);
  const SimulationSummary summary = simulation.simulate(
      arguments.model, ChosenPlugin(arguments.plugin), request, ChoiceFrom(arguments.rhythm),
      {expect_room, into(trace), controls ? TextSink(into(controls)) : nullptr, PrintNote},
      pictures, std::ref(progress));
  progress.Clear();
  for (std::optional<OutputFile>* const file : {&trace, &controls, &picture, &video}) {
    if (*file) {
      (*file)->Commit();
    }
  }
  if (arguments.in) {
    PrintNote(*arguments.in + ": " +
              TallyText(summary.tally, {summary.range, "simulated state", !arguments.out.empty(),
                                        summary.axial_from}));
  }
  NoteFilesWritten(arguments, summary);
  if (prints_table) {
    return;  // the table is the output
  }
  if (arguments.json) {
    Print(SummaryAsJson(arguments, summary));
    return;
  }
  Print(SummaryAsText(summary));
}

}  // namespace

void AddSimulateCommand(CLI::App& program) {
  auto arguments = std::make_shared<SimulateArguments>();
  CLI::App* verb = program.add_subcommand(
      "simulate", "Move a model's arm without a screen and write its joints");
  verb->add_option("MODEL", arguments->model, "Model or scene, MJCF or MJB")
      ->type_name("MODEL")
      ->required();
  {
    const OptionGroup group(*verb, "The motion");
    verb->add_option("--elevation", arguments->elevation,
                     "Move the arm from one elevation to another")
        ->type_name("FROM:TO");
    verb->add_option("--plane", arguments->plane, "Plane of --elevation (default 0)")
        ->type_name("DEG");
    verb->add_option("--seconds", arguments->seconds, "Duration of --elevation (default 2)")
        ->type_name("S");
    verb->add_option(
            "--in", arguments->in,
            "Motion in place of --elevation: a CSV with the columns time_s, elevation_deg, "
            "plane_deg and optionally axial_deg, shrug_deg, protraction_deg; the simulation "
            "starts at its first time")
        ->type_name("FILE");
    verb->add_option("--longest", arguments->longest,
                     "Longest motion that is accepted (default 3600)")
        ->type_name("S");
    AddConventionArgument(*verb, arguments->angles);
    AddUnitArgument(*verb, arguments->angles);
    AddTableArguments(*verb, arguments->table, GapRule::kRefuse);
    AddAxialFromArgument(*verb, arguments->axial_from,
                         "Zero of the column axial_deg of --in (default: the model's; isb with "
                         "--convention isb)");
  }
  {
    const OptionGroup group(*verb, "Outputs");
    verb->add_option("--out", arguments->out,
                     "CSV to write: commands, targets and joint angles, one row for each step; - "
                     "for standard "
                     "output")
        ->type_name("FILE");
    verb->add_option("--side", arguments->side,
                     "Shoulder that --out is of (default: the model's, or the right one of both)")
        ->type_name("right|left");
    verb->add_option("--out-controls", arguments->controls,
                     "CSV to write: the controls of position servos, one row for each step, for a "
                     "model made "
                     "with --actuation position; - for standard output")
        ->type_name("FILE");
    verb->add_option("--out-picture", arguments->picture, "PNG to write: the last instant")
        ->type_name("FILE");
    verb->add_option("--out-video", arguments->video,
                     "MP4 to write: the motion in real time; needs the program ffmpeg")
        ->type_name("FILE");
    verb->add_option("--fps", arguments->frames_per_s, "Frames of the video a second (default 30)")
        ->type_name("N");
    verb->add_flag("--json", arguments->json, "Summary as JSON");
  }
  AddViewArguments(*verb, arguments->view);
  AddRhythmArguments(*verb, arguments->rhythm);
  AddPluginArgument(*verb, arguments->plugin);
  verb->footer(
      kPicturesHelp +
      std::string("\nExamples:\n"
                  "  girdle simulate scene.xml --elevation 0:150 --plane 0 --out raise.csv\n"
                  "  girdle simulate scene.xml --in motion.csv --out-video motion.mp4"));
  verb->callback([arguments] { Simulate(*arguments); });
}

}  // namespace girdle
