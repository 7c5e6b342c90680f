// SPDX-FileCopyrightText: 2026 The Girdle authors
// SPDX-License-Identifier: Apache-2.0

#include "commands/generate_command.h"

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "commands/output_file.h"
#include "commands/rhythm_arguments.h"
#include "commands/simulation_module.h"
#include "mjcf/scene.h"
#include "mjcf/shoulder_model.h"
#include "tables/built_in.h"
#include "tables/input_error.h"

namespace girdle {
namespace {

constexpr const char* kModelFile = "shoulder_right.xml";
constexpr const char* kSceneFile = "scene.xml";

struct GenerateArguments {
  RhythmArguments rhythm;
  std::string out;
  std::string plugin;
  bool json = false;
};

void Generate(const GenerateArguments& arguments) {
  const ShoulderRhythm rhythm = ChosenRhythm(arguments.rhythm);
  ShoulderModelOptions options;
  options.carries_table = !arguments.rhythm.table.empty();
  const std::filesystem::path folder(arguments.out);
  WriteFiles(folder, {{kModelFile, ShoulderModelXml(BuiltInAnatomy(), rhythm, options)},
                      {kSceneFile, SceneXml(kModelFile)}});
  const std::string model = (folder / kModelFile).string();
  const std::string scene = (folder / kSceneFile).string();
  // What MuJoCo does not accept is not a model.
  const std::string checked =
      HasSimulation() ? LoadSimulation().check_model(scene, ChosenPlugin(arguments.plugin))
                      : "not loaded: this program was built without MuJoCo";
  if (arguments.json) {
    nlohmann::ordered_json json;
    json["model"] = model;
    json["scene"] = scene;
    json["checked"] = checked;
    Print(json.dump(2) + "\n");
  } else {
    Print("model  " + model + "\nscene  " + scene + "\ncheck  " + checked + "\n");
  }
}

}  // namespace

void AddGenerateCommand(CLI::App& program) {
  auto arguments = std::make_shared<GenerateArguments>();
  CLI::App* verb = program.add_subcommand("generate", "The right shoulder as a MuJoCo model");
  verb->add_option("--out", arguments->out, "Folder for the model and its scene")
      ->type_name("DIR")
      ->required();
  AddRhythmArguments(*verb, arguments->rhythm);
  AddPluginArgument(*verb, arguments->plugin);
  verb->add_flag("--json", arguments->json, "Say what was written as JSON");
  verb->footer("Example:\n  girdle generate --out my_model");
  verb->callback([arguments] { Generate(*arguments); });
}

}  // namespace girdle
