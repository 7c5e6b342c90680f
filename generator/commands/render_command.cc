// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/render_command.h"

#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include "commands/output_file.h"
#include "commands/picture_arguments.h"
#include "commands/rhythm_arguments.h"
#include "commands/simulation_module.h"
#include "commands/word_argument.h"
#include "text/input_error.h"

namespace girdle {
namespace {

struct RenderArguments {
  std::string model;
  std::string out;
  std::string keyframe;
  std::string elevation;
  std::string plane;
  std::string girdle;
  std::string side;
  ViewArguments view;
  RhythmArguments rhythm;
  std::string plugin;
};

double Direction_rad(const std::string& option, const std::string& text) {
  const double angle_deg = NumberArgument(option, text);
  if (std::abs(angle_deg) > kFullCircle_deg) {
    throw InputError(option + " " + text + ": expected degrees within -360 to 360");
  }
  return RadiansFromDegrees(angle_deg);
}

RenderRequest Requested(const RenderArguments& arguments) {
  RenderRequest request;
  request.pose = AtKeyframe{arguments.keyframe};
  if (!arguments.keyframe.empty() && !(arguments.elevation.empty() && arguments.plane.empty())) {
    throw InputError(
        "which pose? Give either --keyframe, or --elevation and --plane, and leave the other away");
  }
  if (arguments.elevation.empty() && !arguments.plane.empty()) {
    throw InputError("--plane " + arguments.plane +
                     ": of which elevation? Give --elevation DEG as well");
  }
  if (!arguments.elevation.empty()) {
    request.pose =
        ArmCommand{Direction_rad("--elevation", arguments.elevation),
                   arguments.plane.empty() ? 0 : Direction_rad("--plane", arguments.plane)};
  }
  ChooseWord("--girdle", arguments.girdle, request.girdle);
  if (!arguments.side.empty()) {
    if (arguments.elevation.empty() && request.girdle == GirdleMotion::kMeasured) {
      throw InputError("--side " + arguments.side +
                       ": a keyframe is one of the whole model. Give --elevation as well, or leave "
                       "--side away");
    }
    ChooseWord("--side", arguments.side, request.side.emplace());
  }
  request.view = ChosenView(arguments.view);
  return request;
}

void Render(const RenderArguments& arguments) {
  const RenderRequest request = Requested(arguments);
  ExpectSuffix("--out", arguments.out, ".png");
  const SimulationModule& simulation = LoadSimulation();
  OutputFile out(arguments.out);
  const RenderResult result = simulation.render(arguments.model, ChosenPlugin(arguments.plugin),
                                                request, ChoiceFrom(arguments.rhythm));
  out.Write(result.png);
  out.Commit();
  Print((result.clamped
             ? "the direction lies outside the rhythm's range; the nearest pose was used\n"
             : "") +
        std::string("picture  ") + arguments.out + "\n");
}

}  // namespace

void AddRenderCommand(CLI::App& program) {
  auto arguments = std::make_shared<RenderArguments>();
  CLI::App* verb = program.add_subcommand("render", "A picture of a model in a pose, as PNG");
  verb->add_option("model", arguments->model, "Model or scene, MJCF or MJB")
      ->type_name("MODEL")
      ->required();
  verb->add_option("--out", arguments->out, "PNG to write")->type_name("FILE")->required();
  verb->add_option("--keyframe", arguments->keyframe,
                   "Keyframe of the model to show (default: rest, if it has one)")
      ->type_name("NAME");
  verb->add_option("--elevation", arguments->elevation,
                   "Put the arms where the rhythm has them at this elevation, without simulating")
      ->type_name("DEG");
  verb->add_option("--plane", arguments->plane, "... and in this plane (default 0)")
      ->type_name("DEG");
  verb->add_option("--girdle", arguments->girdle,
                   "measured (default), or frozen: clavicle and scapula stay where the skin was "
                   "bound (without a skin: at rest) and the arm turns in GH alone, to where it "
                   "points")
      ->type_name("WORD");
  verb->add_option("--side", arguments->side,
                   "Which shoulder is raised or frozen while the other one rests (default: all)")
      ->type_name("right|left");
  AddViewArguments(*verb, arguments->view);
  AddRhythmArguments(*verb, arguments->rhythm);
  AddPluginArgument(*verb, arguments->plugin);
  verb->footer(std::string("Any model can be drawn at its keyframes; the rest is for those of "
                           "Girdle.\n") +
               kPicturesHelp +
               "Examples:\n"
               "  girdle render scene.xml --keyframe abduction_90 --out abduction.png\n"
               "  girdle render scene.xml --elevation 120 --girdle frozen --camera back --out "
               "frozen.png");
  verb->callback([arguments] { Render(*arguments); });
}

}  // namespace girdle
