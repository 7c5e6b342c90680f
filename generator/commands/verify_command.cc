// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/verify_command.h"

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "commands/anatomy_arguments.h"
#include "commands/angle_sweep.h"
#include "commands/exit_status.h"
#include "commands/option_group.h"
#include "commands/output_file.h"
#include "commands/progress.h"
#include "commands/rhythm_arguments.h"
#include "commands/simulation_module.h"
#include "commands/terminal.h"
#include "commands/word_argument.h"
#include "text/input_error.h"

namespace girdle {
namespace {

struct VerifyArguments {
  RhythmArguments rhythm;
  AnatomyArguments anatomy;
  std::string model;
  std::string plugin;
  std::string mapping;
  std::string elevation;
  std::string plane;
  std::string girdle;
  bool full = false;
  bool json = false;
};

// Default directions of the arm of a mapped model. Elevation: from the lowest at which a clavicle
// was measured to the highest that people reach. Plane: from somewhat behind the frontal plane to
// somewhat across the chest.
constexpr const char* kDefaultElevation = "30:150:10";
constexpr const char* kDefaultPlane = "-30:120:10";
constexpr SweptAngle kElevationSweep = {"--elevation", kDefaultElevation, 0, kHalfCircle_deg,
                                        kElevationsFromHanging};
constexpr SweptAngle kPlaneSweep = {"--plane", kDefaultPlane, -kHalfCircle_deg, kHalfCircle_deg};
// Most values of each angle. A finer grid gives no new information and takes minutes.
constexpr std::uint64_t kMostValues = 181;

ReportChoice ChosenForm(const VerifyArguments& arguments) {
  if (arguments.full && arguments.json) {
    throw InputError("--full and --json: --json has all lines already. Omit --full");
  }
  ReportChoice choice{arguments.full ? ReportForm::kFull : ReportForm::kSummary,
                      StyleOfStandardOutput()};
  if (arguments.json) {
    choice.form = ReportForm::kJson;
  } else if (arguments.full && !IsTerminal()) {
    // Each residual has one line, so that programs can search by line.
    choice.style.width = std::numeric_limits<std::size_t>::max();
  }
  return choice;
}

VerifyResult VerifyMapped(const VerifyArguments& arguments, TerminalProgress& progress) {
  if (IsAnatomyChosen(arguments.anatomy)) {
    throw InputError(
        "--anatomy, --ellipsoids and the sizes are for models of Girdle; with --mapping the bones "
        "are those of the model. Omit them");
  }
  const auto values_deg = [](const SweptAngle& angle, const std::string& given,
                             const char* otherwise) {
    return SweepValues_deg(angle, given.empty() ? otherwise : given, kMostValues);
  };
  return LoadSimulation().verify_mapped(
      {arguments.model, arguments.mapping,
       values_deg(kElevationSweep, arguments.elevation, kDefaultElevation),
       values_deg(kPlaneSweep, arguments.plane, kDefaultPlane)},
      ChosenPlugin(arguments.plugin), ChoiceFrom(arguments.rhythm), ChosenForm(arguments),
      std::ref(progress));
}

bool Verify(const VerifyArguments& arguments) {
  if (arguments.mapping.empty() && !(arguments.elevation.empty() && arguments.plane.empty())) {
    throw InputError(
        "--elevation and --plane are for models with --mapping; a model of Girdle is verified "
        "everywhere");
  }
  if (!arguments.mapping.empty() && !arguments.girdle.empty()) {
    throw InputError(
        "--girdle is for the skin of a model of Girdle; with --mapping there is none. Omit it");
  }
  GirdleMotion girdle = GirdleMotion::kMeasured;
  ChooseWord("--girdle", arguments.girdle, girdle);
  const std::optional<Anatomy> anatomy = IsAnatomyChosen(arguments.anatomy)
                                             ? std::optional(ChosenAnatomy(arguments.anatomy))
                                             : std::nullopt;
  TerminalProgress progress("verifying");
  const VerifyResult result =
      arguments.mapping.empty()
          ? LoadSimulation().verify(arguments.model, ChosenPlugin(arguments.plugin),
                                    ChoiceFrom(arguments.rhythm), anatomy, girdle,
                                    ChosenForm(arguments), std::ref(progress))
          : VerifyMapped(arguments, progress);
  progress.Clear();
  Print(result.report);
  return result.passed;
}

}  // namespace

void AddVerifyCommand(CLI::App& program, int& status) {
  auto arguments = std::make_shared<VerifyArguments>();
  CLI::App* verb = program.add_subcommand("verify", "The residual report of a model");
  verb->add_option("MODEL", arguments->model, "Model or scene, MJCF or MJB")
      ->type_name("MODEL")
      ->required();
  verb->add_flag("--full", arguments->full, "Every residual in place of a summary");
  verb->add_flag("--json", arguments->json, "Every residual as JSON");
  AddPluginArgument(*verb, arguments->plugin);
  verb->add_option(
          "--girdle", arguments->girdle,
          "Motion on which the skin of a model that has one is measured: measured (default), "
          "or frozen (clavicle and scapula stay where the skin was bound, the arm turns in "
          "GH alone); the residuals of the skin then fail")
      ->type_name("WORD");
  {
    const OptionGroup group(*verb, "A model that is not Girdle's");
    verb->add_option(
            "--mapping", arguments->mapping,
            "CSV that names the bodies or sites that are the model's bones, and the joints "
            "that set its arm, such as those in data/mappings")
        ->type_name("FILE");
    verb->add_option("--elevation", arguments->elevation,
                     std::string("Elevations to survey [deg], by default ") + kDefaultElevation)
        ->type_name("FROM:TO:STEP");
    verb->add_option("--plane", arguments->plane,
                     std::string("Planes to survey [deg], by default ") + kDefaultPlane)
        ->type_name("FROM:TO:STEP");
  }
  AddRhythmArguments(*verb, arguments->rhythm);
  AddAnatomyArguments(*verb, arguments->anatomy);
  verb->footer(
      "\nThe report compares the simulated bones of the model with the rhythm and the anatomy that "
      "the model names. --table, --interpolation, --closure, --range, --anatomy and so on name "
      "others: the report then says whether the model was made with those.\n"
      "With --mapping the report compares a model that is not Girdle's with the measured rhythm: "
      "how far its clavicle and scapula are from the measured ones while its arm is moved.\n"
      "Exit status 1 if a residual is outside its tolerance.\n"
      "\nExamples:\n  girdle verify scene.xml\n  girdle verify scene.xml --full\n"
      "  girdle verify scene.xml --girdle frozen\n"
      "  girdle verify arm.xml --mapping data/mappings/myo_sim.csv");
  verb->callback([arguments, &status] { status = Verify(*arguments) ? kFine : kAboveTolerance; });
}

}  // namespace girdle
