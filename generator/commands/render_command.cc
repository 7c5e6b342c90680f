// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/render_command.h"

#include <memory>
#include <optional>
#include <string>

#include "commands/angle_arguments.h"
#include "commands/named_files.h"
#include "commands/output_file.h"
#include "commands/picture_arguments.h"
#include "commands/rhythm_arguments.h"
#include "commands/simulation_module.h"
#include "commands/word_argument.h"
#include "text/input_error.h"
#include "text/number_text.h"

namespace girdle {
namespace {

struct RenderArguments {
  std::string model;
  std::string out;
  std::string keyframe;
  std::string elevation;
  std::string plane;
  AngleArguments angles;
  std::string girdle;
  std::string side;
  ViewArguments view;
  RhythmArguments rhythm;
  std::string plugin;
};

RenderRequest Requested(const RenderArguments& arguments) {
  RenderRequest request;
  request.pose = AtKeyframe{arguments.keyframe};
  if (!arguments.keyframe.empty() && !(arguments.elevation.empty() && arguments.plane.empty())) {
    throw InputError(
        "which pose? Give either --keyframe, or --elevation and --plane, and omit the other");
  }
  if (arguments.elevation.empty() && !arguments.plane.empty()) {
    throw InputError("--plane " + arguments.plane + ": no elevation is given. Add --elevation DEG");
  }
  if (!arguments.elevation.empty()) {
    const double elevation_deg = ElevationArgument_deg("--elevation", arguments.elevation,
                                                       ReadingFrom(arguments.angles).convention);
    const double plane_deg =
        arguments.plane.empty() ? 0 : PlaneArgument_deg("--plane", arguments.plane);
    request.pose = ArmCommand{RadiansFromDegrees(elevation_deg), RadiansFromDegrees(plane_deg)};
  } else if (!arguments.angles.convention.empty()) {
    throw InputError("--convention " + arguments.angles.convention +
                     ": no elevation is given. Add --elevation DEG");
  }
  const std::string shows_keyframe =
      arguments.keyframe.empty()
          ? "the picture shows a keyframe. Omit this option, or give --elevation DEG"
          : "a keyframe has its own pose. Omit this option, or give --elevation DEG in place of "
            "--keyframe";
  ChooseWord("--girdle", arguments.girdle, request.girdle);
  if (arguments.elevation.empty() && request.girdle == GirdleMotion::kMeasured) {
    ExpectNoRhythm(arguments.rhythm, shows_keyframe);
  }
  if (!arguments.side.empty()) {
    if (arguments.elevation.empty() && request.girdle == GirdleMotion::kMeasured) {
      throw InputError(
          "--side " + arguments.side +
          ": a keyframe is one of the whole model. Omit --side, or give --elevation in "
          "place of a keyframe");
    }
    ChooseWord("--side", arguments.side, request.side.emplace());
  }
  request.view = ChosenView(arguments.view);
  return request;
}

// Returns a line on the direction that is shown, if it differs from the command.
std::string UsedText(const RenderResult& result) {
  if (!result.used_instead) {
    return "";
  }
  constexpr int kDecimals = 3;
  return "the direction lies outside the rhythm's range; shown instead: elevation " +
         RoundedText(DegreesFromRadians(result.used_instead->elevation_rad), kDecimals) +
         ", plane " + RoundedText(DegreesFromRadians(result.used_instead->plane_rad), kDecimals) +
         "\n";
}

void Render(const RenderArguments& arguments) {
  const RenderRequest request = Requested(arguments);
  ExpectSuffix("--out", arguments.out, ".png");
  std::vector<NamedFile> read = ModelFiles(arguments.model);
  read.insert(read.end(),
              {{"--table", TableFile(arguments.rhythm.table)}, {"--plugin", arguments.plugin}});
  ExpectFilesApart({{"--out", arguments.out}}, read);
  const SimulationModule& simulation = LoadSimulation();
  OutputFile out(arguments.out);
  const RenderResult result = simulation.render(arguments.model, ChosenPlugin(arguments.plugin),
                                                request, ChoiceFrom(arguments.rhythm));
  out.Write(result.png);
  out.Commit();
  Print(UsedText(result));
  NoteWritten(arguments.out);
}

}  // namespace

void AddRenderCommand(CLI::App& program) {
  auto arguments = std::make_shared<RenderArguments>();
  CLI::App* verb = program.add_subcommand("render", "A picture of a model in a pose, as PNG");
  verb->add_option("MODEL", arguments->model, "Model or scene, MJCF or MJB")
      ->type_name("MODEL")
      ->required();
  verb->add_option("--out", arguments->out, "PNG to write")->type_name("FILE")->required();
  verb->add_option("--keyframe", arguments->keyframe,
                   "Keyframe of the model to show (default: hanging, if it has one)")
      ->type_name("NAME");
  verb->add_option("--elevation", arguments->elevation,
                   "Put the arms where the rhythm has them at this elevation, without simulation")
      ->type_name("DEG");
  verb->add_option("--plane", arguments->plane, "Plane of --elevation (default 0)")
      ->type_name("DEG");
  AddConventionArgument(*verb, arguments->angles);
  verb->add_option("--girdle", arguments->girdle,
                   "measured (default), or frozen: clavicle and scapula stay where the skin was "
                   "bound (without a skin: as in keyframe hanging) and the arm turns in GH alone, "
                   "to where it "
                   "points")
      ->type_name("WORD");
  verb->add_option("--side", arguments->side,
                   "Which shoulder is raised or frozen while the other one rests (default: all)")
      ->type_name("right|left");
  AddViewArguments(*verb, arguments->view);
  AddRhythmArguments(*verb, arguments->rhythm);
  AddPluginArgument(*verb, arguments->plugin);
  verb->footer(std::string("\nAny model can be drawn at its keyframes. --elevation, --girdle and "
                           "--side are for models of Girdle.\n") +
               kPicturesHelp +
               "\nExamples:\n"
               "  girdle render scene.xml --keyframe abduction_90 --out abduction.png\n"
               "  girdle render scene.xml --elevation 120 --camera back --out raised.png");
  verb->callback([arguments] { Render(*arguments); });
}

}  // namespace girdle
