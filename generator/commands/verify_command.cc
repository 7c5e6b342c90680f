// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/verify_command.h"

#include <functional>
#include <memory>
#include <string>

#include "commands/anatomy_arguments.h"
#include "commands/output_file.h"
#include "commands/progress.h"
#include "commands/rhythm_arguments.h"
#include "commands/simulation_module.h"

namespace girdle {
namespace {

struct VerifyArguments {
  RhythmArguments rhythm;
  AnatomyArguments anatomy;
  std::string model;
  std::string plugin;
  bool json = false;
};

bool Verify(const VerifyArguments& arguments) {
  const Anatomy anatomy = ChosenAnatomy(arguments.anatomy);
  TerminalProgress progress("verifying");
  const VerifyResult result = LoadSimulation().verify(
      arguments.model, ChosenPlugin(arguments.plugin), OverrideFrom(arguments.rhythm), anatomy,
      arguments.json, std::ref(progress));
  progress.Clear();
  Print(result.report);
  return result.passed;
}

}  // namespace

void AddVerifyCommand(CLI::App& program, int& status) {
  auto arguments = std::make_shared<VerifyArguments>();
  CLI::App* verb = program.add_subcommand("verify", "The residual report of a model");
  verb->add_option("model", arguments->model, "Model or scene, MJCF or MJB")
      ->type_name("MODEL")
      ->required();
  AddRhythmArguments(*verb, arguments->rhythm);
  AddAnatomyArguments(*verb, arguments->anatomy);
  AddPluginArgument(*verb, arguments->plugin);
  verb->add_flag("--json", arguments->json, "The report as JSON");
  verb->footer(
      "The model is held against the rhythm that it says it uses. With --table, --interpolation or "
      "--closure it is held\nagainst that instead, and fails if it was made with another.\n"
      "Exit status 1 if a residual is above its tolerance.\n"
      "Example:\n  girdle verify scene.xml");
  verb->callback([arguments, &status] { status = Verify(*arguments) ? 0 : 1; });
}

}  // namespace girdle
